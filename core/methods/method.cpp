#include "core/methods/method.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/channel_text.h"
#include "core/io/model_file.h"

#include <algorithm>
#include <array>

namespace texloom {

namespace {

Message idsOf(const std::vector<Port>& ports) {
    std::vector<std::string> ids;
    for (const Port& port : ports)
        ids.push_back(port.id);
    return listOf(ids);
}

/// A picture of a port has the size that the port's extent wants, if it is there yet: what the method before
/// makes is not while a run is planned.
void checkExtent(const Port& port, const Asset& asset, Size size, const Message& like) {
    const auto* image = std::get_if<std::shared_ptr<const Image>>(&asset);
    if (image && *image && (*image)->size() != size)
        failUsage("The picture for “{}” is {} × {} px, but {} is {} × {} px; it must be of that size.",
                  Message(port.title), (*image)->width(), (*image)->height(), like, size.width, size.height);
}

/// A port that takes a model takes the kind that its id says.
void checkModel(const MethodInfo& info, const Port& port, const Asset& asset) {
    const auto* model = std::get_if<std::shared_ptr<const Model>>(&asset);
    if (model && *model && (*model)->kind != port.id)
        failUsage("The input {} of {} takes a model of its own kind, and was given one of the kind {}.",
                  port.id, Message(info.title), (*model)->kind);
}

/// Kinds and numbers of what was given to one port.
void checkPort(const MethodInfo& info, const Port& port, const std::vector<Asset>& given) {
    const int count = static_cast<int>(given.size());
    if (count == 0 && port.least > 0)
        failUsage("{} needs its input {}, which was not given.", Message(info.title), port.id);
    if (count < port.least)
        failUsage("{} needs {} for its input {}, but {} were given.", Message(info.title), port.least,
                  port.id, count);
    if (count > port.most)
        failUsage("{} takes {} for its input {}, but {} were given.", Message(info.title), port.most, port.id,
                  count);
    for (const Asset& asset : given) {
        if (!isOf(port.kind, asset))
            failUsage("The input {} of {} takes {}.", port.id, Message(info.title), kindText(port.kind));
        checkModel(info, port, asset);
    }
}

/// Everything that was given goes into a port that there is.
void checkKnown(const MethodInfo& info, const Assets& inputs, bool ofExemplar) {
    for (const auto& [id, given] : inputs.byPort()) {
        const Port* const port = info.input(id);
        if (!port || (port->extent == Extent::Exemplar) != ofExemplar)
            failUsage("{} has no input {}; it takes {}.", Message(info.title), id, idsOf(info.takes));
    }
}

void checkExemplar(const MethodInfo& info, const Request& request, const Exemplar& exemplar) {
    const Size size = exemplar.image->size();
    if (exemplar.image->channels() != request.channels())
        failUsage("{} and {} have different numbers of channels, {} and {}; all exemplars need the same.",
                  request.exemplars.front().name, exemplar.name, request.channels(),
                  exemplar.image->channels());
    if (size.longerSide() >= Source::kNone)
        failUsage("{} is {} × {} px; an exemplar's sides go up to {} px.", exemplar.name, size.width,
                  size.height, Source::kNone - 1);
    if (!(exemplar.weight >= Exemplar::kLeastWeight && exemplar.weight <= Exemplar::kMostWeight))
        failUsage("The weight of {} is {}; it goes from {} to {}.", exemplar.name, exemplar.weight,
                  Exemplar::kLeastWeight, Exemplar::kMostWeight);
    checkKnown(info, exemplar.inputs, true);
    for (const Port& port : info.takes) {
        if (port.extent != Extent::Exemplar || port.id == kCompanionPort)
            continue;
        checkPort(info, port, exemplar.inputs.at(port.id));
        for (const Asset& asset : exemplar.inputs.at(port.id))
            checkExtent(port, asset, size, Message::verbatim(exemplar.name));
    }
}

void checkExemplars(const MethodInfo& info, const Request& request) {
    const Port* const port = info.input(kExemplarPort);
    if (request.exemplars.empty() && (!port || port->least == 0))
        return;
    if (request.exemplars.empty())
        failUsage("There is no exemplar to learn from.");
    if (!port)
        failUsage("{} takes no exemplar.", Message(info.title));
    if (port->most == 1 && request.exemplars.size() > 1)
        failUsage("{} learns from one exemplar, but {} were given.", Message(info.title),
                  request.exemplars.size());
    for (const Exemplar& exemplar : request.exemplars)
        checkExemplar(info, request, exemplar);
}

/// What goes into the ports that do not belong to an exemplar.
void checkInputs(const MethodInfo& info, const Request& request) {
    checkKnown(info, request.inputs, false);
    for (const Port& port : info.takes) {
        if (port.extent == Extent::Exemplar || port.id == kExemplarPort)
            continue;
        checkPort(info, port, request.inputs.at(port.id));
        if (port.extent != Extent::Output)
            continue;
        for (const Asset& asset : request.inputs.at(port.id))
            checkExtent(port, asset, request.size, TR("the output"));
    }
}

void checkInitial(const Request& request) {
    if (const Image* initial = request.initial(); initial && initial->channels() != request.channels())
        failUsage("The image to start from has {}, the output {}; they need the same number.",
                  channelText(initial->channels()), request.channels());
}

void checkOutput(const MethodInfo& info, const Request& request) {
    const Size size = request.size;
    if (size.empty() || size.longerSide() > kLargestSide)
        failUsage("The output cannot be {} × {} px: its sides go from 1 to {} px.", size.width, size.height,
                  grouped(kLargestSide));
    if ((request.wrap.x || request.wrap.y) && !info.canWrap())
        failUsage("{} cannot make an output that wraps.", Message(info.title));
    if (request.region && !info.makesParts())
        failUsage("{} cannot make a part of an output alone; make all of it.", Message(info.title));
    if (request.region && !request.region->within(size))
        failUsage("The region of {} × {} px at ({}, {}) does not lie in the output of {} × {} px.",
                  request.region->size.width, request.region->size.height, request.region->x,
                  request.region->y, size.width, size.height);
}

/// What a method made for one of its outputs is of the kind that the port says.
void checkMade(const MethodInfo& info, const Port& port, const Asset& asset) {
    if (!isOf(port.kind, asset) || std::visit([](const auto& made) { return made == nullptr; }, asset))
        fail("{} declares {} for its output {}, but made something else; this is a mistake in the method.",
             Message(info.title), kindText(port.kind), port.id);
    const auto* model = std::get_if<std::shared_ptr<const Model>>(&asset);
    if (model && (*model)->kind != port.id)
        fail("{} made a model of the kind {} for its output {}, which takes one of its own kind; this is a "
             "mistake in the method.",
             Message(info.title), (*model)->kind, port.id);
}

/// Everything that a method gives beside image and map, which have members of their own, comes out of a port
/// that it declares: what follows relies on that.
void checkGiven(const MethodInfo& info, const Assets& outputs) {
    for (const auto& [id, made] : outputs.byPort())
        if (info.output(id) == nullptr)
            fail("{} made an output {} that it does not declare; this is a mistake in the method.",
                 Message(info.title), id);
    for (const Port& port : info.gives) {
        const std::vector<Asset>& made = outputs.at(port.id);
        const int count = static_cast<int>(made.size());
        const bool apart = port.id == kImagePort || port.id == kMapPort;
        if (!apart && (count < port.least || count > port.most))
            fail("{} gives {} to {} for its output {}, but made {}; this is a mistake in the method.",
                 Message(info.title), port.least, port.most, port.id, count);
        for (const Asset& asset : made)
            checkMade(info, port, asset);
    }
}

} // namespace

std::vector<Size> Request::exemplarSizes() const {
    std::vector<Size> sizes;
    for (const Exemplar& exemplar : exemplars)
        sizes.push_back(exemplar.image->size());
    return sizes;
}

const Param& Method::param(std::string_view name) const {
    return paramNamed(m_params, m_id, name);
}

Values Method::defaults(Size exemplar) const {
    return defaultsOf(m_params, exemplar.shorterSide());
}

Values Method::resolved(const Values& settings, Size exemplar) const {
    return resolvedValues(m_params, m_id, settings, exemplar.shorterSide());
}

void Method::check(const Request& request, const Values& settings) const {
    checkExemplars(m_info, request);
    checkOutput(m_info, request);
    checkInputs(m_info, request);
    const Request whole = completed(request, settings);
    checkInitial(whole);
    m_check(whole, settings);
}

int Method::channels(const Request& request, const Values& settings) const {
    if (!request.exemplars.empty())
        return request.channels();
    if (const int own = m_channels ? m_channels(request, settings) : 0; own > 0)
        return own;
    return request.initial() ? request.initial()->channels() : request.freeChannels;
}

Request Method::completed(const Request& request, const Values& settings) const {
    Request whole = request;
    whole.freeChannels = channels(request, settings);
    return whole;
}

Estimate Method::estimate(const Request& request, const Values& settings, int threads) const {
    return m_estimate(completed(request, settings), settings, threads);
}

Synthesis Method::run(const Request& request, const Values& settings, JobContext& context) const {
    Synthesis made = m_run(completed(request, settings), settings, context);
    checkGiven(m_info, made.outputs);
    made.curves = context.curves();
    return made;
}

std::string categoryId(Category category) {
    static const std::array<const char*, 9> ids = {"patches",      "statistics",   "pixels",
                                                   "near-regular", "optimisation", "sparse",
                                                   "networks",     "solids",       "tools"};
    return ids.at(static_cast<std::size_t>(category));
}

std::string categoryTitle(Category category) {
    static const std::array<const char*, 9> titles = {
        TR("Patches"), TR("Statistics"), TR("Pixel by pixel"), TR("Near-regular"), TR("Optimisation"),
        TR("Sparse"),  TR("Networks"),   TR("Solids"),         TR("Tools")};
    return titles.at(static_cast<std::size_t>(category));
}

/// A picture beside a model that goes along only shows what was learnt: nothing to start from.
std::vector<PortLink> linksBetween(const MethodInfo& first, const MethodInfo& second) {
    std::vector<PortLink> links;
    for (const Port& output : first.gives)
        for (const Port& input : second.takes) {
            const bool picture = output.id == kImagePort && input.id == kInitialPort;
            const bool own = output.id == input.id && input.extent != Extent::Exemplar;
            if (output.kind == input.kind && (picture || own))
                links.push_back({output.id, input.id});
        }
    const bool model = std::any_of(links.begin(), links.end(), [&first](const PortLink& link) {
        return first.output(link.from)->kind == AssetKind::Model;
    });
    if (model)
        std::erase_if(links, [](const PortLink& link) { return link.to == kInitialPort; });
    return links;
}

namespace {

/// What runs of methods that copy pixels are told of companion maps: the methods find them in the exemplars'
/// channels.
struct CompanionSettings {
    double weight = 0;
};

Param companionWeightField() {
    return field(&CompanionSettings::weight, "companion-weight", TR("Weight of companion maps"))
        .range(0, 100)
        .usual(0, 2)
        .group(TR("Advanced"))
        .help(
            TR("How much companion maps, such as normals or heights, count where pieces are compared, joined "
               "and cut: at 1 as much as the image itself; 0 compares the image alone, and maps follow it."));
}

} // namespace

Method named(std::string id, Method method) {
    method.m_id = std::move(id);
    const bool learns = method.m_info.input(kExemplarPort) != nullptr;
    if (learns && !method.m_info.input(kCompanionPort))
        method.m_info.takes.push_back(ports::companions());
    if (learns && method.m_info.copiesPixels())
        method.m_params.push_back(companionWeightField());
    return method;
}

} // namespace texloom
