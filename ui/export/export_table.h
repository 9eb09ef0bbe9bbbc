#pragma once

#include "core/session/export/export.h"

#include <QTableWidget>

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace texloom::ui {

/// What a depth is called in a list.
QString depthText(Depth depth);

/// Every file of an export before it is written: what it holds, its depth, which can be chosen for companion
/// maps, and whether it replaces one that is there.
class ExportTable : public QTableWidget {
    Q_OBJECT

public:
    explicit ExportTable(QWidget* parent = nullptr);

    /// @param holds says what a file holds.
    void fill(const std::vector<ExportEntry>& entries,
              const std::function<QString(const ExportEntry&)>& holds);
    /// Files that the table says are replaced.
    const std::set<std::filesystem::path>& replaced() const { return m_replaced; }
    /// Of companion files, by their words, where not the preset's.
    const std::map<std::string, Depth>& depths() const { return m_depths; }
    void forgetDepths() { m_depths.clear(); }

private:
    QWidget* depthCell(const ExportEntry& entry);

    std::set<std::filesystem::path> m_replaced;
    std::map<std::string, Depth> m_depths;
};

} // namespace texloom::ui
