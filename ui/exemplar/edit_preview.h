#pragma once

#include "core/session/run/run.h"
#include "ui/picture/display_picture.h"

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <memory>
#include <optional>

namespace texloom::ui {

/// Pictures of edits that are still being made in full, at the resolution of a screen.
class EditPreview : public QObject {
    Q_OBJECT

public:
    explicit EditPreview(QObject* parent);
    ~EditPreview() override;

    /// Whether an exemplar is so large that one would wait for its edits.
    static bool worthwhile(Size exemplar);
    /// Makes a picture of an exemplar with these edits; what was under way is called off.
    void make(const RunExemplar& exemplar, const ExemplarEdits& edits);
    void cancel();

Q_SIGNALS:
    void made(const std::shared_ptr<const texloom::ui::DisplayPicture>& picture);

private:
    /// An exemplar's image, small; made once for all its edits.
    struct Reduced {
        std::weak_ptr<const Image> of;
        std::shared_ptr<const Image> image;
        int by = 1;
    };
    struct Made {
        Reduced reduced;
        std::shared_ptr<const DisplayPicture> picture;
    };

    static std::optional<Made> preview(const ExemplarFile& source, const ExemplarEdits& edits,
                                       Reduced reduced, const std::atomic<bool>& stopped);

    Reduced m_reduced;
    std::shared_ptr<std::atomic<bool>> m_stopped; ///< of what is under way
    QThreadPool m_pool;                           ///< of one thread: workers make the edits in full
};

} // namespace texloom::ui
