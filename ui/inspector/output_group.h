#pragma once

#include "core/methods/method.h"
#include "core/session/run/exemplar_file.h"

#include <QGroupBox>

#include <cstdint>
#include <optional>

class QCheckBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace texloom::ui {

class ElidedLabel;
class PartEditor;
class SeedEdit;

/// What every method is told of the output: its size, the axes on which it wraps, the seed, an image to start
/// from, and the number of threads.
class OutputGroup : public QGroupBox {
    Q_OBJECT

public:
    explicit OutputGroup(QWidget* parent = nullptr);

    Size outputSize() const;
    void setOutputSize(Size size);
    Wrap wrap() const;
    void setWrap(Wrap wrap);
    std::uint64_t seed() const;
    void setSeed(std::uint64_t seed);
    /// Whether each run keeps the seed.
    bool seedLocked() const;
    void setSeedLocked(bool locked);
    void drawSeed();
    /// 0: one per core.
    int threads() const;
    /// The part of the output that is made; none if it is all.
    std::optional<Region> part() const;
    void setPart(const std::optional<Region>& part);
    const std::optional<ExemplarFile>& initial() const { return m_initial; }
    void setInitial(std::optional<ExemplarFile> image);

    /// Greys out what the method cannot do, and says so.
    void setMethod(const MethodInfo& info);
    /// The exemplar that sizes are multiples of. Until the user sets a size, it is twice the exemplar's, but
    /// modest.
    void setExemplarSize(Size size);
    /// Forgets that the user set a size: that of the next exemplar counts again.
    void forgetSize() { m_sizeChosen = false; }

Q_SIGNALS:
    void edited();
    /// A file chosen here could not be read.
    void failed(const QString& sentence);
    /// What the control that the mouse or the focus came to is for.
    void helpWanted(const QString& html);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeSizeRow();
    QWidget* makePresetRow();
    QWidget* makeWrapRow();
    QWidget* makeSeedRow();
    QWidget* makeInitialRow();
    QSpinBox* makeSide(const QString& name);
    void explain(QWidget* widget, const QString& help);
    void chooseInitial();
    void multiply(int factor);
    void showInitial();

    QSpinBox* m_width;
    QSpinBox* m_height;
    QWidget* m_presets;
    QCheckBox* m_wrapX;
    QCheckBox* m_wrapY;
    SeedEdit* m_seed;
    QToolButton* m_lock;
    ElidedLabel* m_initialName;
    QToolButton* m_chooseInitial;
    QToolButton* m_clearInitial;
    PartEditor* m_part;
    QSpinBox* m_threads;
    std::optional<ExemplarFile> m_initial;
    Size m_exemplar;
    bool m_sizeChosen = false;
};

} // namespace texloom::ui
