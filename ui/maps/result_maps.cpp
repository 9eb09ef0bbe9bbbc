#include "ui/maps/result_maps.h"

#include "core/analysis/estimated_map.h"
#include "core/analysis/map_pictures.h"
#include "core/analysis/map_usage.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/job/memory.h"

#include <utility>

namespace texloom::ui {

namespace {

/// More marks than this hide the picture, and each other.
constexpr std::size_t kMostMarks = 500;

void checkMemory(const Message& what, std::uint64_t bytes) {
    if (const std::uint64_t free = availableMemory(); bytes > free)
        fail("{} takes {}, of which only {} are free; make a smaller result.", what, byteText(bytes),
             byteText(free));
}

RunPictures withEstimate(RunPictures pictures, JobContext& context) {
    const Result& result = *pictures.run;
    const Image& image = result.synthesis.image;
    std::vector<PatchSource> sources;
    std::vector<Size> sizes;
    for (const Exemplar& exemplar : result.plan.request.exemplars) {
        sources.push_back({exemplar.image->view().channelRange(0, image.channels()),
                           exemplar.mask() ? exemplar.mask()->view().plane(0) : PlaneView{}});
        sizes.push_back(exemplar.image->size());
    }
    checkMemory(TR("Estimating the map"), estimatedMapBytes(image.size(), sizes, image.channels()));
    const Wrap wrap = result.plan.request.region ? Wrap{} : result.plan.request.wrap;
    context.stage(1, TR("Estimating the map"));
    pictures.map = std::make_shared<const PositionMap>(estimatedMap(image, sources, wrap, context));
    pictures.mapKind = MapKind::Estimated;
    pictures.synthesis = std::make_shared<const DisplayPicture>(
        std::make_shared<const Image>(synthesisPicture(*pictures.map)));
    return pictures;
}

} // namespace

void ResultMaps::follow(const RunPictures& pictures) {
    cancel();
    m_copying.cancel();
    m_indexing.cancel();
    m_pictures = pictures;
    m_copies.reset();
    m_index.reset();
}

bool ResultMaps::canEstimate() const {
    return m_pictures.run && !m_pictures.map && knowsExemplars(*m_pictures.run);
}

void ResultMaps::estimate() {
    if (!canEstimate() || estimating())
        return;
    m_estimation.start(
        {}, [pictures = m_pictures](JobContext& context) { return withEstimate(pictures, context); },
        [this](const RunPictures& pictures) {
            m_pictures = pictures;
            Q_EMIT estimated();
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void ResultMaps::cancel() {
    m_estimation.cancel();
}

const std::optional<ResultMaps::Copies>& ResultMaps::copies() {
    if (m_copies || !m_pictures.map || m_copying.running())
        return m_copies;
    m_copying.start(
        {},
        [map = m_pictures.map, size = m_pictures.result->size(),
         step = m_pictures.step](JobContext& context) {
            Copies copies;
            copies.largest = largestVerbatimRegion(*map, [&] { context.check(); });
            auto picture = std::make_shared<const Image>(copiedRegionsPicture(*map));
            copies.picture = std::make_shared<const DisplayPicture>(std::move(picture), size, step, nullptr);
            return copies;
        },
        [this](Copies copies) {
            m_copies = std::move(copies);
            Q_EMIT copiesChanged();
        },
        [this](const QString& why) { Q_EMIT failed(why); });
    return m_copies;
}

std::vector<QPoint> ResultMaps::copiesOf(const Source& source) {
    std::vector<QPoint> points;
    if (m_index)
        for (const CopyIndex::Place& place : m_index->copiesOf(source, kMostMarks))
            points.emplace_back(place.x, place.y);
    if (m_index || !m_pictures.run || !m_pictures.map || m_indexing.running())
        return points;
    m_indexing.start(
        {},
        [map = m_pictures.map](JobContext& context) {
            return Indexed{std::make_unique<CopyIndex>(*map, 1 << 21, [&] { context.check(); })};
        },
        [this](Indexed indexed) { m_index = std::move(indexed.index); },
        [this](const QString& why) { Q_EMIT failed(why); });
    return points;
}

} // namespace texloom::ui
