#include "ui/ports/result_inputs.h"

#include "core/session/export/output_files.h"
#include "ui/common/background.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/port_row.h"
#include "ui/runs/run_desk.h"

namespace texloom::ui {

ResultInputs::ResultInputs(const RunDesk* desk, ExemplarStore* store, OutputGroup* output, QObject* parent)
    : QObject(parent), m_desk(desk), m_store(store), m_output(output) {
    connect(m_output, &OutputGroup::resultWanted, this, &ResultInputs::put);
    const auto follow = [this] { m_output->setResult(m_desk->result()); };
    connect(m_desk, &RunDesk::shown, this, follow);
    connect(m_desk, &RunDesk::emptied, this, follow);
}

void ResultInputs::put(const std::string& port, const std::string& key) {
    if (port == kExemplarPort)
        return open(key);
    const std::vector<Port> ports = m_output->ports();
    if (const Port* found = findPort(ports, port))
        withFile(*found, key, [this, port](const QString& path) { m_output->readInput(port, path); });
}

void ResultInputs::open(const std::string& key) {
    withFile(ports::exemplar(), key, [this](const QString& path) { m_store->open(path); });
}

void ResultInputs::withFile(const Port& port, const std::string& key,
                            const std::function<void(const QString& path)>& done) {
    const auto refuse = [this](const QString& why) { Q_EMIT failed(why); };
    const auto write = [this, port, done, refuse](const std::shared_ptr<const Result>& result) {
        if (const QString why = PortRow::whyNot(port, result); !why.isEmpty())
            return refuse(why);
        inBackground(
            this, [result, port] { return saveInput(*result, port, assetFor(result, port).value()); }, done,
            refuse);
    };
    if (key.empty())
        write(m_desk->result());
    else
        m_desk->history()->want(key, write, refuse);
}

} // namespace texloom::ui
