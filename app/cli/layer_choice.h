#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace texloom::cli {

/// `--layer`: which layer, part or page is read of the files of a command, as NAME for its pictures or as
/// WHAT=NAME for others that it reads.
class LayerChoice {
public:
    /// What stands before "=", or nothing: the command's pictures.
    static constexpr std::string_view kPictures = "exemplar";

    /// @param words as they were written.
    explicit LayerChoice(const std::vector<std::string>& words);

    /// The layer of one file, empty for all that it holds. One that was given is for all files of its kind,
    /// several are for each in order. @param index of `count` files of this kind.
    /// @throws UsageError if there are more or fewer layers than files.
    std::string of(std::string_view what, std::size_t index = 0, std::size_t count = 1);
    /// Whether there is a layer for this kind.
    bool names(std::string_view what) const;
    /// @throws UsageError for a layer that no file was asked about.
    void checkUsed() const;

private:
    struct Entry {
        std::string what, layer;
        bool used = false;
    };

    std::vector<Entry> m_entries;
};

/// @param others what may stand before "=", for the help; empty if nothing.
void addLayers(CLI::App& command, std::vector<std::string>& words, const std::string& others = {});

} // namespace texloom::cli
