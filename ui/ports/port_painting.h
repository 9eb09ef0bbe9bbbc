#pragma once

#include "core/image/labels.h"
#include "core/methods/port.h"
#include "core/session/run/input_file.h"
#include "ui/picture/display_picture.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <string>

class QWidget;

namespace texloom {
struct Margins;
}

namespace texloom::ui {

class ExemplarStore;
class Inspector;
class LabelPainter;
class MaskPainter;
class Painter;
class RunDesk;

/// Lets what goes into a method's ports be painted: masks over the pictures that they belong to, pictures of
/// flat colours over the exemplar or the result; and lets pictures that a method completes be extended beyond
/// their edges. What is made is written to files of its own, which recipes then name with their hashes.
class PortPainting : public QObject {
    Q_OBJECT

public:
    /// @param window that painters open over.
    PortPainting(const RunDesk* desk, const ExemplarStore* store, Inspector* inspector, QWidget* window);

    /// Asks by how much the picture that the method completes is to be extended.
    void extend();

Q_SIGNALS:
    /// It cannot be done; the sentence says why.
    void failed(const QString& sentence);
    /// What was done, and what comes next.
    void told(const QString& sentence);

private:
    /// A picture to paint on.
    struct Ground {
        std::shared_ptr<const Image> image;
        std::string name;  ///< the mask's file begins with it
        bool data = false; ///< whether its values are no colours
        /// Writes or reads it for the port that the mask stands by, which is empty yet; null if it is there.
        std::function<InputFile(const Port&)> file;
    };
    struct Labels;

    void paint(const std::string& port);
    void paintMask(const Port& mask);
    void openMask(const Port& mask, const std::optional<Port>& picture, const Ground& ground);
    void keepMask(const MaskPainter& painter, const Port& mask, const std::optional<Port>& picture,
                  const Ground& ground);
    void paintLabels(const Port& port);
    void openLabels(const Port& port, const std::string& name, const QString& colours, Labels labels);
    void keepLabels(const LabelPainter& painter, const Port& port, const std::string& name);
    void extendPicture(const std::string& mask);
    void keepExtended(const Port& mask, const Port& picture, const Ground& ground, const Margins& margins);
    void show(Painter* painter, const Port& port, const std::string& name);
    std::optional<Port> pictureBeside(const std::string& mask) const;
    std::optional<Ground> groundFor(const std::optional<Port>& picture) const;

    const RunDesk* m_desk;
    const ExemplarStore* m_store;
    Inspector* m_inspector;
    QWidget* m_window;
};

} // namespace texloom::ui
