#include "ui/runs/run_checkpoint.h"

#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/common/translate.h"
#include "ui/runs/result_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLockFile>
#include <QStringList>
#include <QUuid>

#include <algorithm>
#include <exception>
#include <utility>

namespace texloom::ui {

namespace {

const QString kCheckpointEnding = QStringLiteral(".checkpoint");

QString lockOf(const QString& file) {
    return file + QStringLiteral(".lock");
}

QString labelOf(const Recipe& recipe) {
    ResultEntry entry;
    entry.recipe = recipe;
    return labelText(entry);
}

bool allThere(const Recipe& recipe) {
    const auto files = recipe.files();
    return std::all_of(files.begin(), files.end(), [](const RecipeFile* file) {
        std::error_code error;
        return std::filesystem::is_regular_file(file->path, error);
    });
}

/// Plans the run anew and holds the checkpoint against it.
void makeReady(BrokenRun& run, const CheckpointFile& file) {
    QStringList changed;
    const RunInput input = loadRecipe(
        file.recipe, [&](const std::filesystem::path& path) { changed += toQString(path.filename()); });
    if (!changed.isEmpty()) {
        run.refusal = tr("It cannot go on, since these files changed after it began: %1.")
                          .arg(changed.join(QStringLiteral(", ")));
        return;
    }
    RunPlan plan = planRun(input);
    run.checkpoint = resumable(file, plan);
    run.plan = std::move(plan);
}

BrokenRun brokenRun(const QString& path) {
    BrokenRun run;
    run.file = path;
    try {
        const CheckpointFile file = readCheckpoint(toPath(path));
        if (allThere(file.recipe))
            run.recipe = file.recipe;
        run.label = labelOf(file.recipe);
        run.fraction = file.checkpoint.progress;
        makeReady(run, file);
    } catch (const std::exception& error) {
        run.refusal = sentence(error);
    }
    return run;
}

} // namespace

RunCheckpoint::RunCheckpoint(const QString& folder)
    : m_file(folder + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces) +
             kCheckpointEnding) {}

RunCheckpoint::RunCheckpoint(QString file, std::shared_ptr<const Checkpoint> resumed)
    : m_file(std::move(file)), m_resumed(std::move(resumed)) {
    lock();
}

RunCheckpoint::~RunCheckpoint() {
    if (!m_left)
        QFile::remove(m_file);
}

void RunCheckpoint::lock() {
    m_lock = std::make_unique<QLockFile>(lockOf(m_file));
    m_lock->setStaleLockTime(0); // as long as this process lives, however long that is
    m_lock->tryLock();
}

Checkpoints RunCheckpoint::forRun(const Recipe& recipe) {
    return {[this, recipe](const Checkpoint& checkpoint) { write(recipe, checkpoint); }, m_resumed};
}

/// A disk that is full must not end a run that has gone on for an hour.
void RunCheckpoint::write(const Recipe& recipe, const Checkpoint& checkpoint) {
    QString problem;
    try {
        if (!m_lock) {
            QDir().mkpath(QFileInfo(m_file).path());
            lock();
        }
        writeCheckpoint(toPath(m_file), recipe, checkpoint);
    } catch (const std::exception& error) {
        problem = sentence(error);
    }
    const std::lock_guard guard(m_mutex);
    m_told = m_told && !problem.isEmpty();
    m_problem = problem;
}

QString RunCheckpoint::takeProblem() {
    const std::lock_guard guard(m_mutex);
    if (m_problem.isEmpty() || std::exchange(m_told, true))
        return {};
    return m_problem;
}

std::optional<BrokenRun> newestBrokenRun(const QString& folder) {
    const QFileInfoList found =
        QDir(folder).entryInfoList({QLatin1Char('*') + kCheckpointEnding}, QDir::Files, QDir::Time);
    for (const QFileInfo& file : found) {
        QLockFile lock(lockOf(file.filePath()));
        lock.setStaleLockTime(0);
        if (lock.tryLock()) // else the program that makes it is still there
            return brokenRun(file.filePath());
    }
    return {};
}

void discardBrokenRun(const QString& file) {
    QFile::remove(file);
    QFile::remove(lockOf(file));
}

} // namespace texloom::ui
