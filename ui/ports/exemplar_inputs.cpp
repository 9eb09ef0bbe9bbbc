#include "ui/ports/exemplar_inputs.h"

#include "ui/common/text.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/inspector/output_group.h"

namespace texloom::ui {

ExemplarInputs::ExemplarInputs(ExemplarStore* store, OutputGroup* output, QObject* parent)
    : QObject(parent), m_store(store), m_output(output) {
    connect(m_store, &ExemplarStore::changed, this, &ExemplarInputs::follow);
    connect(m_store, &ExemplarStore::currentChanged, this, &ExemplarInputs::follow);
    connect(m_store, &ExemplarStore::failed, this, &ExemplarInputs::follow); // shows what did not fit
    connect(m_output, &OutputGroup::exemplarInputsEdited, this,
            [this](const std::string& id, const std::vector<InputFile>& files) {
                const std::vector<Port> ports = m_output->ports();
                const Port* const port = findPort(ports, id);
                if (const ExemplarEntry* entry = m_store->current(); entry != nullptr && port != nullptr)
                    m_store->setInputs(entry->id, id, files, translated(port->title));
            });
}

void ExemplarInputs::follow() {
    const ExemplarEntry* const entry = m_store->current();
    if (entry == nullptr)
        return m_output->setExemplar({}, nullptr, {});
    m_output->setExemplar(QString::fromStdString(entry->file().name()), entry->file().image,
                          entry->exemplar.original().inputs);
}

} // namespace texloom::ui
