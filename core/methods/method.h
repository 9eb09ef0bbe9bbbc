#pragma once

#include "core/base/settings.h"
#include "core/job/job_context.h"
#include "core/methods/synthesis.h"

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texloom {

/// Where a method stands among the others, in the order in which they are listed.
enum class Category {
    Patches,
    Statistics,
    Pixels,
    NearRegular,
    Optimisation,
    Sparse,
    Networks,
    Solids,
    Tools,
};

/// "patches", "near-regular" …: as the command line lists it.
std::string categoryId(Category category);
/// As the window shows it.
std::string categoryTitle(Category category);

/// Whether the same recipe gives the same result on any number of threads.
enum class Repeats {
    Bits,   ///< to the bit
    Nearly, ///< but for rounding
};

/// How well a method suits textures of each kind at its defaults, judged by eye: from 0, it spoils them, to
/// 5, they could be the exemplar. All 0 for methods that are no way of making more of one exemplar.
struct Suits {
    int regular = 0; ///< bricks, tiles, weaves: what repeats by a lattice or in rows
    int grain = 0;   ///< sand, plaster, cloth: fine, and without objects
    int objects = 0; ///< gravel, leaves, scales: things that are small against the exemplar
    int large = 0;   ///< rock, wood, cracks: shapes that reach over much of the exemplar

    bool any() const { return regular + grain + objects + large > 0; }
};

/// What a method says of itself, apart from its parameters.
struct MethodInfo {
    std::string title;    ///< as the window shows it
    std::string summary;  ///< one or two sentences: what it does and what it suits
    std::string citation; ///< the papers it follows
    Category category = Category::Patches;
    Suits suits = {};
    std::vector<Port> takes; ///< Method adds companion maps where there are exemplars
    std::vector<Port> gives; ///< at least an image
    Repeats repeats = Repeats::Bits;
    bool usesSeed = true;                         ///< whether seeds can matter, if only at some settings
    std::chrono::milliseconds cancelsWithin{100}; ///< how soon it ends once it is told to

    /// The port of this id, or null.
    const Port* input(std::string_view id) const { return findPort(takes, id); }
    const Port* output(std::string_view id) const { return findPort(gives, id); }

    bool takesExemplars() const { return input(kExemplarPort) != nullptr; }
    bool needsExemplar() const { return takesExemplars() && input(kExemplarPort)->least > 0; }
    bool learnsFromSeveral() const { return input(kExemplarPort) && input(kExemplarPort)->most > 1; }
    bool heedsWeights() const { return input(kExemplarPort) && input(kExemplarPort)->weighed; }
    bool heedsMasks() const { return input(kMaskPort) != nullptr; }
    bool startsFromImage() const { return input(kInitialPort) != nullptr; }
    bool canWrap() const { return output(kImagePort) && output(kImagePort)->wraps; }
    /// Any part of an output can be made alone: Request::region.
    bool makesParts() const { return output(kImagePort) && output(kImagePort)->extent == Extent::Any; }
    /// Companion maps are laid out by the position map; for other methods they are further channels of the
    /// exemplar, made together with the rest.
    bool copiesPixels() const { return output(kMapPort) != nullptr; }
};

/// One thing that a method hands to the one that follows it.
struct PortLink {
    std::string from; ///< the first method's output
    std::string to;   ///< the second method's input
};

/// What `second` takes up where it follows `first`: the image as the one to start from, and whatever else has
/// an input of its own name and kind. Empty: it cannot follow.
std::vector<PortLink> linksBetween(const MethodInfo& first, const MethodInfo& second);

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

    /// Channels of the output: those of the exemplars. Where there are none, as many as the method makes of
    /// its inputs and settings, if it says so; else those of the image to start from, or what the request
    /// has.
    /// @param request with inputs of the right kinds; one that is null is not there yet.
    int channels(const Request& request, const Values& settings) const;
    /// Whether the request can be run at all. @throws Error or UsageError with the value and the limit.
    void check(const Request& request, const Values& settings) const;
    /// What a checked request will need on `threads` threads.
    Estimate estimate(const Request& request, const Values& settings, int threads) const;
    /// Runs a checked request. @param settings as resolved() gave them.
    /// @throws Error, also where the method gives other outputs than it declares; Cancelled
    Synthesis run(const Request& request, const Values& settings, JobContext& context) const;

private:
    template <class Settings>
    friend Method method(MethodInfo info, std::vector<Param> params,
                         Synthesis (*run)(const Request&, const Settings&, JobContext&),
                         void (*check)(const Request&, const Settings&),
                         Estimate (*estimate)(const Request&, const Settings&, int threads),
                         int (*channels)(const Request&, const Settings&));
    friend Method named(std::string id, Method method);

    Method() = default;
    /// The request with the channels that its output has.
    Request completed(const Request& request, const Values& settings) const;

    std::string m_id;
    MethodInfo m_info;
    std::vector<Param> m_params;
    std::function<void(const Request&, const Values&)> m_check;
    std::function<Estimate(const Request&, const Values&, int)> m_estimate;
    std::function<Synthesis(const Request&, const Values&, JobContext&)> m_run;
    std::function<int(const Request&, const Values&)> m_channels; ///< may be empty
};

/// Declares a method. @param info what it is; @param params one field() per member of Settings;
/// @param run does the work; @param check throws where a request cannot be run with these settings;
/// @param estimate says what the run will need; @param channels of a method without exemplars, how many
/// channels its output has, or 0 where an input that says so is not there yet. All of them find that number
/// in Request::channels().
template <class Settings>
Method method(MethodInfo info, std::vector<Param> params,
              Synthesis (*run)(const Request&, const Settings&, JobContext&),
              void (*check)(const Request&, const Settings&),
              Estimate (*estimate)(const Request&, const Settings&, int threads),
              int (*channels)(const Request&, const Settings&)) {
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
    if (channels != nullptr)
        made.m_channels = [fields, channels](const Request& request, const Values& values) {
            return channels(request, settingsFrom<Settings>(fields, values));
        };
    return made;
}

/// The same for a method whose output has the channels of its exemplars, or of the image that it starts from.
template <class Settings>
Method method(MethodInfo info, std::vector<Param> params,
              Synthesis (*run)(const Request&, const Settings&, JobContext&),
              void (*check)(const Request&, const Settings&),
              Estimate (*estimate)(const Request&, const Settings&, int threads)) {
    int (*const channels)(const Request&, const Settings&) = nullptr;
    return method<Settings>(std::move(info), std::move(params), run, check, estimate, channels);
}

/// The same for a method that runs whatever its ports and parameters let through.
template <class Settings>
Method method(MethodInfo info, std::vector<Param> params,
              Synthesis (*run)(const Request&, const Settings&, JobContext&),
              Estimate (*estimate)(const Request&, const Settings&, int threads)) {
    void (*const check)(const Request&, const Settings&) = [](const Request&, const Settings&) {};
    return method<Settings>(std::move(info), std::move(params), run, check, estimate);
}

/// The method under an id; for the generated registry.
Method named(std::string id, Method method);

/// Every method there is, by id.
const std::vector<Method>& methods();
/// The same in the order in which they are listed: by category, then by id.
std::vector<const Method*> methodsByCategory();

/// @throws UsageError that lists the known ids, and the nearest one.
const Method& findMethod(std::string_view id);

/// Largest side of an output, in pixels.
inline constexpr int kLargestSide = 65536;

} // namespace texloom
