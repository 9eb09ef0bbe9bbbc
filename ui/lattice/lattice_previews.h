#pragma once

#include "core/analysis/lattice.h"
#include "core/methods/method.h"
#include "ui/jobs/task.h"
#include "ui/picture/display_picture.h"

#include <QObject>

#include <memory>
#include <vector>

namespace texloom::ui {

/// Small results that lattices would give, all of one exemplar and at one scale, so that they can be
/// compared.
class LatticePreviews : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Makes one result for each lattice, one after another in the background; what was under way is called
    /// off.
    /// @param method that follows a lattice. @param lattices best first.
    void make(const Method& method, std::shared_ptr<const Image> exemplar, std::vector<Lattice> lattices);
    void cancel();
    bool running() const { return m_task.running(); }

Q_SIGNALS:
    void made(int index, const std::shared_ptr<const texloom::ui::DisplayPicture>& picture);
    /// No result can be made with this lattice. @param why a sentence
    void failed(int index, const QString& why);

private:
    void next();

    const Method* m_method = nullptr;
    std::shared_ptr<const Image> m_exemplar;
    std::vector<Lattice> m_lattices;
    std::size_t m_next = 0;
    Task<std::shared_ptr<const DisplayPicture>> m_task;
};

/// Which part of an exemplar previews are made from, how much they shrink it, and how large they become.
struct LatticePreviewFrame {
    Region part;      ///< of the exemplar
    double scale = 1; ///< at most 1
    Size output;      ///< in pixels of the scaled exemplar
};

/// About three tiles of the first lattice that has some, in no more pixels than are made at once, and never
/// so small that a lattice is lost.
/// @param lattices at least one.
LatticePreviewFrame previewFrame(Size exemplar, const std::vector<Lattice>& lattices);

} // namespace texloom::ui
