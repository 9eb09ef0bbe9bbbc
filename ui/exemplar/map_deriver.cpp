#include "ui/exemplar/map_deriver.h"

#include "core/analysis/derived_maps.h"
#include "core/base/error.h"
#include "ui/common/background.h"
#include "ui/common/shortcuts.h"
#include "ui/common/text.h"
#include "ui/exemplar/material.h"

#include <QAction>
#include <QDateTime>
#include <QDir>

#include <algorithm>

namespace texloom::ui {

namespace {

/// The picture of an exemplar that holds this, before its edits; null if none does.
const ExemplarFile* sourceIn(const RunExemplar& exemplar, MapRole from) {
    const RunExemplar& original = exemplar.original();
    if (from == MapRole::Color)
        return &original.image;
    const auto found =
        std::find_if(original.companions.begin(), original.companions.end(), [from](const ExemplarFile& map) {
            return map.role == from || (isNormal(map.role) && isNormal(from));
        });
    return found != original.companions.end() ? &*found : nullptr;
}

Image derivedFrom(const ExemplarFile& source, MapRole made) {
    switch (made) {
    case MapRole::NormalGl:
        return normalsFromHeight(*source.image, kUsualRelief * source.image->size().longerSide());
    case MapRole::Height:
        return heightFromNormals(*source.image, source.role);
    case MapRole::Roughness:
        return roughnessGuess(*source.image);
    default:
        return occlusionGuess(*source.image);
    }
}

/// The word that a map's file ends with.
std::string wordOf(MapRole made) {
    return made == MapRole::NormalGl    ? "normal"
           : made == MapRole::Height    ? "height"
           : made == MapRole::Roughness ? "roughness"
                                        : "ao";
}

/// Makes the map and writes it to a folder of its own. @return its path. @throws Error
QString write(const ExemplarFile& source, const std::string& name, MapRole made) {
    const QDir folder(
        derivedFolder(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss-zzz"))));
    if (!folder.mkpath(QStringLiteral(".")))
        fail("The folder {} cannot be made; check that there is room.", folder.path().toStdString());
    const QString file = QString::fromStdString(mapNameFrom(name).base + "_" + wordOf(made) + ".exr");
    WriteOptions options;
    options.depth = Depth::Float;
    options.space = "raw";
    writeImage(toPath(folder.filePath(file)), derivedFrom(source, made), options);
    return folder.filePath(file);
}

} // namespace

MapDeriver::MapDeriver(ExemplarStore* store, QWidget* parent)
    : QMenu(tr("Deri&ve a map"), parent), m_store(store) {
    add("deriveNormal", tr("&Normal from height"), tr("Makes the normal map that belongs to the height map."),
        MapRole::NormalGl, MapRole::Height);
    add("deriveHeight", tr("&Height from normal"),
        tr("Integrates the slopes of the normal map; how deep the relief is cannot be told from it."),
        MapRole::Height, MapRole::NormalGl);
    add("deriveRoughness", tr("&Roughness, a first guess"),
        tr("Bright and pale places are taken as smooth, dark ones as rough: a start, to be corrected by "
           "hand."),
        MapRole::Roughness, MapRole::Color);
    add("deriveOcclusion", tr("&Occlusion, a first guess"),
        tr("Places that lie below their surroundings in the height map are darkened."), MapRole::Occlusion,
        MapRole::Height);
    setToolTipsVisible(true);
    connect(m_store, &ExemplarStore::changed, this, &MapDeriver::enable);
    connect(m_store, &ExemplarStore::currentChanged, this, &MapDeriver::enable);
    enable();
}

void MapDeriver::add(const char* name, const QString& text, const QString& help, MapRole made, MapRole from) {
    QAction* const action = addAction(text);
    action->setObjectName(QLatin1String(name));
    setHelp(action, help);
    m_ways.push_back({action, made, from});
    connect(action, &QAction::triggered, this, [this, way = m_ways.back()] { derive(way); });
}

void MapDeriver::enable() {
    const ExemplarEntry* const entry = m_store->current();
    for (const Way& way : m_ways)
        way.action->setEnabled(entry != nullptr && sourceIn(entry->exemplar, way.from) != nullptr);
}

void MapDeriver::derive(const Way& way) {
    const ExemplarEntry* const entry = m_store->current();
    const ExemplarFile* const source = entry != nullptr ? sourceIn(entry->exemplar, way.from) : nullptr;
    if (source == nullptr)
        return;
    inBackground(
        this,
        [source = *source, name = entry->file().name(), made = way.made] {
            return write(source, name, made);
        },
        [this, id = entry->id, made = way.made](const QString& path) {
            m_store->addCompanion(id, path, made);
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

} // namespace texloom::ui
