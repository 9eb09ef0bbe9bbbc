#pragma once

#include "core/io/recipe.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// What someone works on, as a session's file keeps it: every exemplar that is open with its edits, and all
/// settings.
struct Session {
    /// Version of the format that this build writes and the newest it reads.
    static constexpr int kFormat = 1;

    Recipe settings;        ///< its exemplars are all that are open, perhaps none
    std::vector<bool> used; ///< for each exemplar, whether methods that learn from several use it
    int current = 0;        ///< index of the exemplar that is looked at
    bool seedLocked = true;
    /// In copies for recovery, the file that the session was saved to, or empty.
    std::filesystem::path file = {};

    /// JSON text with paths relative to `folder`.
    std::string toJson(const std::filesystem::path& folder) const;
    /// @throws UsageError that names the wrong field, or says that a newer Texloom wrote it.
    static Session fromJson(std::string_view text, const std::filesystem::path& folder);
};

/// @throws Error if the file cannot be read, UsageError as Session::fromJson()
Session readSession(const std::filesystem::path& path);
/// Writes whole or not at all. @throws Error
void writeSession(const std::filesystem::path& path, const Session& session);

/// The run that a session's settings make: with all exemplars in use where its methods learn from several,
/// else with the one that is looked at. @throws UsageError where there is no exemplar and they need one, or a
/// method is not known.
Recipe runOf(const Session& session);

/// The recipe of a run in a file: a recipe, an image that Texloom wrote, or a session (.texloom).
/// @throws Error, UsageError
Recipe readRun(const std::filesystem::path& path);

/// Writes a session with copies of its files in the folder NAME_files beside it, to be moved or given away
/// together. Files already in that folder stay as they are; one that is a copy already serves as one.
/// @param only copies only what lies in this folder; everything if empty. @return the session as written.
/// @throws Error; then no session is written.
Session packSession(const std::filesystem::path& path, Session session,
                    const std::filesystem::path& only = {});

/// Files of a session that are not as it knows them.
struct SessionFiles {
    std::vector<std::filesystem::path> missing, changed;
};

/// Looks at every file. Takes a moment where files are large.
SessionFiles checkFiles(const Session& session);

/// Only the files that are gone; quick.
std::vector<std::filesystem::path> missingFiles(const Session& session);

/// Notes that a file was moved, and looks for other missing files in the same place relative to it.
void relocate(Session& session, const std::filesystem::path& from, const std::filesystem::path& to);

/// Goes on without a file: without the exemplar whose image it is, or without the mask, companion map or
/// input.
void leaveOut(Session& session, const std::filesystem::path& file);
/// Goes on without one of its exemplars.
void leaveOut(Session& session, std::size_t exemplar);

} // namespace texloom
