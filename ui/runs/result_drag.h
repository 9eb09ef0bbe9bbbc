#pragma once

#include "core/session/run/run.h"

#include <QMimeData>

#include <memory>
#include <string>

namespace texloom::ui {

/// A result that is dragged. Within the window it is known by its key; a file manager or another program gets
/// a file, a PNG with its recipe, which is written to a temporary folder only when it is asked for.
class ResultDrag : public QMimeData {
    Q_OBJECT

public:
    /// @param result null where it is not in memory: then other programs get nothing.
    ResultDrag(const std::string& key, std::shared_ptr<const Result> result);

    /// The key of a result that is dragged; empty if something else is.
    static std::string keyOf(const QMimeData& data);
    static QString type();

    QStringList formats() const override;
    bool hasFormat(const QString& type) const override;

protected:
    QVariant retrieveData(const QString& type, QMetaType metaType) const override;

private:
    QString file() const;

    std::shared_ptr<const Result> m_result;
    mutable QString m_file; ///< once it was written
};

} // namespace texloom::ui
