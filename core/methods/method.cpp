#include "core/methods/method.h"

#include "core/base/error.h"
#include "core/base/text.h"

namespace texloom {

namespace {

/// Refuses an unknown word, and asks whether the known one that is most like it was meant, if any is like it.
[[noreturn]] void refuseUnknown(const Message& sentence, std::string_view word,
                                const std::vector<std::string>& known) {
    const std::string near = nearest(word, known);
    throw UsageError(near.empty() ? sentence : message("{} Did you mean {}?", sentence, near));
}

void checkExemplars(const MethodInfo& info, const Request& request) {
    if (request.exemplars.empty())
        failUsage("There is no exemplar to learn from.");
    if (request.exemplars.size() > 1 && !info.severalExemplars)
        failUsage("{} learns from one exemplar, but {} were given.", Message(info.title),
                  request.exemplars.size());
    for (const Exemplar& exemplar : request.exemplars) {
        if (exemplar.image->channels() != request.channels())
            failUsage("{} and {} have different numbers of channels, {} and {}; all exemplars need the same.",
                      request.exemplars.front().name, exemplar.name, request.channels(),
                      exemplar.image->channels());
        if (exemplar.image->size().longerSide() >= Source::kNone)
            failUsage("{} is {} × {} px; an exemplar's sides go up to {} px.", exemplar.name,
                      exemplar.image->width(), exemplar.image->height(), Source::kNone - 1);
        if (!(exemplar.weight >= Exemplar::kLeastWeight && exemplar.weight <= Exemplar::kMostWeight))
            failUsage("The weight of {} is {}; it goes from {} to {}.", exemplar.name, exemplar.weight,
                      Exemplar::kLeastWeight, Exemplar::kMostWeight);
        if (exemplar.mask && !info.usesMask)
            failUsage("{} does not use an exemplar mask.", Message(info.title));
        if (exemplar.mask && exemplar.mask->size() != exemplar.image->size())
            failUsage("The mask is {} × {} px, but {} is {} × {} px; they must be the same size.",
                      exemplar.mask->width(), exemplar.mask->height(), exemplar.name, exemplar.image->width(),
                      exemplar.image->height());
    }
}

void checkOutput(const MethodInfo& info, const Request& request) {
    const Size size = request.size;
    if (size.empty() || size.longerSide() > kLargestSide)
        failUsage("The output cannot be {} × {} px: its sides go from 1 to {} px.", size.width, size.height,
                  grouped(kLargestSide));
    if ((request.wrap.x || request.wrap.y) && !info.wraps)
        failUsage("{} cannot make an output that wraps.", Message(info.title));
    if (request.region && !info.makesRegions)
        failUsage("{} cannot make a part of an output alone; make all of it.", Message(info.title));
    if (request.region && !request.region->within(size))
        failUsage("The region of {} × {} px at ({}, {}) does not lie in the output of {} × {} px.",
                  request.region->size.width, request.region->size.height, request.region->x,
                  request.region->y, size.width, size.height);
    if (!request.initial)
        return;
    if (!info.startsFromImage)
        failUsage("{} cannot start from an image.", Message(info.title));
    if (request.initial->size() != size || request.initial->channels() != request.channels())
        failUsage("The initial image is {} × {} px with {} channels; the output is {} × {} px with {}.",
                  request.initial->width(), request.initial->height(), request.initial->channels(),
                  size.width, size.height, request.channels());
}

} // namespace

std::vector<Size> Request::exemplarSizes() const {
    std::vector<Size> sizes;
    for (const Exemplar& exemplar : exemplars)
        sizes.push_back(exemplar.image->size());
    return sizes;
}

const Param& Method::param(std::string_view name) const {
    std::vector<std::string> known;
    for (const Param& param : m_params) {
        if (param.name() == name)
            return param;
        known.push_back(param.name());
    }
    refuseUnknown(message("{} has no parameter {}; it has {}.", m_id, name, listOf(known)), name, known);
}

Values Method::defaults(Size exemplar) const {
    Values values;
    for (const Param& param : m_params)
        values[param.name()] = param.defaultFor(exemplar.shorterSide());
    return values;
}

Values Method::resolved(const Values& settings, Size exemplar) const {
    Values values = defaults(exemplar);
    for (const auto& [name, value] : settings)
        values[name] = param(name).checked(value);
    return values;
}

void Method::check(const Request& request, const Values& settings) const {
    checkExemplars(m_info, request);
    checkOutput(m_info, request);
    m_check(request, settings);
}

Estimate Method::estimate(const Request& request, const Values& settings, int threads) const {
    return m_estimate(request, settings, threads);
}

Synthesis Method::run(const Request& request, const Values& settings, JobContext& context) const {
    return m_run(request, settings, context);
}

Method named(std::string id, Method method) {
    method.m_id = std::move(id);
    return method;
}

const Method& findMethod(std::string_view id) {
    std::vector<std::string> known;
    for (const Method& method : methods()) {
        if (method.id() == id)
            return method;
        known.push_back(method.id());
    }
    refuseUnknown(message("There is no method {}; the methods are {}.", id, listOf(known)), id, known);
}

} // namespace texloom
