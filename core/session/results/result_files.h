#pragma once

#include "core/session/run/run.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texloom {

/// One of the things that a run made beside its picture and map, as it is kept.
struct KeptOutput {
    std::string port;
    AssetKind kind = AssetKind::Model;
    Message size; ///< how large it is, as sizeText() says it
};

/// What is remembered of a run that ended, whether or not its pixels are in memory. Only the title, the pin
/// and the stars ever change.
struct ResultEntry {
    static constexpr int kMostStars = 5;

    std::string key;   ///< name of its folder; keys sort by the time at which runs ended
    std::string title; ///< the user's own name for it, or empty
    bool pinned = false;
    int stars = 0;               ///< that the user gave it, up to kMostStars; 0: none yet
    std::vector<Message> varied; ///< what told it from the other runs of its sweep: "Patch size 16 px"
    bool quick = false;          ///< a preview at a small size
    std::int64_t finished = 0;   ///< milliseconds since 1970, UTC
    Recipe recipe;
    double seconds = 0;         ///< of work, on `threads` threads
    double estimateSeconds = 0; ///< what the methods' rough estimate said, for one thread
    int threads = 0;
    std::optional<double> stoppedAt; ///< see Result::stoppedAt
    std::uint64_t bytes = 0;         ///< that the result takes in memory
    MapKind mapKind = MapKind::None;
    std::vector<Figure> figures;
    std::vector<Curve> curves;
    std::vector<Message> notes;
    std::vector<StageTime> stages;
    std::vector<Message> pictures;   ///< names of the pictures beside the result
    std::size_t companions = 0;      ///< number of companion maps made with it
    std::vector<KeptOutput> outputs; ///< further outputs, such as a model or a volume

    /// The methods' ids with " + " between them.
    std::string methodIds() const;
};

/// What there is to say of a result, under a key that no other has.
ResultEntry entryFor(const Result& result, bool quick);

/// The bytes that a result takes in memory, without the exemplars, which it shares with others.
std::uint64_t memoryOf(const Result& result);

/// A result read back, with what is wrong with it.
struct StoredResult {
    std::shared_ptr<const Result> result;
    /// Why the exemplars are not those it was made with, as a sentence; empty if they are. The pixels, the
    /// map and the recipe are true in any case.
    Message problem;
};

/// A folder of results: NAME/entry.json with all that is known of one, and its pixels beside it as float
/// TIFFs, bit for bit; models, meshes and volumes in files of their own, of volumes without end the part that
/// keptBox() says. entry.json comes last, so that what a crash broke off is told from what is whole.
/// Functions of one entry may be called from any thread, those of different entries at the same time.
class ResultFolder {
public:
    explicit ResultFolder(std::filesystem::path path) : m_path(std::move(path)) {}

    const std::filesystem::path& path() const { return m_path; }
    std::filesystem::path of(const ResultEntry& entry) const { return m_path / entry.key; }

    /// Moves all results of an earlier folder here, those already here excepted; their recipes go on naming
    /// the same files.
    void takeOver(const std::filesystem::path& earlier) const;

    struct Scan {
        std::vector<ResultEntry> entries; ///< whole ones, oldest first
        std::vector<Message> problems;    ///< a sentence for each that was left out
    };
    /// Looks through the folder. What broke off more than a day ago is removed.
    Scan scan() const;

    /// Writes pixels and entry. @throws Error; then nothing of it is left.
    void write(const ResultEntry& entry, const Result& result) const;
    /// Writes only what is known of it, after its title or pin changed. @throws Error
    void writeEntry(const ResultEntry& entry) const;
    /// @throws Error or UsageError if the pixels are not there or not whole.
    StoredResult read(const ResultEntry& entry) const;
    /// Bytes that its files take; 0 if there are none.
    std::uint64_t bytesOf(const ResultEntry& entry) const;
    void remove(const ResultEntry& entry) const;

private:
    std::filesystem::path m_path;
};

} // namespace texloom
