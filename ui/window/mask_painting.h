#pragma once

#include "core/methods/port.h"
#include "core/session/run/input_file.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <string>

class QWidget;

namespace texloom::ui {

class ExemplarStore;
class Inspector;
class MaskPainter;
class RunDesk;

/// Lets the masks that go into a method's ports be painted over the pictures that they belong to. They are
/// written to files of their own, which recipes then name with their hashes.
class MaskPainting : public QObject {
    Q_OBJECT

public:
    /// @param window that painters open over.
    MaskPainting(const RunDesk* desk, const ExemplarStore* store, Inspector* inspector, QWidget* window);

Q_SIGNALS:
    /// It cannot be done; the sentence says why.
    void failed(const QString& sentence);

private:
    /// A picture to paint on.
    struct Ground {
        std::shared_ptr<const Image> image;
        std::string name; ///< the mask's file begins with it
        /// Writes or reads it for the port that the mask stands by, which is empty yet; null if it is there.
        std::function<InputFile(const Port&)> file;
    };

    void paint(const std::string& port);
    void open(const Port& mask, const std::optional<Port>& picture, const Ground& ground);
    void keep(const MaskPainter& painter, const Port& mask, const std::optional<Port>& picture,
              const Ground& ground);
    std::optional<Port> pictureBeside(const std::string& mask) const;
    std::optional<Ground> groundFor(const std::optional<Port>& picture) const;

    const RunDesk* m_desk;
    const ExemplarStore* m_store;
    Inspector* m_inspector;
    QWidget* m_window;
};

} // namespace texloom::ui
