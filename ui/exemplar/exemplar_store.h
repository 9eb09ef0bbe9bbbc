#pragma once

#include "core/session/run.h"
#include "ui/viewers/display_picture.h"

#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>

#include <memory>
#include <optional>
#include <vector>

namespace texloom::ui {

/// One exemplar that is open.
struct ExemplarEntry {
    int id = 0; ///< its own as long as the window lives
    RunExemplar exemplar;
    bool checked = true; ///< whether methods that learn from several use it
    std::shared_ptr<const DisplayPicture> picture;

    const ExemplarFile& file() const { return exemplar.image; }
};

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

    /// Reads an image and adds it, or looks at it again if it is open.
    void open(const QString& path);
    /// Takes the place of everything open, as a recipe wants it; replaced() follows.
    void replaceAll(std::vector<RunExemplar> exemplars);
    void remove(int id);
    void setCurrent(int id);
    void setChecked(int id, bool checked);
    /// Reads the file again with its values taken to be in another colour space.
    void setSpace(int id, const QString& space);
    void setMask(int id, const QString& path);
    void clearMask(int id);

Q_SIGNALS:
    /// Entries, their order or anything about them changed.
    void changed();
    void currentChanged();
    void loadingChanged(int count);
    /// An image was opened by open().
    void opened(int id);
    void replaced();
    /// A file could not be read; the sentence says why. Everything is as it was before.
    void failed(const QString& sentence);

private:
    ExemplarEntry* entry(int id);
    int add(RunExemplar exemplar, std::shared_ptr<const DisplayPicture> picture);
    void beginLoading(int step);
    template <class Work, class Done> void load(Work work, Done done);

    std::vector<ExemplarEntry> m_entries;
    int m_current = 0;
    int m_lastId = 0;
    int m_loading = 0;
};

} // namespace texloom::ui
