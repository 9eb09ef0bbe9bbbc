#include "ui/session/example_sessions.h"

#include "core/methods/method.h"
#include "core/session/session.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/exemplar/resource_folder.h"

#include <QAction>
#include <QFileInfo>

namespace texloom::ui {

ExampleSessions::ExampleSessions(QWidget* parent) : QMenu(tr("Exa&mple sessions"), parent) {
    setObjectName(QStringLiteral("exampleSessions"));
    setToolTipsVisible(true);
    for (const QString& path : files())
        add(path);
    if (isEmpty())
        addAction(tr("None were found beside the program"))->setEnabled(false);
}

QStringList ExampleSessions::files() {
    return resourceFiles(QStringLiteral("sessions"), QStringLiteral("*.texloom"));
}

void ExampleSessions::add(const QString& path) {
    try {
        const Recipe settings = readSession(toPath(path)).settings;
        const MethodInfo& method = findMethod(settings.steps.front().method).info();
        QString exemplar = toQString(settings.exemplars.front().image.path.stem());
        exemplar.replace(QLatin1Char('_'), QLatin1Char(' '));
        QAction* const action = addAction(tr("%1: %2").arg(translated(method.title), exemplar), this,
                                          [this, path] { Q_EMIT chosen(path); });
        action->setObjectName(QStringLiteral("example-") + QFileInfo(path).completeBaseName());
        action->setToolTip(translated(method.summary));
    } catch (const std::exception& error) {
        addAction(sentence(error))->setEnabled(false);
    }
}

} // namespace texloom::ui
