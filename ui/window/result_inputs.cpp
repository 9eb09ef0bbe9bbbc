#include "ui/window/result_inputs.h"

#include "ui/common/background.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/output_group.h"
#include "ui/runs/run_desk.h"

namespace texloom::ui {

namespace {

QString fileFor(const Result& result) {
    const Recipe& recipe = result.plan.recipe;
    const bool data = !recipe.exemplars.empty() && recipe.exemplars.front().image.space == "raw";
    return saveResult(result.synthesis.image, result.fileName(), data ? "raw" : "srgb", recipe);
}

} // namespace

ResultInputs::ResultInputs(const RunDesk* desk, ExemplarStore* store, OutputGroup* output, QObject* parent)
    : QObject(parent), m_desk(desk), m_store(store), m_output(output) {
    connect(m_output, &OutputGroup::resultWanted, this, &ResultInputs::put);
}

void ResultInputs::put(const std::string& port, const std::string& key) {
    withFile(key, [this, port](const QString& path) { m_output->readInput(port, path); });
}

void ResultInputs::open(const std::string& key) {
    withFile(key, [this](const QString& path) { m_store->open(path); });
}

void ResultInputs::withFile(const std::string& key, const std::function<void(const QString& path)>& done) {
    const auto refuse = [this](const QString& why) { Q_EMIT failed(why); };
    const auto write = [this, done, refuse](const std::shared_ptr<const Result>& result) {
        if (result->synthesis.image.empty())
            return refuse(tr("This result has no picture; choose another."));
        inBackground(
            this, [result] { return fileFor(*result); }, done, refuse);
    };
    if (!key.empty())
        m_desk->history()->want(key, write, refuse);
    else if (m_desk->result())
        write(m_desk->result());
    else
        refuse(tr("There is no result yet that could go in here; press Run first, or choose a file."));
}

} // namespace texloom::ui
