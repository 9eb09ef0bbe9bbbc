#pragma once

#include "core/job/job_context.h"
#include "core/methods/method.h"

#include <cstdint>
#include <string>

namespace texloom::test {

/// A request for more of this exemplar, which goes by the name "made up".
Request requestOf(Image exemplar, Size output, Wrap wrap = {}, std::uint64_t seed = 3);

/// `settings` with those of `more` in their place.
Values with(Values settings, const Values& more);

/// `settings` completed for the request's first exemplar, and checked. @throws what the check refuses with
Values checked(const Method& method, const Request& request, const Values& settings);

/// The sentence by which the method says that what was asked for is wrong, or "was taken".
std::string refusalOf(const Method& method, const Request& request, const Values& settings = {});

/// What the method makes with checked(settings), by the request's seed. @throws Error also where the run
/// fails
Synthesis resultOf(const Method& method, const Request& request, const Values& settings = {},
                   JobOptions options = {.threads = 2});

} // namespace texloom::test
