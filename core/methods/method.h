#pragma once

#include "core/base/param.h"
#include "core/job/job_context.h"
#include "core/methods/synthesis.h"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texloom {

/// What a method says of itself, apart from its parameters.
struct MethodInfo {
    std::string title;            ///< as the window shows it
    std::string summary;          ///< one or two sentences: what it does and what it suits
    std::string citation;         ///< the papers it follows
    bool wraps = false;           ///< its output can close on itself, on either axis
    bool startsFromImage = false; ///< uses Request::initial
    bool usesMask = false;        ///< uses Exemplar::mask
    bool severalExemplars = false;
    bool weighsExemplars = false; ///< uses Exemplar::weight where there are several
    /// Its pixels come from the exemplar, and its map says from where: companion maps are laid out by the
    /// map. For other methods they are further channels of the exemplar, made together with the rest.
    bool copiesPixels = false;
    bool makesRegions = false; ///< uses Request::region: any part of an output can be made alone
};

/// What a run will need, told before it starts.
struct Estimate {
    std::uint64_t bytes = 0; ///< upper bound of the memory that the run takes
    double seconds = 0;      ///< rough time on one thread of an ordinary machine
};

/// One way of making a texture. A method is one folder of core/methods/ that defines
/// `const Method self = method<Settings>(…)` in a namespace of the folder's name; nothing else is edited.
class Method {
public:
    /// Kebab-case, from the folder's name.
    const std::string& id() const { return m_id; }
    const MethodInfo& info() const { return m_info; }
    const std::vector<Param>& params() const { return m_params; }
    /// @throws UsageError that names the method and the nearest parameter if there is none of this name.
    const Param& param(std::string_view name) const;

    /// Every parameter's default for an exemplar of this size ({} if not known yet).
    Values defaults(Size exemplar = {}) const;
    /// `settings` checked and completed with defaults. @throws UsageError
    Values resolved(const Values& settings, Size exemplar) const;

    /// Whether the request can be run at all. @throws Error or UsageError with the value and the limit.
    void check(const Request& request, const Values& settings) const;
    /// What a checked request will need on `threads` threads.
    Estimate estimate(const Request& request, const Values& settings, int threads) const;
    /// Runs a checked request. @param settings as resolved() gave them. @throws Error, Cancelled
    Synthesis run(const Request& request, const Values& settings, JobContext& context) const;

private:
    template <class Settings>
    friend Method method(MethodInfo info, std::vector<Param> params,
                         Synthesis (*run)(const Request&, const Settings&, JobContext&),
                         void (*check)(const Request&, const Settings&),
                         Estimate (*estimate)(const Request&, const Settings&, int threads));
    friend Method named(std::string id, Method method);

    Method() = default;

    std::string m_id;
    MethodInfo m_info;
    std::vector<Param> m_params;
    std::function<void(const Request&, const Values&)> m_check;
    std::function<Estimate(const Request&, const Values&, int)> m_estimate;
    std::function<Synthesis(const Request&, const Values&, JobContext&)> m_run;
};

/// A settings struct filled from checked values.
template <class Settings> Settings settingsFrom(const std::vector<Param>& params, const Values& values) {
    Settings settings;
    for (const Param& param : params)
        if (const auto it = values.find(param.name()); it != values.end())
            param.assign(&settings, it->second);
    return settings;
}

/// Declares a method. @param info what it is; @param params one field() per member of Settings;
/// @param run does the work; @param check throws where a request cannot be run with these settings;
/// @param estimate says what the run will need.
template <class Settings>
Method method(MethodInfo info, std::vector<Param> params,
              Synthesis (*run)(const Request&, const Settings&, JobContext&),
              void (*check)(const Request&, const Settings&),
              Estimate (*estimate)(const Request&, const Settings&, int threads)) {
    Method made;
    made.m_info = std::move(info);
    made.m_params = std::move(params);
    const std::vector<Param>& fields = made.m_params;
    made.m_run = [fields, run](const Request& request, const Values& values, JobContext& context) {
        return run(request, settingsFrom<Settings>(fields, values), context);
    };
    made.m_check = [fields, check](const Request& request, const Values& values) {
        check(request, settingsFrom<Settings>(fields, values));
    };
    made.m_estimate = [fields, estimate](const Request& request, const Values& values, int threads) {
        return estimate(request, settingsFrom<Settings>(fields, values), threads);
    };
    return made;
}

/// The method under an id; for the generated registry.
Method named(std::string id, Method method);

/// Every method there is, by id.
const std::vector<Method>& methods();

/// @throws UsageError that lists the known ids, and the nearest one.
const Method& findMethod(std::string_view id);

/// Largest side of an output, in pixels.
inline constexpr int kLargestSide = 65536;

} // namespace texloom
