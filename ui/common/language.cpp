#include "ui/common/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>

namespace texloom::ui {

namespace {

void install(const QLocale& locale, const QString& name, const QString& folder) {
    static QHash<QString, QTranslator*> installed;
    delete installed.take(name); // uninstalls it
    auto* translator = new QTranslator(QCoreApplication::instance());
    if (translator->load(locale, name, QStringLiteral("_"), folder))
        QCoreApplication::installTranslator(translator);
    installed[name] = translator;
}

} // namespace

void useLanguage(const QLocale& locale) {
    install(locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(locale, QStringLiteral("texloom"), QStringLiteral(":/translations"));
}

} // namespace texloom::ui
