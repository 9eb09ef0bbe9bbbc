#include "tests/methods/made_up_ports.h"

#include "core/job/job.h"
#include "core/volume/mesh.h"
#include "core/volume/volume_source.h"
#include "tests/support/textures.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace texloom::test {
namespace {

/// A made-up picture that tiles, as inputs of outputs that wrap must; a large one repeats itself.
std::shared_ptr<const Image> mirroredBlobs(Size size, int channels) {
    constexpr int kMost = 256;
    const Image part =
        blobs({std::min(kMost, (size.width + 1) / 2), std::min(kMost, (size.height + 1) / 2)}, channels, 3);
    Image whole(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                whole(x, y, c) = part(std::min(x, size.width - 1 - x) % part.width(),
                                      std::min(y, size.height - 1 - y) % part.height(), c);
    return std::make_shared<const Image>(std::move(whole));
}

/// A model for a port, as another method makes it of the same exemplar.
Asset modelFor(const Port& port, const Request& like) {
    for (const Method& maker : methods()) {
        const Port* const given = maker.info().output(port.id);
        if (!given || given->kind != AssetKind::Model)
            continue;
        Request request;
        request.exemplars = {like.exemplars.front()};
        request.exemplars.front().inputs = {};
        request.size = request.exemplars.front().image->size();
        const Values settings = maker.resolved({}, request.size);
        Job<Synthesis> job({}, [&](JobContext& context) { return maker.run(request, settings, context); });
        return std::get<Synthesis>(job.take()).outputs.at(port.id).front();
    }
    throw std::runtime_error("no method makes a model for the port " + port.id);
}

Asset madeUpVolume(int channels) {
    Volume volume({6, 5, 4}, channels);
    const Image image = blobs({6, 5}, channels);
    for (int c = 0; c < channels; ++c)
        for (int z = 0; z < volume.depth(); ++z)
            for (int y = 0; y < volume.height(); ++y)
                std::copy_n(image.plane(c).row(y), volume.width(), volume.row(y, z, c));
    return std::make_shared<const DenseSource>(std::move(volume), DenseSource::Edge::Repeats);
}

Asset triangle() {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh->normals.assign(3, Eigen::Vector3f::UnitZ());
    mesh->triangles = {{0, 1, 2}};
    return std::shared_ptr<const Mesh>(mesh);
}

/// Repeats the first exemplar.
Asset repeatedMap(Size size, std::vector<Size> exemplars) {
    const Size own = exemplars.front();
    auto map = std::make_shared<PositionMap>(size, std::move(exemplars));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            map->at(x, y) = {static_cast<std::uint16_t>(x % own.width),
                             static_cast<std::uint16_t>(y % own.height), 0};
    return std::shared_ptr<const PositionMap>(map);
}

/// Something made up for a port. @param size of pictures.
Asset madeUp(const Port& port, Size size, const Request& request) {
    switch (port.kind) {
    case AssetKind::Image:
        break;
    case AssetKind::Mask:
        return std::make_shared<const Image>(constant(size, 1, 1));
    case AssetKind::Map:
        return repeatedMap(size, request.exemplarSizes());
    case AssetKind::Model:
        return modelFor(port, request);
    case AssetKind::Volume:
        return madeUpVolume(request.channels());
    case AssetKind::Mesh:
        return triangle();
    }
    return mirroredBlobs(size, request.channels());
}

} // namespace

void fillPorts(const MethodInfo& info, Request& request) {
    for (const Port& port : info.takes) {
        if (port.least == 0 || port.id == kExemplarPort)
            continue;
        for (Exemplar& exemplar : request.exemplars)
            if (port.extent == Extent::Exemplar && exemplar.inputs.at(port.id).empty())
                exemplar.inputs.set(port.id, madeUp(port, exemplar.image->size(), request));
        if (port.extent != Extent::Exemplar && request.inputs.at(port.id).empty())
            request.inputs.set(port.id, madeUp(port, request.size, request));
    }
    if (!info.takesExemplars())
        request.exemplars.clear();
}

} // namespace texloom::test
