#pragma once

#include "core/analysis/lattice_detector.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/jobs/task.h"
#include "ui/lattice/given_lattices.h"
#include "ui/lattice/lattice_canvas.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;
class QScrollArea;

namespace texloom::ui {

class CandidateTable;
class Inspector;
class LatticeFields;
class LatticePreviews;
class LatticeSearchForm;
class TaskBar;

/// The workspace for the lattice of the exemplar that is looked at: what is found in the background, drawn
/// over the exemplar and over its correlation with itself, corrected by hand, and then given to the method.
class LatticeTool : public QWidget {
    Q_OBJECT

public:
    LatticeTool(ExemplarStore* store, Inspector* inspector, QWidget* parent = nullptr);

    /// To be called when the exemplars changed: a lattice given for one is not another's.
    void followExemplar();
    /// Looks for the lattice again.
    void detect();
    LatticeCanvas* canvas() const { return m_canvas; }
    LatticeCanvas* correlationCanvas() const { return m_gamma; }
    const std::optional<Lattice>& lattice() const { return m_canvas->lattice(); }
    /// What was found in the exemplar; null before, and while it is looked for.
    const std::shared_ptr<const LatticeAnalysis>& analysis() const { return m_analysis; }
    /// What is drawn over an exemplar, and how it came to be.
    struct Drawn {
        std::shared_ptr<const Image> exemplar;
        std::optional<Lattice> lattice;
        Vec2 origin;
        bool originMoved = false;
        bool edited = false; ///< by hand, since it was found or chosen
        LatticeCriteria criteria;
        bool toBeFound = false; ///< the lattice becomes the best by these criteria unless it was edited
    };
    /// Shows what was drawn before; nothing if another exemplar is looked at by now.
    void restore(const Drawn& drawn);

    /// What is said of it, and whether the method uses the lattice shown.
    QString verdict() const;
    QString useText() const;

Q_SIGNALS:
    /// The method in the inspector follows no lattice; this one does and is asked for.
    void methodWanted(const QString& id);
    /// Vectors or origin were moved, typed, fitted or chosen.
    void drawnAnew(const texloom::ui::LatticeTool::Drawn& before,
                   const texloom::ui::LatticeTool::Drawn& after);

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Detected {
        std::shared_ptr<const LatticeAnalysis> analysis;
        std::shared_ptr<const DisplayPicture> picture;
    };

    QWidget* makePanel();
    QWidget* makeButtons();
    void connectCanvases();
    void take(Detected detected);
    /// The method that uses a lattice: the one chosen, or else the first that follows one.
    const Method* user() const;
    void previewCandidates();
    void searchEdited();
    void lookAtVectors();
    Drawn drawn() const;
    void tellOf(const Drawn& before);
    void rate();
    void setLattice(const std::optional<Lattice>& lattice);
    void setOrigin(Vec2 origin);
    void canvasEdited(LatticeCanvas* canvas, LatticeCanvas::Handle handle);
    void fieldsEdited();
    void refit();
    void use();
    void refreshUse();
    void sayVerdict();
    QString problem() const;
    Vec2 middleOrigin(const Lattice& lattice) const;

    ExemplarStore* m_store;
    Inspector* m_inspector;
    LatticeCanvas* m_canvas;
    LatticeCanvas* m_gamma;
    CandidateTable* m_table;
    LatticeSearchForm* m_search;
    LatticeFields* m_fields;
    LatticePreviews* m_previews;
    QScrollArea* m_scroll = nullptr; ///< around the panel, which it is never narrower than
    QPushButton* m_detect = nullptr;
    QPushButton* m_fit = nullptr;
    QPushButton* m_use = nullptr;
    QLabel* m_verdict;
    QLabel* m_useText;
    TaskBar* m_bar;
    GivenLattices m_given;
    std::shared_ptr<const Image> m_exemplar;
    QString m_name;
    std::shared_ptr<const LatticeAnalysis> m_analysis;
    QString m_failure;
    LatticeCriteria m_criteria;
    struct {
        std::shared_ptr<const LatticeAnalysis> analysis;
        const Method* method = nullptr;
    } m_previewed;       ///< what the candidates' pictures were made from
    bool m_kept = false; ///< the lattice shown stays when the search ends
    bool m_originMoved = false;
    bool m_edited = false;          ///< see Drawn
    std::optional<Lattice> m_shown; ///< before canvas or fields were edited
    Vec2 m_shownOrigin;
    std::optional<LatticeCandidate> m_rating; ///< of vectors set by hand
    Task<Detected> m_detection;
    Task<LatticeCandidate> m_fitting;
    Task<LatticeCandidate> m_ratingTask;
};

} // namespace texloom::ui
