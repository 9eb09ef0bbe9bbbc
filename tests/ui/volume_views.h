#pragma once

#include "tests/support/volumes.h"
#include "tests/ui/window_fixture.h"
#include "ui/volume/slice_view.h"
#include "ui/volume/volume_page.h"

#include <cmath>
#include <memory>
#include <utility>

namespace texloom::ui {

/// Different everywhere, and not symmetric in its axes.
inline std::shared_ptr<const VolumeSource> endless() {
    return std::make_shared<test::FunctionSource>(
        [](std::int64_t x, std::int64_t y, std::int64_t z, int c) {
            return static_cast<double>((x * 7 + y * 131 + z * 1021 + c * 13) & 1023) / 1023;
        },
        3);
}

inline NamedVolume named(const QString& name, std::shared_ptr<const VolumeSource> source) {
    return {name, {std::move(source), "{\"seed\": 7}"}};
}

/// A page that shows an endless volume.
class VolumeViews : public QObject {
protected:
    void showEndless() {
        m_source = endless();
        m_page = std::make_unique<VolumePage>();
        m_page->resize(760, 560);
        m_page->show();
        m_page->setVolumes({named(QStringLiteral("solid"), m_source)});
        rest();
    }

    const Eigen::Vector3d& cross() const { return m_page->place()->cross(); }

    /// Waits until all that is seen of the slices is there.
    void rest() const {
        for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
            QTRY_VERIFY2_WITH_TIMEOUT(!m_page->slice(axis)->busy(), qPrintable(m_page->message()), 20000);
        if (m_page->solid()->view() == SolidPanel::Oblique)
            QTRY_VERIFY_WITH_TIMEOUT(!m_page->solid()->oblique()->busy(), 20000);
    }

    /// Holds the tile around what is in the middle against the voxels of the source.
    void compare(Axis axis) const {
        const SliceView& view = *m_page->slice(axis);
        const Plane plane = view.plane();
        const Eigen::Vector3d& middle = m_page->place()->middle();
        const int i = static_cast<int>(std::floor(plane.right.dot(middle) / SliceView::kTile));
        const int j = static_cast<int>(std::floor(plane.down.dot(middle) / SliceView::kTile));
        const SliceView::Tile* tile = view.tile(i, j);
        QVERIFY2(tile != nullptr && tile->values, qPrintable(m_page->message()));
        test::TestContext context;
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(63, 1), std::pair(17, 63)}) {
            const Eigen::Vector3d at = plane.at(i * SliceView::kTile + x, j * SliceView::kTile + y);
            const Volume voxel = m_source->sample({static_cast<std::int64_t>(at.x()),
                                                   static_cast<std::int64_t>(at.y()),
                                                   static_cast<std::int64_t>(at.z()),
                                                   {1, 1, 1}},
                                                  context);
            for (int c = 0; c < 3; ++c)
                QCOMPARE(tile->values->values()(x, y, c), voxel(0, 0, 0, c));
        }
    }

    void compareOblique() const {
        const SliceView& view = *m_page->solid()->oblique();
        test::TestContext context;
        QVERIFY(view.tile(0, 0) != nullptr);
        QVERIFY(samePixels(view.tile(0, 0)->values->values(),
                           texloom::slice(*m_source, view.plane(), {64, 64}, context)));
    }

    QTemporaryDir m_folder;
    std::shared_ptr<const VolumeSource> m_source;
    std::unique_ptr<VolumePage> m_page;
};

} // namespace texloom::ui
