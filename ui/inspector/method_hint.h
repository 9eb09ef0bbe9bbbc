#pragma once

#include "core/methods/advice.h"

#include <QLabel>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texloom::ui {

/// Names the methods that suit an exemplar best, and why, in one sentence; a click on one chooses it. Hidden
/// while nothing is known.
class MethodHint : public QLabel {
    Q_OBJECT

public:
    explicit MethodHint(QWidget* parent = nullptr);

    /// Looks at a picture beside everything else; null for none.
    void setExemplar(const std::shared_ptr<const Image>& image);
    /// Methods by how well they suit the exemplar, the fittest first; empty while nothing is known.
    std::vector<std::string> order() const;

Q_SIGNALS:
    /// The name of a method was clicked.
    void methodWanted(const QString& id);

private:
    void show(const MethodAdvice& advice);

    std::shared_ptr<const Image> m_image;
    std::optional<MethodAdvice> m_advice;
};

} // namespace texloom::ui
