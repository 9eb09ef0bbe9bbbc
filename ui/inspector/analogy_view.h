#pragma once

#include "core/image/image.h"

#include <QList>
#include <QWidget>

#include <memory>
#include <string>

class QToolButton;

namespace texloom {
struct Result;
}

namespace texloom::ui {

class ElidedLabel;
class PictureTile;
class PortRow;

/// Pictures that correspond, two by two: A and the exemplar A′ above B and the result B′.
class AnalogyView : public QWidget {
    Q_OBJECT

public:
    /// Takes the cells of A and B over.
    AnalogyView(PortRow* a, PortRow* b, QWidget* parent = nullptr);

    /// Its controls in the order of the tab key.
    const QList<QWidget*>& stops() const { return m_stops; }
    void setExemplar(const QString& name, const std::shared_ptr<const Image>& image);
    /// @param result null for none.
    void setResult(const std::shared_ptr<const Result>& result);

Q_SIGNALS:
    /// A′ was clicked: another exemplar is to be chosen.
    void exemplarWanted();
    /// A file was dropped on A′.
    void exemplarOffered(const QString& path);
    /// A result is to be the exemplar: that of this key, or if it is empty the one that is shown.
    void resultOffered(const std::string& key);
    /// B′ was clicked: the result is to be looked at.
    void resultWanted();

private:
    PictureTile* makeTile(const QString& letter, ElidedLabel* name, const QString& title, const char* object);

    ElidedLabel* m_exemplarName;
    ElidedLabel* m_resultName;
    PictureTile* m_exemplar;
    PictureTile* m_result;
    QToolButton* m_useResult;
    QList<QWidget*> m_stops;
};

} // namespace texloom::ui
