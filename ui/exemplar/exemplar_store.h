#pragma once

#include "ui/common/readings.h"
#include "ui/exemplar/exemplar_entry.h"
#include "ui/exemplar/layer_dialog.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texloom::ui {

/// The exemplars that are open, and which of them is looked at. Files are read on a worker: what is asked for
/// here shows in a later signal.
class ExemplarStore : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    const std::vector<ExemplarEntry>& entries() const { return m_entries; }
    /// The one that is looked at, and that methods with a single exemplar use; null if none is open.
    const ExemplarEntry* current() const { return find(m_current); }
    const ExemplarEntry* find(int id) const;
    /// The entry whose pixels these are; null if it is not open any more.
    const ExemplarEntry* find(const std::shared_ptr<const Image>& image) const;
    /// The entry that a recipe means: of the same file with the same edits; null if none is open.
    const ExemplarEntry* find(const RecipeExemplar& wanted) const;
    /// Number of files being read.
    int loading() const { return m_loading; }

    /// Reads an image and adds it, or looks at it again if it is open: it alone is in use then, and others
    /// are mixed in by setChecked(). Of a file with several layers asks which, by layerWanted().
    void open(const QString& path);
    /// Opens several; those whose names say that they belong to another, as bark_normal to bark_albedo or to
    /// an open exemplar bark, become its companion maps.
    void openAll(const QStringList& paths);
    /// Opens a picture with its companion maps.
    void openMaterial(const QString& path, const QStringList& companions);
    /// Takes the place of everything open, as a recipe wants it; replaced() follows.
    void replaceAll(std::vector<RunExemplar> exemplars);
    void remove(int id);
    /// Looks at it. Where one exemplar alone is in use, it is this one from now on.
    void setCurrent(int id);
    /// Whether methods that learn from several use it.
    void setChecked(int id, bool checked);
    /// How much it counts beside the others; see Exemplar::weight.
    void setWeight(int id, double weight);
    /// Reads the file again with its values taken to be in another colour space.
    void setSpace(int id, const QString& space);
    /// Takes another layer of its file; refused where the mask or a companion map is of another size.
    void setLayer(int id, const std::string& layer);
    /// Of a file with several layers asks which, as open() does.
    void setMask(int id, const QString& path);
    void clearMask(int id);
    /// Adds a stroke, one channel of the exemplar's size, to the mask. @param hide or shows again.
    void paintMask(int id, Image stroke, bool hide);
    /// Puts these files in the place of what the exemplar has for a port; see RunExemplar::inputs.
    /// @param what names the change in the undo list.
    void setInputs(int id, const std::string& port, std::vector<InputFile> files, const QString& what);
    /// Adds the maps in a file, several where it packs them. Of a file with several layers asks which.
    void addCompanion(int id, const QString& path);
    /// Adds a map with what it holds.
    void addCompanion(int id, const QString& path, MapRole role);
    void removeCompanion(int id, std::size_t index);
    void setCompanionRole(int id, std::size_t index, MapRole role);
    /// @param what names the change in the undo list. @param key changes of one key that follow each other
    /// are one, such as those of a slider's drag; empty for none.
    void setEdits(int id, const ExemplarEdits& edits, const QString& what, const QString& key = {});
    /// The edits as they will be when all that was asked for is done: pendingChanged() tells when they differ
    /// from those of the entry, and when they do no more.
    ExemplarEdits wantedEdits(int id) const;
    /// Goes back to a state, without telling edited().
    void restoreState(int id, const ExemplarState& state);
    /// The same for setChecked() and ticked().
    void restoreChecked(int id, bool checked);

Q_SIGNALS:
    /// Entries, their order or anything about them changed.
    void changed();
    /// What wantedEdits() says changed, while the entry is as it was.
    void pendingChanged(int id);
    void currentChanged();
    void loadingChanged(int count);
    /// A file holds several layers, and one is to be chosen.
    void layerWanted(const texloom::ui::LayerQuestion& question);
    /// An image was opened by open().
    void opened(int id);
    void replaced();
    /// An exemplar was changed in a way that can be undone.
    void edited(int id, const texloom::ui::ExemplarState& before, const texloom::ui::ExemplarState& after,
                const QString& what, const QString& key);
    /// An exemplar was taken into use or left out, which can be undone.
    void ticked(int id, bool checked, const QString& what);
    /// A file could not be read; the sentence says why. Everything is as it was before, as it is where the
    /// user broke the reading off, of which nothing is said.
    void failed(const QString& sentence);

private:
    /// A change that waits for those before it.
    struct Change {
        int id;
        QString what, key;
        std::function<void(ExemplarState&)> apply; ///< on a worker
        bool undoable;
        std::optional<ExemplarEdits> edits = {}; ///< what it makes of them, where that is known before
    };
    /// What came of reading a file: an exemplar, or a question.
    struct Opening {
        std::optional<ShownExemplar> shown;
        QStringList refused;            ///< companions, each with the reason
        std::vector<LayerEntry> layers; ///< of which one is to be chosen
    };

    static Opening opening(const QString& path, const QStringList& companions,
                           const std::optional<std::string>& layer);
    ExemplarEntry* entry(int id);
    int add(ShownExemplar made);
    void useAlone(int id);
    /// How many methods that learn from several would use.
    int inUse() const;
    const ExemplarEntry* known(const std::filesystem::path& file,
                               const std::optional<std::string>& layer) const;
    void readFirst(const QString& path, const QStringList& companions,
                   const std::optional<std::string>& layer);
    void withLayer(const QString& path, std::function<void(const std::string&)> take);
    void change(Change change);
    void nextChange();
    void endChange();
    bool supersedes(const Change& change) const;
    void brokenOff(int id);
    void changeDone(const Change& change, const ExemplarState& before, ShownExemplar made);
    void beginLoading(int step);
    template <class Work, class Done> void load(const QString& what, Work work, Done done);

    std::vector<ExemplarEntry> m_entries;
    std::deque<Change> m_changes; ///< the first one is under way while m_changing
    bool m_changing = false;
    std::shared_ptr<Readings::Reading> m_making; ///< the change under way
    bool m_superseded = false;                   ///< it was broken off for the one after it
    int m_current = 0;
    int m_lastId = 0;
    int m_loading = 0;
};

} // namespace texloom::ui
