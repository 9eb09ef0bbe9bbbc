#include "ui/inspector/method_chooser.h"

#include "core/methods/registry.h"
#include "ui/common/text.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QStandardItemModel>

#include <optional>

namespace texloom::ui {

namespace {

/// Makes a line one that cannot be chosen.
QStandardItem* disable(QComboBox* chooser, int line) {
    QStandardItem* const item = qobject_cast<QStandardItemModel*>(chooser->model())->item(line);
    item->setFlags(Qt::NoItemFlags);
    return item;
}

/// A line that cannot be chosen, in bold.
void addHeading(QComboBox* chooser, const QString& text) {
    chooser->addItem(text);
    QFont font = chooser->font();
    font.setBold(true);
    disable(chooser, chooser->count() - 1)->setFont(font);
}

} // namespace

void fillWithMethods(QComboBox* chooser, const std::function<bool(const MethodInfo&)>& offered) {
    std::optional<Category> category;
    for (const Method* method : methodsByCategory()) {
        const MethodInfo& info = method->info();
        if (!offered(info))
            continue;
        if (category != info.category)
            addHeading(chooser, translated(categoryTitle(info.category)));
        category = info.category;
        chooser->addItem(translated(info.title), QString::fromStdString(method->id()));
        chooser->setItemData(
            chooser->count() - 1,
            QStringLiteral("%1\n%2").arg(translated(info.summary), translated(info.citation)),
            Qt::ToolTipRole);
    }
}

void addAbsentMethods(QComboBox* chooser) {
    if (absentMethods().empty())
        return;
    addHeading(chooser, QCoreApplication::translate("MethodChooser", "Not part of this build"));
    for (const AbsentMethod& absent : absentMethods()) {
        chooser->addItem(QString::fromStdString(absent.id));
        chooser->setItemData(chooser->count() - 1, translated(absent.reason), Qt::ToolTipRole);
        disable(chooser, chooser->count() - 1);
    }
}

} // namespace texloom::ui
