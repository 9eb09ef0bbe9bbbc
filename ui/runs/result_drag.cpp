#include "ui/runs/result_drag.h"

#include "core/base/error.h"
#include "core/session/export/export.h"
#include "ui/common/text.h"

#include <QTemporaryDir>
#include <QUrl>

#include <utility>

namespace texloom::ui {

namespace {

const QString kUris = QStringLiteral("text/uri-list");

} // namespace

ResultDrag::ResultDrag(const std::string& key, std::shared_ptr<const Result> result)
    : m_result(std::move(result)) {
    setData(type(), QByteArray::fromStdString(key));
}

std::string ResultDrag::keyOf(const QMimeData& data) {
    return data.data(type()).toStdString();
}

QString ResultDrag::type() {
    return QStringLiteral("application/x-texloom-result");
}

QStringList ResultDrag::formats() const {
    QStringList all = QMimeData::formats();
    if (m_result)
        all += kUris;
    return all;
}

bool ResultDrag::hasFormat(const QString& type) const {
    return formats().contains(type);
}

QVariant ResultDrag::retrieveData(const QString& type, QMetaType metaType) const {
    if (type != kUris || !m_result)
        return QMimeData::retrieveData(type, metaType);
    const QString path = file();
    return path.isEmpty() ? QVariant() : QVariant(QVariantList{QUrl::fromLocalFile(path)});
}

/// Its path; empty where it cannot be written.
QString ResultDrag::file() const {
    static const QTemporaryDir folder; // as long as the program: others may read the file late
    if (!m_file.isEmpty())
        return m_file;
    try {
        ExportOptions options;
        options.image =
            toPath(folder.filePath(QString::fromStdString(m_result->fileName()) + QStringLiteral(".png")));
        options.sidecar = false;
        options.companions = false;
        exportResult(*m_result, options);
        m_file = toQString(options.image);
    } catch (const Error&) { // a drag says nothing; the other program finds no file
    }
    return m_file;
}

} // namespace texloom::ui
