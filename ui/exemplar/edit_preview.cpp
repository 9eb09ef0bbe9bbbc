#include "ui/exemplar/edit_preview.h"

#include "core/session/run/edited_exemplar.h"
#include "ui/common/background.h"

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kScreen = 1536;                  // pixels of a preview's longer side
constexpr std::int64_t kLarge = 1500LL * 1500; // pixels whose edits take longer than a moment

} // namespace

bool EditPreview::worthwhile(Size exemplar) {
    return exemplar.area() > kLarge;
}

EditPreview::EditPreview(QObject* parent) : QObject(parent) {
    m_pool.setMaxThreadCount(1);
}

EditPreview::~EditPreview() {
    cancel();
    m_pool.waitForDone();
}

/// @return nothing where it was stopped.
std::optional<EditPreview::Made> EditPreview::preview(const ExemplarFile& source, const ExemplarEdits& edits,
                                                      Reduced reduced, const std::atomic<bool>& stopped) {
    const auto check = [&stopped] {
        if (stopped)
            throw Cancelled{};
    };
    try {
        if (!reduced.image) {
            const int by = std::max(1, (source.image->size().longerSide() + kScreen - 1) / kScreen);
            reduced = {source.image, std::make_shared<const Image>(reducedImage(*source.image, by, check)),
                       by};
        }
        EditedPreview small = editedPreview(source, *reduced.image, reduced.by, edits, kScreen, check);
        auto image = std::make_shared<const Image>(std::move(small.image));
        return Made{std::move(reduced), std::make_shared<const DisplayPicture>(std::move(image), small.whole,
                                                                               small.step, nullptr)};
    } catch (const Cancelled&) {
        return std::nullopt;
    }
}

void EditPreview::make(const RunExemplar& exemplar, const ExemplarEdits& edits) {
    cancel();
    const ExemplarFile source = exemplar.original().image;
    if (m_reduced.of.lock() != source.image)
        m_reduced = {};
    m_stopped = std::make_shared<std::atomic<bool>>(false);
    inBackground(
        m_pool, this,
        [source, edits, reduced = m_reduced, stopped = m_stopped] {
            return preview(source, edits, reduced, *stopped);
        },
        [this, stopped = m_stopped](std::optional<Made> small) {
            if (!small || *stopped)
                return;
            m_reduced = std::move(small->reduced);
            Q_EMIT made(small->picture);
        },
        [](const QString&) {}); // the edits themselves say why they cannot be made
}

void EditPreview::cancel() {
    if (m_stopped)
        *m_stopped = true;
}

} // namespace texloom::ui
