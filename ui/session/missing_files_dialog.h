#pragma once

#include "core/session/session.h"

#include <QDialog>
#include <QStringList>

class QLabel;
class QListWidget;
class QPushButton;

namespace texloom::ui {

/// Asks where a session's files went. Those found bring others along that lie beside them; the rest is left
/// out of the session, not lost from its file.
class MissingFilesDialog : public QDialog {
    Q_OBJECT

public:
    MissingFilesDialog(Session session, const QStringList& missing, QWidget* parent = nullptr);

    /// The session with what was found, without what was not.
    Session session() const;
    /// Takes up that a file is now here.
    void found(const QString& missing, const QString& path);
    const QStringList& missing() const { return m_missing; }

private:
    void choose();
    void refresh();

    Session m_session;
    QStringList m_missing;
    QLabel* m_text;
    QListWidget* m_list;
    QPushButton* m_find;
    QPushButton* m_go;
};

} // namespace texloom::ui
