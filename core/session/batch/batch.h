#pragma once

#include "core/base/message.h"
#include "core/io/recipe.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

class Tool;

/// One run of a batch: a recipe and the files to write.
struct BatchItem {
    Recipe recipe; ///< without its exemplars: see whole()
    /// What may be thousands of files is there once for all items of a run.
    std::shared_ptr<const std::vector<RecipeExemplar>> exemplars;
    /// Joins the two exemplars where this is not a run of methods but of a tool, whose settings are those of
    /// the recipe's only step; else null.
    const Tool* join = nullptr;
    Message problem;   ///< why there is no recipe, in one sentence; empty if there is one
    std::string title; ///< of the run that it belongs to; empty where it says nothing
    std::string cell;  ///< "patch=32, seed=7": the place in its sweep, or empty
    std::filesystem::path output;
    std::vector<std::filesystem::path> maps;
    std::filesystem::path report; ///< or empty
    std::string depth;            ///< "8", "16", "half", "float", or empty for the exemplar's
    std::string space;            ///< or empty for what the format's users expect
    bool sidecar = true;

    /// The recipe with its exemplars.
    Recipe whole() const;
    /// "run 3 (patch=32, seed=7)" for messages. @param number from 1 in the whole batch.
    std::string label(std::size_t number) const;
};

/// Many recipes in one file, in their order. A sweep is kept as it is written, and its items are made when
/// they are asked for: a hundred thousand of them take little more memory than one. The JSON text is
/// `{"batch": 1, "title": …, "summary": …, "runs": [{"title": …, "recipe": …, "output": …, "sweep": {…},
/// "seeds": "held", …}]}`: a recipe is the name of a file or is written out in place; names of outputs are
/// templates (see expandName()) of $name, $method, $seed, $w, $h, $size, $index and each swept word; a sweep
/// gives lists of values to parameters ("patch", or "METHOD.name" for methods that follow), "seed", "size"
/// and "region" ([x, y, width, height]: parts of an output that may be larger than memory), of which all
/// combinations are made, the last one fastest; with "seeds": "varied" each combination has a seed of its
/// own. In place of a recipe, `"join": {"tool": …, "exemplars": [first, second], "parameters": {…}}` joins
/// two images by a tool; a mask of the second one is the region that the tool takes, $second is its name, and
/// a sweep goes through the tool's parameters.
class Batch {
public:
    /// Version of the format that this build writes and the newest it reads.
    static constexpr int kFormat = 1;

    std::string title, summary; ///< what it shows, where it is an example

    /// A recipe that cannot be read becomes its items' problem, so that the number of items depends on this
    /// text alone.
    /// @param folder against which relative paths are taken. @param outputs the same for the files to write;
    /// `folder` if empty.
    /// @throws UsageError that names the wrong field, or two items that would write the same file.
    static Batch fromJson(std::string_view text, const std::filesystem::path& folder,
                          const std::filesystem::path& outputs = {});

    /// Number of items.
    std::size_t size() const { return m_size; }
    /// @param index less than size().
    BatchItem item(std::size_t index) const;
    /// Files that recipes were read from.
    const std::vector<std::filesystem::path>& recipes() const { return m_recipes; }
    /// Files that the recipes name: exemplars and all else that items read.
    std::vector<std::filesystem::path> sources() const;

private:
    struct Run;

    /// Refuses items that would write over one another's files.
    void checkOutputs() const;

    std::filesystem::path m_folder; ///< of the files to write
    std::vector<std::shared_ptr<const Run>> m_runs;
    std::vector<std::size_t> m_firsts; ///< of each run, its first item
    std::size_t m_size = 0;
    std::vector<std::filesystem::path> m_recipes;
};

/// One of several equal shares of a batch: every count-th item, from `index` on.
struct Shard {
    std::size_t index = 0; ///< from 0
    std::size_t count = 1;

    bool holds(std::size_t item) const { return item % count == index; }
    /// From "3/8". @throws UsageError
    static Shard parse(std::string_view text);
};

} // namespace texloom
