#pragma once

#include <QObject>
#include <QPoint>

#include <cstddef>

namespace texloom::ui {

class CompareView;
class ExemplarPanel;
class ExemplarStore;
class Readout;
class ResultView;
class RunDesk;
struct ExemplarEntry;

/// The exemplar that the shown run took its exemplar `index` from; null if it is not open any more.
const ExemplarEntry* openExemplar(const RunDesk& desk, const ExemplarStore& store, std::size_t index);

/// Follows the cursor: over a result's pixel it marks where in the exemplar it came from, over an exemplar's
/// pixel where it went, and reads the values out.
class Hovers : public QObject {
    Q_OBJECT

public:
    struct Places {
        ResultView* results;
        ExemplarPanel* exemplars;
        CompareView* compare;
        Readout* readout;
    };

    Hovers(const RunDesk* desk, const ExemplarStore* store, const Places& places, QObject* parent);

private:
    void overResult(QPoint pixel);
    void overExemplar(QPoint pixel);
    void showCopies(const ExemplarEntry& entry, QPoint pixel);
    void end();

    const RunDesk* m_desk;
    const ExemplarStore* m_store;
    Places m_in;
};

} // namespace texloom::ui
