#pragma once

#include "core/base/param.h"
#include "core/base/settings.h"
#include "core/image/image.h"
#include "core/image/warp.h"
#include "core/job/job_context.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace texloom {

/// Settings of a tool that are asked for often: a button in the window, or where two pictures are joined one
/// of the ways that stand side by side.
struct ToolPreset {
    std::string title; ///< short: "↻ 90°"
    std::string help;  ///< in words: "Turn right by 90°"
    Values values;
};

/// What the mouse can move over a picture in the window, beside areas and points, which are parameters.
enum class ToolHandle {
    None,
    Curve, ///< the parameters `curve`, `position` and `band` are a curve as BlendCurve::at() has it
    Offset ///< the parameters `offset-x` and `offset-y` move a region of the second picture over the first
};

/// A part of the second picture that a joining tool takes, painted in the window and read from a mask.
struct ToolRegion {
    std::string title, help;
};

/// Two pictures to be joined.
struct JoinPictures {
    ImageView first, second;
    /// One channel, of the second picture's size, with the region as inRegion() has it; null where none was
    /// painted, and for tools that take none.
    const Image* region = nullptr;
};

/// What a tool says of itself, apart from its parameters.
struct ToolInfo {
    std::string title;         ///< as the window shows it
    std::string summary;       ///< one or two sentences: what it does and what it is for
    std::string citation = {}; ///< the papers it follows, if there are any
    std::vector<ToolPreset> presets = {};
    /// Whether the window shows a form that changes one edit of this tool as its values change. The other
    /// tools make a further edit each time they are used.
    bool adjusts = false;
    ToolHandle handle = ToolHandle::None;
    std::optional<ToolRegion> region = {};
};

/// Called every few milliseconds; may throw, which ends the work.
using ToolCheck = std::function<void()>;

/// What changes an exemplar or joins two pictures. A tool is one folder of core/tools/ that defines
/// `const Tool self = tool<Settings>(…)` in a namespace of the folder's name; nothing else is edited. What it
/// is made of says what it acts on:
/// - a warp moves pixels: of the image, its mask and its companions alike, normals turned as vectors;
/// - a recolouring changes the colours of the image alone;
/// - a join makes one picture of two.
class Tool {
public:
    /// Where the pixels of the edited image come from. @throws UsageError that names the value and the limit
    /// where these settings do not suit an image of size `before`.
    template <class Settings> using WarpOf = Warp (*)(const Settings& settings, Size before);
    /// Changes an image in values proportional to light (or data, as they are). @param mask one channel, 0
    /// where pixels do not count, or null.
    template <class Settings>
    using Recolor = void (*)(Image& image, const Settings& settings, const Image* mask,
                             const ToolCheck& check);
    /// What joins two pictures of as many channels, and what has to be known before it starts.
    template <class Settings> struct Join {
        Image (*make)(const JoinPictures& pictures, const Settings&, JobContext&);
        /// @throws UsageError that names the value and the limit where these pictures cannot be joined.
        void (*check)(const JoinPictures& pictures, const Settings&);
        /// Upper bound of the memory that it takes, of pictures that passed the check.
        std::uint64_t (*bytes)(const JoinPictures& pictures, const Settings&);
        bool sameSize = true; ///< whether both must have one size
    };

    /// Kebab-case, from the folder's name. It is also the name of the first parameter of tools that edit.
    const std::string& id() const { return m_id; }
    const ToolInfo& info() const { return m_info; }
    const std::vector<Param>& params() const { return m_params; }
    /// @throws UsageError that names the tool and the nearest parameter if there is none of this name.
    const Param& param(std::string_view name) const { return paramNamed(m_params, m_id, name); }
    Values defaults() const { return defaultsOf(m_params, 0); }
    /// `settings` checked and completed with defaults. @throws UsageError
    Values resolved(const Values& settings) const { return resolvedValues(m_params, m_id, settings, 0); }

    bool warps() const { return std::holds_alternative<WarpBy>(m_work); }
    /// Whether it takes two pictures; the others edit one.
    bool joins() const { return std::holds_alternative<JoinBy>(m_work); }

    /// Whether it joins pictures of one size only.
    bool joinsSameSize() const { return joins() && std::get<JoinBy>(m_work).sameSize; }

    /// What the functions above do, with settings as resolved() gave them. Each is for its kind of tool
    /// alone.
    Warp warp(const Values& settings, Size before) const {
        return std::get<WarpBy>(m_work)(settings, before);
    }
    void recolor(
        Image& image, const Values& settings, const Image* mask, const ToolCheck& check = [] {}) const {
        std::get<RecolorBy>(m_work)(image, settings, mask, check);
    }
    /// @throws UsageError if the pictures differ in channels, or do not suit each other, the region or the
    /// settings
    void checkJoin(const JoinPictures& pictures, const Values& settings) const;
    /// Joins two pictures. @throws UsageError as checkJoin(), Error where it would take more memory than is
    /// free
    Image joined(const JoinPictures& pictures, const Values& settings, JobContext& context) const;

private:
    using WarpBy = std::function<Warp(const Values&, Size)>;
    using RecolorBy = std::function<void(Image&, const Values&, const Image*, const ToolCheck&)>;
    struct JoinBy {
        std::function<Image(const JoinPictures&, const Values&, JobContext&)> make;
        std::function<void(const JoinPictures&, const Values&)> check;
        std::function<std::uint64_t(const JoinPictures&, const Values&)> bytes;
        bool sameSize = true;
    };

    Tool(ToolInfo info, std::vector<Param> params) : m_info(std::move(info)), m_params(std::move(params)) {}

    template <class Settings>
    friend Tool tool(ToolInfo info, std::vector<Param> params, Tool::WarpOf<Settings> warp);
    template <class Settings>
    friend Tool tool(ToolInfo info, std::vector<Param> params, Tool::Recolor<Settings> recolor);
    template <class Settings>
    friend Tool tool(ToolInfo info, std::vector<Param> params, Tool::Join<Settings> join);
    friend Tool named(std::string id, Tool tool);

    std::string m_id;
    ToolInfo m_info;
    std::vector<Param> m_params;
    std::variant<WarpBy, RecolorBy, JoinBy> m_work;
};

/// Declares a tool that moves pixels. @param params one field() per member of Settings; the first is named
/// like the tool.
template <class Settings> Tool tool(ToolInfo info, std::vector<Param> params, Tool::WarpOf<Settings> warp) {
    Tool made(std::move(info), std::move(params));
    made.m_work = [fields = made.m_params, warp](const Values& values, Size before) {
        return warp(settingsFrom<Settings>(fields, values), before);
    };
    return made;
}

/// Declares one that changes colours.
template <class Settings>
Tool tool(ToolInfo info, std::vector<Param> params, Tool::Recolor<Settings> recolor) {
    Tool made(std::move(info), std::move(params));
    made.m_work = [fields = made.m_params, recolor](Image& image, const Values& values, const Image* mask,
                                                    const ToolCheck& check) {
        recolor(image, settingsFrom<Settings>(fields, values), mask, check);
    };
    return made;
}

/// Declares one that joins two pictures.
template <class Settings> Tool tool(ToolInfo info, std::vector<Param> params, Tool::Join<Settings> join) {
    Tool made(std::move(info), std::move(params));
    const std::vector<Param> fields = made.m_params;
    Tool::JoinBy by;
    by.make = [fields, join](const JoinPictures& pictures, const Values& values, JobContext& context) {
        return join.make(pictures, settingsFrom<Settings>(fields, values), context);
    };
    by.check = [fields, join](const JoinPictures& pictures, const Values& values) {
        join.check(pictures, settingsFrom<Settings>(fields, values));
    };
    by.bytes = [fields, join](const JoinPictures& pictures, const Values& values) {
        return join.bytes(pictures, settingsFrom<Settings>(fields, values));
    };
    by.sameSize = join.sameSize;
    made.m_work = std::move(by);
    return made;
}

/// The tool under an id; for the generated registry.
Tool named(std::string id, Tool tool);

/// Every tool there is, by id.
const std::vector<Tool>& tools();

/// @throws UsageError that lists the known ids, and the nearest one.
const Tool& findTool(std::string_view id);

} // namespace texloom
