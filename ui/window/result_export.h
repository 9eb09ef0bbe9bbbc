#pragma once

#include <QObject>

class QWidget;

namespace texloom::ui {

class ExportDialog;
class MessageBar;
class RunDesk;

/// Takes the result that is shown out of the program: to files, or to the clipboard.
class ResultExport : public QObject {
    Q_OBJECT

public:
    /// @param window that dialogs belong to.
    ResultExport(const RunDesk* desk, MessageBar* messages, QWidget* window);

    void openDialog();
    /// Writes it as the last one was; asks where that cannot be.
    void exportAgain();
    /// Whether there was one.
    static bool knowsHow();
    void copy();

Q_SIGNALS:
    void failed(const QString& sentence);

private:
    QString folder() const;
    void open(ExportDialog* dialog);
    void write(const ExportDialog& dialog);

    const RunDesk* m_desk;
    MessageBar* m_messages;
    QWidget* m_window;
};

} // namespace texloom::ui
