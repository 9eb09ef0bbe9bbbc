#pragma once

#include "core/methods/method.h"
#include "core/session/run/input_file.h"

#include <QGroupBox>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class QCheckBox;
class QFormLayout;
class QLabel;
class QSpinBox;
class QToolButton;

namespace texloom {
struct Result;
}

namespace texloom::ui {

class AnalogyView;
class PartEditor;
class PortRow;
struct PortLook;
class SeedEdit;

/// What every method is told of the output: its size, the axes on which it wraps, the seed, what goes into
/// its ports, and the number of threads.
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
    /// What goes into the ports that have a row here, but for those of the exemplar.
    InputFiles inputs() const;
    /// Takes the place of all that is there; ports without a row are left out.
    void setInputs(const InputFiles& inputs);
    /// Puts a file into a port, as though the user had chosen it.
    void addInput(const std::string& port, InputFile file);
    /// Reads a file, and puts it into a port.
    void readInput(const std::string& port, const QString& path);
    /// Puts these files in the place of what their ports had, and takes this size, unless it is empty, as one
    /// change of the user's.
    void replaceInputs(const InputFiles& inputs, Size size);
    /// The ports that have a row here.
    std::vector<Port> ports() const;
    /// The exemplar that is looked at, whose own inputs go into ports of its size. @param image null for
    /// none.
    void setExemplar(const QString& name, const std::shared_ptr<const Image>& image,
                     const InputFiles& inputs);
    /// The result that is shown, which can go into ports; null if there is none.
    void setResult(const std::shared_ptr<const Result>& result);

    /// Greys out what the method cannot do, and says so.
    void setMethod(const MethodInfo& info);
    /// Gives each of these ports a row; those that were there already keep their files.
    void setPorts(const std::vector<Port>& ports);
    /// The exemplar that sizes are multiples of. Until the user sets a size, it is twice the exemplar's, but
    /// modest.
    void setExemplarSize(Size size);
    /// Those in use, which position maps point into.
    void setExemplarSizes(const std::vector<Size>& sizes);
    const std::vector<Size>& exemplarSizes() const { return m_exemplars; }
    /// Forgets that the user set a size: that of the next exemplar counts again.
    void forgetSize() { m_sizeChosen = false; }

Q_SIGNALS:
    void edited();
    /// A file chosen here could not be read.
    void failed(const QString& sentence);
    /// A result is to go into this port; see PortRow::resultWanted().
    void resultWanted(const std::string& port, const std::string& key);
    /// What goes into this port is to be painted.
    void paintWanted(const std::string& port);
    /// The picture that the mask of this port belongs to is to be made larger.
    void extendWanted(const std::string& port);
    /// These files are to go into a port that belongs to the exemplar.
    void exemplarInputsEdited(const std::string& port, const std::vector<texloom::InputFile>& files);
    /// Another exemplar is to be opened: this file, or if it is empty one that is yet to be chosen.
    void exemplarWanted(const QString& path);
    /// The result is to be looked at.
    void resultLookedAt();
    /// What the control that the mouse or the focus came to is for.
    void helpWanted(const QString& html);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeSizeRow();
    QWidget* makePresetRow();
    QWidget* makeWrapRow();
    QWidget* makeSeedRow();
    QSpinBox* makeSide(const QString& name);
    void explain(QWidget* widget, const QString& help);
    void multiply(int factor);
    PortRow* makePort(const Port& port, const PortLook& look);
    void addAnalogy(PortRow* a, PortRow* b);
    void showExemplarInputs();

    QSpinBox* m_width;
    QSpinBox* m_height;
    QWidget* m_presets;
    QCheckBox* m_wrapX;
    QCheckBox* m_wrapY;
    SeedEdit* m_seed;
    QToolButton* m_lock;
    PartEditor* m_part;
    QSpinBox* m_threads;
    QFormLayout* m_form = nullptr;
    std::vector<PortRow*> m_ports;
    AnalogyView* m_analogy = nullptr;
    QString m_exemplarName;
    std::shared_ptr<const Image> m_exemplarImage;
    InputFiles m_exemplarInputs;            ///< of the exemplar that is looked at
    std::shared_ptr<const Result> m_result; ///< that is shown
    Size m_exemplar;
    std::vector<Size> m_exemplars;
    bool m_sizeChosen = false;
};

} // namespace texloom::ui
