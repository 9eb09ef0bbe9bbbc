#include "ui/volume/slice_view.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kLargestStep = 8;
constexpr double kFiner = 0.75;                 ///< screen pixels for a voxel from which on each is made
constexpr std::size_t kMostKept = 1200;         ///< tiles; about 80 MB
constexpr std::chrono::milliseconds kBatch{60}; ///< tiles are handed over in parts that take about this long
constexpr int kAbandon = 300; ///< ms that a tile of an earlier slice may take before it is called off
constexpr int kSayBusy = 250; ///< ms

/// A tile of a slice; what lies beyond the volume is transparent.
std::shared_ptr<const SliceView::Tile> tileOf(const VolumeSource& source, const Plane& plane,
                                              JobContext& context) {
    auto tile = std::make_shared<SliceView::Tile>();
    constexpr int kSide = SliceView::kTile;
    std::optional<Image> values = sliceWithin(source, plane, {kSide, kSide}, context);
    if (!values)
        return tile;
    tile->values = std::make_shared<const DisplayPicture>(std::make_shared<const Image>(std::move(*values)));
    tile->picture = tile->values->image().convertToFormat(QImage::Format_ARGB32_Premultiplied);
    const std::optional<Box> bounds = source.bounds();
    if (!bounds)
        return tile;
    constexpr double kRounding = 1e-6;
    const Vector3d least(static_cast<double>(bounds->x), static_cast<double>(bounds->y),
                         static_cast<double>(bounds->z));
    const Vector3d most =
        least + Vector3d(bounds->size.width - 1, bounds->size.height - 1, bounds->size.depth - 1);
    for (int y = 0; y < kSide; ++y) {
        auto* row = reinterpret_cast<QRgb*>(tile->picture.scanLine(y));
        for (int x = 0; x < kSide; ++x) {
            const Vector3d point = plane.at(x, y);
            if ((point - least).minCoeff() < -kRounding || (most - point).minCoeff() < -kRounding)
                row[x] = 0;
        }
    }
    return tile;
}

} // namespace

SliceView::SliceView(std::optional<Axis> axis, VolumeCursor* cursor, QWidget* parent)
    : QWidget(parent), m_axis(axis), m_cursor(cursor) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(axis ? tr("Slice square to %1").arg(QStringLiteral("xyz").at(static_cast<int>(*axis)))
                           : tr("Oblique slice"));
    m_again.setSingleShot(true);
    m_patience.setSingleShot(true);
    m_patience.setInterval(kSayBusy);
    connect(&m_again, &QTimer::timeout, this, [this] {
        m_task.cancel();
        makeTiles();
    });
    connect(&m_patience, &QTimer::timeout, this, [this] {
        m_slow = true;
        update();
    });
    connect(cursor, &VolumeCursor::crossMoved, this, &SliceView::planeChanged);
    connect(cursor, &VolumeCursor::viewMoved, this, [this] {
        update();
        makeTiles();
    });
    connect(cursor, &VolumeCursor::turned, this, &SliceView::planeChanged);
}

SliceView::~SliceView() {
    *m_outdated = true;
}

void SliceView::setSource(std::shared_ptr<const VolumeSource> source) {
    m_task.cancel();
    m_source = std::move(source);
    m_shown.clear();
    m_kept.clear();
    m_order.clear();
    m_shift.setZero();
    planeChanged();
}

Plane SliceView::plane() const {
    if (!m_axis)
        return m_cursor->oblique();
    Vector3d origin = Vector3d::Zero();
    origin[static_cast<int>(*m_axis)] = m_cursor->cross()[static_cast<int>(*m_axis)];
    return axisPlane(*m_axis, origin);
}

std::int64_t SliceView::slice() const {
    return m_axis ? static_cast<std::int64_t>(m_cursor->cross()[static_cast<int>(*m_axis)]) : m_turns;
}

QString SliceView::title() const {
    const auto& cross = m_cursor->cross();
    const auto number = [](double value) {
        return QString::number(static_cast<qint64>(value)).replace(QLatin1Char('-'), QChar(0x2212));
    };
    if (!m_axis)
        return tr("Oblique · %1°, %2°")
            .arg(QString::number(m_cursor->turn(), 'f', 0), QString::number(m_cursor->tilt(), 'f', 0))
            .replace(QLatin1Char('-'), QChar(0x2212));
    switch (*m_axis) {
    case Axis::X:
        return QStringLiteral("YZ · x = %1").arg(number(cross.x()));
    case Axis::Y:
        return QStringLiteral("XZ · y = %1").arg(number(cross.y()));
    case Axis::Z:
        break;
    }
    return QStringLiteral("XY · z = %1").arg(number(cross.z()));
}

Vector2d SliceView::middle() const {
    if (!m_axis)
        return m_shift;
    const Plane here = plane();
    return {here.right.dot(m_cursor->middle()), here.down.dot(m_cursor->middle())};
}

/// Where what is in the middle lies: in the middle of a pixel, also of a widget with an even number of them.
QPointF SliceView::centre() const {
    return QPointF(rect().center()) + QPointF(0.5, 0.5);
}

Vector3d SliceView::spaceAt(QPointF point) const {
    const QPointF from = point - centre();
    const Vector2d at = middle() + Vector2d(from.x(), from.y()) / m_cursor->zoom();
    return plane().at(at.x(), at.y());
}

QPointF SliceView::placeOf(const Vector3d& space) const {
    const Plane here = plane();
    const Vector3d from = space - here.origin;
    const Vector2d at = m_cursor->zoom() * (Vector2d(here.right.dot(from), here.down.dot(from)) - middle());
    return centre() + QPointF(at.x(), at.y());
}

std::pair<Plane, Size> SliceView::seen() const {
    Plane seen = plane();
    const Size size{std::max(1, static_cast<int>(width() / m_cursor->zoom())),
                    std::max(1, static_cast<int>(height() / m_cursor->zoom()))};
    const Vector2d first = middle() - Vector2d(size.width / 2, size.height / 2);
    seen.origin = seen.at(std::round(first.x()), std::round(first.y()));
    return {seen, size};
}

int SliceView::step() const {
    int step = 1;
    while (step < kLargestStep && m_cursor->zoom() * devicePixelRatioF() * step < kFiner)
        step *= 2;
    return step;
}

const SliceView::Tile* SliceView::tile(int i, int j, int step) const {
    const auto found = m_shown.find({step, i, j});
    return found != m_shown.end() && found->second.slice == slice() ? found->second.tile.get() : nullptr;
}

/// The tiles that are seen, those next to the crosshair first.
std::vector<SliceView::Place> SliceView::wanted() const {
    const int step = this->step();
    const double side = static_cast<double>(kTile) * step;
    const Vector2d half = Vector2d(width() / 2.0 + 1, height() / 2.0 + 1) / m_cursor->zoom();
    const Vector2d first = ((middle() - half).array() + 0.5) / side,
                   last = ((middle() + half).array() + 0.5) / side;
    const Plane here = plane();
    const Vector3d from = m_cursor->cross() - here.origin;
    const Vector2d cross = Vector2d(here.right.dot(from), here.down.dot(from)) / side - Vector2d(0.5, 0.5);
    std::vector<std::pair<double, Place>> near;
    for (auto j = static_cast<std::int64_t>(std::floor(first.y())); static_cast<double>(j) <= last.y(); ++j)
        for (auto i = static_cast<std::int64_t>(std::floor(first.x())); static_cast<double>(i) <= last.x();
             ++i)
            near.push_back({(Vector2d(static_cast<double>(i), static_cast<double>(j)) - cross).norm(),
                            Place{step, i, j}});
    std::sort(near.begin(), near.end());
    std::vector<Place> places;
    for (const auto& [distance, place] : near)
        places.push_back(place);
    return places;
}

std::vector<SliceView::Place> SliceView::missing() const {
    if (!m_source || !isVisible())
        return {};
    std::vector<Place> places = wanted();
    std::erase_if(places, [this](const Place& place) {
        const auto found = m_shown.find(place);
        return found != m_shown.end() && found->second.slice == slice();
    });
    return places;
}

void SliceView::planeChanged() {
    if (!m_axis)
        ++m_turns;
    update();
    if (!m_task.running())
        return makeTiles();
    // The tile under way comes to its end, unless it takes long: else nothing would ever be seen of a drag.
    *m_outdated = true;
    if (!m_again.isActive())
        m_again.start(std::max(0, kAbandon - static_cast<int>(m_since.elapsed())));
}

void SliceView::makeTiles() {
    if (m_task.running())
        return;
    m_again.stop();
    const std::int64_t now = slice();
    for (const Place& place : missing())
        if (const auto kept = m_kept.find({now, place}); kept != m_kept.end())
            m_shown[place] = {now, kept->second};
    std::vector<Place> places = missing();
    if (places.empty()) {
        m_patience.stop();
        m_slow = false;
        update();
        Q_EMIT shown();
        return;
    }
    if (!m_patience.isActive() && !m_slow)
        m_patience.start();
    m_since.start();
    m_outdated = std::make_shared<std::atomic<bool>>(false);
    m_task.start(
        {},
        [source = m_source, plane = plane(), places = std::move(places),
         outdated = m_outdated](JobContext& context) {
            const auto until = std::chrono::steady_clock::now() + kBatch;
            std::vector<std::pair<Place, Shared>> made;
            for (const Place& place : places) {
                const auto [step, i, j] = place;
                const double side = static_cast<double>(kTile) * step;
                Plane part = plane;
                part.origin = plane.at(side * static_cast<double>(i), side * static_cast<double>(j));
                part.right *= step;
                part.down *= step;
                made.emplace_back(place, tileOf(*source, part, context));
                if (*outdated || std::chrono::steady_clock::now() > until)
                    break;
            }
            return made;
        },
        [this, now](const std::vector<std::pair<Place, Shared>>& made) { take(now, made); },
        [this](const QString& sentence) {
            m_patience.stop();
            m_slow = false;
            update();
            Q_EMIT failed(sentence);
        });
}

void SliceView::take(std::int64_t slice, const std::vector<std::pair<Place, Shared>>& made) {
    for (const auto& [place, tile] : made) {
        m_shown[place] = {slice, tile};
        if (m_kept.try_emplace({slice, place}, tile).second)
            m_order.emplace_back(slice, place);
    }
    if (m_order.size() > kMostKept) {
        const auto half = m_order.begin() + static_cast<std::ptrdiff_t>(kMostKept / 2);
        for (auto key = m_order.begin(); key != half; ++key)
            m_kept.erase(*key);
        m_order.erase(m_order.begin(), half);
    }
    forgetUnseen();
    update();
    makeTiles();
}

void SliceView::forgetUnseen() {
    const QRect near = rect().adjusted(-width(), -height(), width(), height());
    std::erase_if(m_shown, [&](const auto& shown) { return !near.intersects(rectOf(shown.first)); });
}

QRect SliceView::rectOf(const Place& place) const {
    const auto [step, i, j] = place;
    const double side = static_cast<double>(kTile) * step, half = step / 2.0, zoom = m_cursor->zoom();
    const Vector2d from = middle();
    const QPointF centre = this->centre();
    const auto at = [&](std::int64_t number, double first, double middle) {
        const double widget = zoom * (side * static_cast<double>(number) - half - first) + middle;
        return static_cast<int>(std::lround(std::clamp(widget, -1e6, 1e6)));
    };
    const QPoint first(at(i, from.x(), centre.x()), at(j, from.y(), centre.y()));
    const QPoint beyond(at(i + 1, from.x(), centre.x()), at(j + 1, from.y(), centre.y()));
    return {first, beyond - QPoint(1, 1)};
}

void SliceView::resizeEvent(QResizeEvent*) {
    makeTiles();
}

void SliceView::showEvent(QShowEvent*) {
    makeTiles();
}

} // namespace texloom::ui
