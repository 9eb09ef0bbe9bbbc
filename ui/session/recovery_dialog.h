#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>

class QListWidget;
class QPushButton;

namespace texloom::ui {

/// Shows all sessions that crashes left, newest first, to be recovered, thrown away or left for later.
class RecoveryDialog : public QDialog {
    Q_OBJECT

public:
    /// @param copies paths, newest first.
    explicit RecoveryDialog(const QStringList& copies, QWidget* parent = nullptr);

Q_SIGNALS:
    /// The session in this file is to be opened; the dialog closes.
    void recoverWanted(const QString& copy);
    /// This one is wanted no more; it has left the list.
    void refused(const QString& copy);

private:
    void describe(const QStringList& copies);
    void recover();
    void throwAway();
    void updateButtons();

    QListWidget* m_list;
    QPushButton* m_recover = nullptr;
    QPushButton* m_throwAway = nullptr;
};

} // namespace texloom::ui
