#pragma once

#include <QObject>

namespace texloom::ui {

class ExemplarStore;
class OutputGroup;

/// Shows in the ports that belong to an exemplar what the one that is looked at has for them, and gives it
/// what is put in there.
class ExemplarInputs : public QObject {
    Q_OBJECT

public:
    ExemplarInputs(ExemplarStore* store, OutputGroup* output, QObject* parent);

private:
    void follow();

    ExemplarStore* m_store;
    OutputGroup* m_output;
};

} // namespace texloom::ui
