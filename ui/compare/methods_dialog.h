#pragma once

#include <QDialog>

#include <string>
#include <vector>

class QCheckBox;
class QListWidget;
class QPushButton;

namespace texloom::ui {

/// Which methods are to be tried beside one another, and at which size. Remembers what was ticked last.
class MethodsDialog : public QDialog {
    Q_OBJECT

public:
    /// @param size of a result in full, in words.
    explicit MethodsDialog(const QString& size, QWidget* parent = nullptr);

    /// Ids of those that are ticked.
    std::vector<std::string> chosen() const;
    /// Whether they are tried at a preview's size.
    bool quick() const;

    void accept() override;

private:
    QListWidget* m_list;
    QCheckBox* m_quick;
    QPushButton* m_start = nullptr;
};

} // namespace texloom::ui
