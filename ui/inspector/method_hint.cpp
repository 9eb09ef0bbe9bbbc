#include "ui/inspector/method_hint.h"

#include "core/job/memory.h"
#include "ui/common/background.h"
#include "ui/common/text.h"

#include <algorithm>

namespace texloom::ui {

namespace {

constexpr std::size_t kNamed = 3;

QString linkTo(const Method& method) {
    return QStringLiteral("<a href=\"%1\">%2</a>")
        .arg(QString::fromStdString(method.id()), translated(method.info().title).toHtmlEscaped());
}

} // namespace

MethodHint::MethodHint(QWidget* parent) : QLabel(parent) {
    setObjectName(QStringLiteral("methodHint"));
    setAccessibleName(tr("Methods that suit the exemplar"));
    setWordWrap(true);
    QSizePolicy narrow(QSizePolicy::Ignored, QSizePolicy::Minimum); // it never widens the window
    narrow.setHeightForWidth(true);
    setSizePolicy(narrow);
    setTextFormat(Qt::RichText);
    setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    hide();
    connect(this, &QLabel::linkActivated, this, &MethodHint::methodWanted);
}

void MethodHint::setExemplar(const std::shared_ptr<const Image>& image) {
    if (image == m_image)
        return;
    m_image = image;
    m_advice.reset();
    hide();
    if (!image || characterBytesFor(image->size(), image->channels()) > availableMemory())
        return;
    inBackground(
        this, [image] { return adviceFor(characterOf(*image)); },
        [this, image](const MethodAdvice& advice) {
            if (image == m_image)
                show(advice);
        },
        [](const QString&) {});
}

std::vector<std::string> MethodHint::order() const {
    std::vector<std::string> ids;
    if (m_advice)
        for (const Method* method : m_advice->methods)
            ids.push_back(method->id());
    return ids;
}

void MethodHint::show(const MethodAdvice& advice) {
    m_advice = advice;
    QStringList names;
    for (std::size_t i = 0; i < std::min(kNamed, advice.methods.size()); ++i)
        names += linkTo(*advice.methods[i]);
    setText(tr("Try first: %1. %2")
                .arg(names.join(QStringLiteral(", ")), translated(advice.reason).toHtmlEscaped()));
    setVisible(!names.isEmpty());
}

} // namespace texloom::ui
