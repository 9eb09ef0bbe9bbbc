#pragma once

#include "ui/exemplar/exemplar_store.h"

#include <QMenu>

#include <vector>

namespace texloom::ui {

/// A menu that makes maps which a material lacks from those that it has: normals from heights, heights from
/// normals, first guesses of roughness and occlusion. They become companion maps like any other, and lists
/// say that they were derived.
class MapDeriver : public QMenu {
    Q_OBJECT

public:
    MapDeriver(ExemplarStore* store, QWidget* parent);

Q_SIGNALS:
    void failed(const QString& sentence);

private:
    /// One map that can be made.
    struct Way {
        QAction* action;
        MapRole made;
        MapRole from; ///< Color: the exemplar itself
    };

    void add(const char* name, const QString& text, const QString& help, MapRole made, MapRole from);
    void enable();
    void derive(const Way& way);

    ExemplarStore* m_store;
    std::vector<Way> m_ways;
};

} // namespace texloom::ui
