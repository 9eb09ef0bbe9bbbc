#include "core/image/mask_paint.h"
#include "core/session/preset.h"
#include "core/session/run/edited_exemplar.h"
#include "core/session/session.h"
#include "core/tools/edits.h"
#include "tests/core/refusal.h"
#include "tests/core/session/sample_run.h"
#include "tests/core/tools/sample_edits.h"

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

/// A session of two exemplars, the first with mask, companion and an edit, in a folder of its own.
struct SampleSession : SampleRun {
    SampleSession() {
        addCompanion("bark_normal", {48, 44});
        RunExemplar& bark = input.exemplars.front();
        bark.mask = loadMask(write("hidden", {48, 44}, 1));
        bark = edited(bark, {crop(0, 0, 40, 40)});
        input.exemplars.push_back({loadExemplar(write("moss", {40, 40}, 3)), {}, {}});
        Recipe& recipe = session.settings;
        recipe.steps.front().method = "quilting";
        recipe.steps.front().parameters = {{"patch", 12}};
        recipe.size = {64, 60};
        recipe.seed = 7;
        for (const RunExemplar& exemplar : input.exemplars)
            recipe.exemplars.push_back(recipeExemplar(exemplar));
        session.used = {true, false};
        session.current = 1;
        session.seedLocked = false;
    }

    fs::path file = folder / "work.texloom";
    Session session;
};

} // namespace

TEST(Session, ComesBackAsItWasWritten) {
    const SampleSession sample;
    writeSession(sample.file, sample.session);
    const Session again = readSession(sample.file);
    EXPECT_EQ(again.used, sample.session.used);
    EXPECT_EQ(again.current, 1);
    EXPECT_FALSE(again.seedLocked);
    EXPECT_EQ(again.toJson("/"), sample.session.toJson("/"));
    const SessionFiles files = checkFiles(again);
    EXPECT_TRUE(files.missing.empty() && files.changed.empty());
}

TEST(Session, NamesFilesRelativeToItself) {
    const SampleSession sample;
    writeSession(sample.file, sample.session);
    EXPECT_EQ(readText(sample.file).find(sample.folder.path().string()), std::string::npos);
    const TemporaryFolder elsewhere;
    fs::copy(sample.folder.path(), elsewhere / "moved", fs::copy_options::recursive);
    const Session moved = readSession(elsewhere / "moved" / "work.texloom");
    EXPECT_TRUE(checkFiles(moved).missing.empty());
    EXPECT_EQ(moved.settings.exemplars.front().image.path, elsewhere / "moved" / "bark.png");
}

TEST(Session, RunsWithTheExemplarsInUse) {
    SampleSession sample;
    writeSession(sample.file, sample.session);
    const Recipe several = readRun(sample.file);
    ASSERT_EQ(several.exemplars.size(), 1U);
    EXPECT_EQ(several.exemplars.front().image.path, sample.folder / "bark.png");
    EXPECT_TRUE(several.exemplars.front().mask);
    sample.session.settings.steps.front().method = "random-phase";
    sample.session.settings.steps.front().parameters = {};
    const Recipe one = runOf(sample.session);
    ASSERT_EQ(one.exemplars.size(), 1U);
    EXPECT_EQ(one.exemplars.front().image.path, sample.folder / "moss.png");
    sample.session.settings.exemplars.clear();
    EXPECT_THAT([&] { runOf(sample.session); }, usageRefusal("exemplar"));
}

TEST(Session, MayHoldNothingYet) {
    Session empty;
    empty.settings.steps.front().method = "quilting";
    empty.settings.size = {64, 64};
    EXPECT_TRUE(Session::fromJson(empty.toJson("/"), "/").settings.exemplars.empty());
}

TEST(Session, TellsMissingFromChangedAndKeepsTheRest) {
    SampleSession sample;
    fs::create_directory(sample.folder / "new");
    for (const char* name : {"bark.png", "bark_normal.png"})
        fs::rename(sample.folder / name, sample.folder / "new" / name);
    sample.write("moss", {40, 40}, 3, 99);
    const SessionFiles files = checkFiles(sample.session);
    EXPECT_EQ(files.missing.size(), 2U);
    EXPECT_EQ(files.changed, std::vector<fs::path>{sample.folder / "moss.png"});
    Session found = sample.session;
    relocate(found, sample.folder / "bark.png", sample.folder / "new" / "bark.png");
    EXPECT_TRUE(checkFiles(found).missing.empty()) << "the companion lies beside it";
    leaveOut(sample.session, sample.folder / "bark_normal.png");
    EXPECT_TRUE(sample.session.settings.exemplars.front().companions.empty());
    leaveOut(sample.session, sample.folder / "bark.png");
    ASSERT_EQ(sample.session.settings.exemplars.size(), 1U);
    EXPECT_EQ(sample.session.used, std::vector<bool>{false});
    EXPECT_EQ(sample.session.current, 0);
    EXPECT_TRUE(checkFiles(sample.session).missing.empty());
}

TEST(Session, PacksItsFilesBesideIt) {
    const SampleSession sample;
    const TemporaryFolder target;
    fs::create_directory(sample.folder / "other");
    Session twoNames = sample.session;
    fs::copy_file(sample.folder / "moss.png", sample.folder / "other" / "bark.png");
    twoNames.settings.exemplars[1].image.path = sample.folder / "other" / "bark.png";
    packSession(target / "given.texloom", twoNames);
    fs::remove_all(sample.folder.path());
    const Session packed = readSession(target / "given.texloom");
    const SessionFiles files = checkFiles(packed);
    EXPECT_TRUE(files.missing.empty() && files.changed.empty());
    EXPECT_EQ(packed.settings.exemplars[1].image.path, target / "given_files" / "bark_2.png");
    const Session again = packSession(target / "given.texloom", packed);
    EXPECT_EQ(again.toJson("/"), packed.toJson("/"));
}

TEST(Session, PackingLeavesFilesOfOthersAsTheyAre) {
    const SampleSession sample;
    const TemporaryFolder target;
    fs::create_directory(target / "given_files");
    writeText(target / "given_files" / "moss.png", "mine");
    fs::copy_file(sample.folder / "bark.png", target / "given_files" / "bark.png");
    const Session packed = packSession(target / "given.texloom", sample.session);
    EXPECT_EQ(readText(target / "given_files" / "moss.png"), "mine");
    EXPECT_EQ(packed.settings.exemplars[1].image.path, target / "given_files" / "moss_2.png");
    EXPECT_EQ(packed.settings.exemplars[0].image.path, target / "given_files" / "bark.png")
        << "a copy that is there already will do";
    const SessionFiles files = checkFiles(packed);
    EXPECT_TRUE(files.missing.empty() && files.changed.empty());
}

TEST(Session, PacksOnlyWhatLiesInAFolder) {
    const SampleSession sample;
    const TemporaryFolder target;
    Session session = sample.session;
    fs::create_directory(sample.folder / "own");
    fs::rename(sample.folder / "hidden.png", sample.folder / "own" / "hidden.png");
    session.settings.exemplars.front().mask->path = sample.folder / "own" / "hidden.png";
    const Session packed = packSession(target / "work.texloom", session, sample.folder / "own");
    EXPECT_EQ(packed.settings.exemplars.front().mask->path, target / "work_files" / "hidden.png");
    EXPECT_EQ(packed.settings.exemplars.front().image.path, sample.folder / "bark.png");
}

TEST(Session, RefusesWhatIsNone) {
    EXPECT_THAT([] { Session::fromJson("[]", "/"); }, usageRefusal("object"));
    EXPECT_THAT([] { Session::fromJson(R"({"session": 9})", "/"); }, usageRefusal("newer", "9"));
    const SampleSession sample;
    std::string text = sample.session.toJson("/");
    text.replace(text.find("\"current\""), 9, "\"curent\"");
    EXPECT_THAT([&] { Session::fromJson(text, "/"); }, usageRefusal("curent"));
    writeText(sample.file, "{");
    EXPECT_THAT([&] { readSession(sample.file); }, usageRefusal("work.texloom", "JSON"));
}

TEST(Preset, ComesBackAndRefusesANewerOne) {
    const Preset preset{"mine", "Mine", "What I like", {{"quilting", {{"patch", 12}}}}};
    const Preset again = Preset::fromJson("mine", preset.toJson());
    EXPECT_EQ(again.toJson(), preset.toJson());
    EXPECT_THAT([] { Preset::fromJson("a", R"({"preset": 2, "title": "", "summary": "", "steps": []})"); },
                usageRefusal("newer"));
    const TemporaryFolder folder;
    writeText(folder / "mine.json", preset.toJson());
    writeText(folder / "broken.json", "{");
    std::vector<Message> refused;
    const std::vector<Preset> found =
        presetsIn(folder.path(), [&](const Message& sentence) { refused.push_back(sentence); });
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().title, "Mine");
    EXPECT_EQ(refused.size(), 1U);
}

TEST(PaintedMask, LiesWhereItWasPaintedOnTheEditedImage) {
    const Warp warp = warpOf({crop(10, 5, 20, 30), turn(90)}, {48, 44});
    Image stroke(warp.size(), 1);
    for (int y = 4; y < 9; ++y)
        for (int x = 7; x < 11; ++x)
            stroke(x, y, 0) = 1;
    const Image mask = paintedMask(nullptr, {48, 44}, warp, stroke, true);
    int hidden = 0;
    for (int y = 0; y < 44; ++y)
        for (int x = 0; x < 48; ++x)
            hidden += mask(x, y, 0) == 0 ? 1 : 0;
    EXPECT_EQ(hidden, 20);
    // The quarter turn makes (x, y) of the crop's 20 × 30 px (29 - y, x).
    EXPECT_EQ(mask(10 + 4, 5 + 29 - 7, 0), 0);
    EXPECT_EQ(mask(10 + 8, 5 + 29 - 10, 0), 0);
    const Image shown = paintedMask(&mask, {48, 44}, warp, stroke, false);
    EXPECT_TRUE(samePixels(shown, constant({48, 44}, 1, 1)));
}

} // namespace texloom::test
