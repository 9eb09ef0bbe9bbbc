#pragma once

#include "core/methods/port.h"

#include <QObject>
#include <QString>

#include <functional>
#include <string>

namespace texloom::ui {

class ExemplarStore;
class OutputGroup;
class RunDesk;

/// Lets results be what other runs begin with: inputs of the method, or exemplars. They are written to files
/// of their own, which recipes then name with their hashes. Tells the rows of the ports which result is
/// shown.
class ResultInputs : public QObject {
    Q_OBJECT

public:
    ResultInputs(const RunDesk* desk, ExemplarStore* store, OutputGroup* output, QObject* parent);

    /// Puts what a result has of the port's kind into one of the method's ports, or opens it as an exemplar
    /// if it is theirs. @param key in the history; empty for the result that is shown.
    void put(const std::string& port, const std::string& key);
    /// Opens a result as an exemplar.
    void open(const std::string& key);

Q_SIGNALS:
    /// It cannot be done; the sentence says why.
    void failed(const QString& sentence);

private:
    /// Writes what a result has for a port to files, and hands their path to `done`.
    void withFile(const Port& port, const std::string& key,
                  const std::function<void(const QString& path)>& done);

    const RunDesk* m_desk;
    ExemplarStore* m_store;
    OutputGroup* m_output;
};

} // namespace texloom::ui
