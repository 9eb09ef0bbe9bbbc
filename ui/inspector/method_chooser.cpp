#include "ui/inspector/method_chooser.h"

#include "ui/common/text.h"

#include <QComboBox>
#include <QStandardItemModel>

#include <optional>

namespace texloom::ui {

namespace {

/// A line that cannot be chosen, in bold.
void addHeading(QComboBox* chooser, const QString& text) {
    chooser->addItem(text);
    auto* const model = qobject_cast<QStandardItemModel*>(chooser->model());
    QStandardItem* const item = model->item(chooser->count() - 1);
    item->setFlags(Qt::NoItemFlags);
    QFont font = chooser->font();
    font.setBold(true);
    item->setFont(font);
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

} // namespace texloom::ui
