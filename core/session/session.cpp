#include "core/session/session.h"

#include "core/base/error.h"
#include "core/base/folder_of.h"
#include "core/base/version.h"
#include "core/io/file_name_json.h"
#include "core/io/image_file.h"
#include "core/io/json_field.h"
#include "core/io/temporary_file.h"
#include "core/session/run/asset_file.h"
#include "core/session/run/exemplar_use.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <set>

namespace texloom {

namespace fs = std::filesystem;
using Json = JsonField::Json;

namespace {

void checkFormat(const JsonField& root) {
    const JsonField format = root.at("session");
    if (format.whole() < 1)
        format.wrong(message("1 to {}", Session::kFormat));
    if (format.whole() > Session::kFormat)
        failUsage("The session is of format {}, made by a newer Texloom; this one ({}) reads up to {}.",
                  format.whole(), kVersion, Session::kFormat);
}

bool flagFrom(const JsonField& field) {
    if (!field.json().is_boolean())
        field.wrong(TR("true or false"));
    return field.json().get<bool>();
}

/// What a port of this id takes, as one of the methods says; an image where none of them is known.
AssetKind kindOf(const std::vector<RecipeStep>& steps, const std::string& port) {
    for (const RecipeStep& step : steps)
        for (const Method& method : methods())
            if (const Port* found = method.id() == step.method ? method.info().input(port) : nullptr)
                return found->kind;
    return AssetKind::Image;
}

/// The kinds of the files that are no pictures.
std::map<fs::path, AssetKind> kindsOf(const Recipe& settings) {
    std::map<fs::path, AssetKind> kinds;
    for (const auto& [port, files] : settings.inputs)
        for (const RecipeFile& file : files)
            kinds[file.path] = kindOf(settings.steps, port);
    return kinds;
}

/// A folder for copies of files that belong together, so that they keep their names: one that is not there,
/// or holds the same already.
fs::path placeForSet(const std::vector<fs::path>& files, const fs::path& folder) {
    std::error_code error;
    const auto others = [&](const fs::path& place) {
        return std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
            const fs::path copy = place / file.filename();
            return fs::exists(copy, error) &&
                   (!fs::is_regular_file(copy, error) || fileHash(copy) != fileHash(file));
        });
    };
    const std::string name = files.front().stem().string();
    fs::path place = folder / name;
    for (int copy = 2; others(place) || (fs::exists(place, error) && !fs::is_directory(place, error)); ++copy)
        place = folder / fmt::format("{}_{}", name, copy);
    return place;
}

/// Where a copy of `file` goes in `folder`: a name that no other file of the session has taken, and no file
/// has that is there, unless it is such a copy.
fs::path placeFor(const fs::path& file, const fs::path& folder, std::set<fs::path>& taken) {
    const fs::path name = file.filename();
    std::error_code error;
    const auto others = [&](const fs::path& path) {
        return !taken.insert(path).second || (fs::exists(path, error) && (!fs::is_regular_file(path, error) ||
                                                                          fileHash(path) != fileHash(file)));
    };
    fs::path path = folder / name;
    for (int copy = 2; others(path); ++copy)
        path = folder / fmt::format("{}_{}{}", name.stem().string(), copy, name.extension().string());
    return path;
}

/// Copies a file to where none is, whole or not at all.
void copyTo(const fs::path& place, const fs::path& file) {
    std::error_code error;
    fs::create_directories(place.parent_path(), error);
    if (fs::exists(place, error))
        return;
    std::ifstream from(file, std::ios::binary);
    if (error || !from)
        fail("{} could not be copied to {}: {}.", file.string(), place.parent_path().string(),
             error ? error.message() : std::strerror(errno));
    TemporaryFile to(place);
    std::vector<char> block(1U << 20U);
    std::int64_t at = 0;
    while (from.read(block.data(), static_cast<std::streamsize>(block.size())), from.gcount() > 0) {
        to.write(block.data(), static_cast<std::size_t>(from.gcount()), at);
        at += from.gcount();
    }
    if (from.bad())
        fail("{} could not be copied to {}: {}.", file.string(), place.parent_path().string(),
             std::strerror(errno));
    to.commit();
}

void leaveOut(RecipeInputs& inputs, const fs::path& file) {
    for (auto& [port, files] : inputs)
        std::erase_if(files, [&](const RecipeFile& one) { return one.path == file; });
    std::erase_if(inputs, [](const auto& entry) { return entry.second.empty(); });
}

bool liesIn(const fs::path& file, const fs::path& folder) {
    const fs::path relative = file.lexically_normal().lexically_relative(folder.lexically_normal());
    return !relative.empty() && *relative.begin() != "..";
}

/// Copies what is several files, such as a volume, and notes where each that is named went.
void copySets(const Recipe& settings, const fs::path& folder, const fs::path& only,
              std::map<fs::path, fs::path>& places) {
    for (const auto& [path, kind] : kindsOf(settings)) {
        const std::vector<fs::path> files = filesOf(kind, path);
        if (files.size() == 1 || places.contains(path) || !(only.empty() || liesIn(path, only)))
            continue;
        const fs::path place = placeForSet(files, folder);
        for (const fs::path& file : files)
            copyTo(place / file.filename(), file);
        places[path] = place / path.filename();
    }
}

} // namespace

std::string Session::toJson(const fs::path& folder) const {
    Json json = {{"session", kFormat},
                 {"settings", Json::parse(settings.toJson(folder))},
                 {"used", Json::array()},
                 {"current", current},
                 {"seedLocked", seedLocked}};
    for (const bool one : used)
        json["used"].push_back(one);
    if (!file.empty())
        putFileName(json, "file", file);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Session Session::fromJson(std::string_view text, const fs::path& folder) {
    const Json json = parseJson(TR("session"), text);
    const JsonField root(TR("session"), json);
    if (!json.is_object())
        failUsage("A session is a JSON object; this is not one.");
    checkFormat(root);
    root.only({"session", "settings", "used", "current", "seedLocked", "file", "fileBytes"});
    Session session;
    session.settings = Recipe::fromJson(root.at("settings").json().dump(), folder);
    const std::size_t count = session.settings.exemplars.size();
    session.used.assign(count, true);
    if (root.has("used")) {
        const JsonField used = root.at("used");
        used.needArray(count, count);
        for (std::size_t i = 0; i < count; ++i)
            session.used[i] = flagFrom(used.at(i));
    }
    if (root.has("current"))
        session.current = std::clamp(root.at("current").whole(), 0, std::max(0, static_cast<int>(count) - 1));
    if (root.has("seedLocked"))
        session.seedLocked = flagFrom(root.at("seedLocked"));
    if (root.has("file"))
        session.file = fileNameFrom(root, "file");
    return session;
}

Session readSession(const fs::path& path) {
    try {
        return Session::fromJson(readText(path), folderOf(path));
    } catch (const UsageError& error) {
        failUsage("{}: {}", path.filename().string(), error.message());
    }
}

Recipe runOf(const Session& session) {
    Recipe recipe = session.settings;
    recipe.exemplars = exemplarsFor(recipe.steps, session.settings.exemplars, session.used,
                                    static_cast<std::size_t>(session.current));
    if (recipe.exemplars.empty() && useOf(recipe.steps).needed)
        failUsage("The session has no exemplar in use.");
    return recipe;
}

Recipe readRun(const fs::path& path) {
    if (path.extension() != ".texloom")
        return readRecipe(path);
    try {
        return runOf(readSession(path));
    } catch (const UsageError& error) {
        failUsage("{}: {}", path.string(), error.message());
    }
}

void writeSession(const fs::path& path, const Session& session) {
    writeText(path, session.toJson(folderOf(path)));
}

Session packSession(const fs::path& path, Session session, const fs::path& only) {
    const fs::path folder = folderOf(path) / (path.stem().string() + "_files");
    std::set<fs::path> taken;
    std::map<fs::path, fs::path> places;
    for (const RecipeFile* file : session.settings.files())
        if (liesIn(file->path, folder)) {
            taken.insert(file->path);
            places[file->path] = file->path;
        }
    copySets(session.settings, folder, only, places);
    for (RecipeFile* file : session.settings.files()) {
        const auto [place, isNew] = places.try_emplace(file->path, file->path);
        if (isNew && (only.empty() || liesIn(file->path, only))) {
            place->second = placeFor(file->path, folder, taken);
            copyTo(place->second, file->path);
        }
        file->path = place->second;
    }
    writeSession(path, session);
    return session;
}

std::vector<fs::path> missingFiles(const Session& session) {
    std::set<fs::path> seen;
    std::vector<fs::path> missing;
    for (const RecipeFile* file : session.settings.files()) {
        std::error_code error;
        if (seen.insert(file->path).second && !fs::is_regular_file(file->path, error))
            missing.push_back(file->path);
    }
    return missing;
}

SessionFiles checkFiles(const Session& session) {
    SessionFiles files{missingFiles(session), {}};
    std::set<fs::path> seen(files.missing.begin(), files.missing.end());
    std::map<fs::path, AssetKind> kinds = kindsOf(session.settings); // an image where it says nothing
    for (const RecipeFile* file : session.settings.files())
        if (seen.insert(file->path).second && !file->hash.empty() &&
            assetHash(kinds[file->path], file->path) != file->hash)
            files.changed.push_back(file->path);
    return files;
}

void relocate(Session& session, const fs::path& from, const fs::path& to) {
    for (RecipeFile* file : session.settings.files()) {
        std::error_code error;
        if (file->path == from) {
            file->path = to;
        } else if (!fs::exists(file->path, error)) {
            const fs::path guess =
                (folderOf(to) / file->path.lexically_relative(folderOf(from))).lexically_normal();
            if (fs::is_regular_file(guess, error))
                file->path = guess;
        }
    }
}

void leaveOut(Session& session, std::size_t exemplar) {
    const auto at = static_cast<std::ptrdiff_t>(exemplar);
    std::vector<RecipeExemplar>& exemplars = session.settings.exemplars;
    exemplars.erase(exemplars.begin() + at);
    session.used.erase(session.used.begin() + at);
    if (session.current > at || session.current == static_cast<int>(exemplars.size()))
        session.current = std::max(0, session.current - 1);
}

void leaveOut(Session& session, const fs::path& file) {
    std::vector<RecipeExemplar>& exemplars = session.settings.exemplars;
    for (std::size_t i = exemplars.size(); i-- > 0;) {
        RecipeExemplar& exemplar = exemplars[i];
        if (exemplar.mask && exemplar.mask->path == file)
            exemplar.mask.reset();
        std::erase_if(exemplar.companions,
                      [&](const RecipeFile& companion) { return companion.path == file; });
        leaveOut(exemplar.inputs, file);
        if (exemplar.image.path == file)
            leaveOut(session, i);
    }
    leaveOut(session.settings.inputs, file);
}

} // namespace texloom
