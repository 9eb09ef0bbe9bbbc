#include "tests/support/method_run.h"

#include "core/base/error.h"
#include "core/job/job.h"

#include <memory>
#include <utility>

namespace texloom::test {

Request requestOf(Image exemplar, Size output, Wrap wrap, std::uint64_t seed) {
    Request request;
    request.exemplars.push_back({"made up", std::make_shared<const Image>(std::move(exemplar))});
    request.size = output;
    request.wrap = wrap;
    request.seed = seed;
    return request;
}

Values with(Values settings, const Values& more) {
    for (const auto& [name, value] : more)
        settings[name] = value;
    return settings;
}

Values checked(const Method& method, const Request& request, const Values& settings) {
    const Size exemplar = request.exemplars.empty() ? Size{} : request.exemplars.front().image->size();
    Values all = method.resolved(settings, exemplar);
    method.check(request, all);
    return all;
}

std::string refusalOf(const Method& method, const Request& request, const Values& settings) {
    try {
        checked(method, request, settings);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "was taken";
}

Synthesis resultOf(const Method& method, const Request& request, const Values& settings, JobOptions options) {
    const Values all = checked(method, request, settings);
    options.seed = request.seed;
    Job<Synthesis> job(options, [&](JobContext& context) { return method.run(request, all, context); });
    Outcome<Synthesis> outcome = job.take();
    if (const auto* failure = std::get_if<Failure>(&outcome))
        throw Error(failure->message);
    return std::get<Synthesis>(std::move(outcome));
}

} // namespace texloom::test
