// The timeline and the wind of the window.
#include "WindowFixture.h"
#include "motion/Timeline.h"
#include "motion/WindController.h"
#include "motion/WindPanel.h"
#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>
#include <cmath>

namespace stromar {
namespace {

class MotionTest : public WindowFixture {
protected:
    bool showsAge(double age, Model model) {
        return waitFor([&] {
            const TreeModel& shown = *window.shown()->model;
            return std::abs(shown.age - age) < 1e-9 && shown.detail->model == model;
        });
    }
    template <typename Widget>
    Widget* widget(const char* name) {
        return window.findChild<Widget*>(QLatin1String(name));
    }
    /// Until nothing is drawn for a while; false if it never rests.
    bool rests() {
        return waitFor([&] {
            const int before = window.viewport().framesDrawn();
            QTest::qWait(300);
            return !window.busy() && window.viewport().framesDrawn() == before;
        });
    }
};

TEST_F(MotionTest, TheAgeOfTheSliderIsTheTreesWithTheSimpleModelFirst) {
    std::vector<Model> models;
    QObject::connect(&window, &CMainWindow::modelShown, &window, [&] { models.push_back(window.shown()->model->detail->model); });
    auto* age = widget<QSlider>("age");
    age->setValue(age->maximum() / 2);
    ASSERT_TRUE(showsAge(0.5, Model::Full));
    ASSERT_EQ(models.size(), 2u);
    EXPECT_EQ(models[0], Model::Simple);
    EXPECT_LT(window.shown()->model->tree->stemCount(), 1200u);
    EXPECT_FALSE(window.isWindowModified()) << "the age is no value of the tree";
    EXPECT_FALSE(window.document().history().canUndo());
    EXPECT_NE(widget<QLabel>("ageText")->text().indexOf(QLatin1String("50")), -1);
}

TEST_F(MotionTest, StepsAreTwoPercent) {
    widget<QToolButton>("timelineBack")->click();
    EXPECT_NEAR(window.timeline().age(), 0.98, 1e-9);
    widget<QToolButton>("timelineBack")->click();
    widget<QToolButton>("timelineForward")->click();
    ASSERT_TRUE(showsAge(0.98, Model::Full));
}

TEST_F(MotionTest, PlayingShowsSimpleModelsThatGrowAndThenTheFullOne) {
    std::vector<std::size_t> stems;
    bool simple = true;
    QObject::connect(&window, &CMainWindow::modelShown, &window, [&] {
        if (!window.timeline().playing() && window.timeline().age() >= 1) return;
        stems.push_back(window.shown()->model->tree->stemCount());
        simple = simple && window.shown()->model->detail->model == Model::Simple;
    });
    widget<QComboBox>("timelineSpeed")->setCurrentIndex(4);
    action("play")->trigger();
    EXPECT_TRUE(window.timeline().playing());
    ASSERT_TRUE(waitFor([&] { return !window.timeline().playing(); }, 60000));
    EXPECT_FALSE(action("play")->isChecked());
    EXPECT_TRUE(simple);
    EXPECT_GT(stems.size(), 5u);
    EXPECT_TRUE(std::ranges::is_sorted(stems));
    EXPECT_EQ(stems.front(), 0u);
    EXPECT_TRUE(showsAge(1, Model::Full));
    EXPECT_TRUE(rests()) << "the clock stops";
}

TEST_F(MotionTest, AnotherTreeIsGrown) {
    window.timeline().setAge(0.3);
    ASSERT_TRUE(showsAge(0.3, Model::Full));
    ASSERT_TRUE(window.files().open(presetPath("apple")));
    EXPECT_TRUE(showsNow(Model::Full));
    EXPECT_TRUE(showsAge(1, Model::Full));
}

TEST_F(MotionTest, ExportWritesTheAgeThatIsSeen) {
    const QTemporaryDir folder;
    const auto sizeOf = [&](const char* name) {
        bool ended = false;
        QObject::connect(&window.exporter(), &CExportController::ended, &window, [&] { ended = true; });
        window.exporter().exportTo(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(waitFor([&] { return ended; }));
        return QFileInfo(folder.filePath(QLatin1String(name))).size();
    };
    const qint64 grown = sizeOf("grown.ply");
    window.timeline().setAge(0.4);
    ASSERT_TRUE(showsAge(0.4, Model::Full));
    EXPECT_LT(sizeOf("young.ply"), grown / 2);
    window.timeline().setAge(0.6); // not yet shown: it is made for the file
    const qint64 between = sizeOf("between.ply");
    EXPECT_LT(between, grown);
    EXPECT_GT(between, sizeOf("young.ply") / 2);
}

TEST_F(MotionTest, PicturesFollowOneAnotherWhileTheWindBlowsAndOnlyThen) {
    ASSERT_TRUE(rests()) << "nothing is drawn while nothing moves";
    const QImage still = picture();
    action("wind")->trigger();
    EXPECT_TRUE(widget<QCheckBox>("windSwitch")->isChecked());
    const int before = window.viewport().framesDrawn();
    ASSERT_TRUE(waitFor([&] { return window.viewport().framesDrawn() > before + 5; }));
    EXPECT_NE(picture(), still);
    EXPECT_EQ(window.shown()->model->detail->model, Model::Full) << "no other model was asked for";
    const QImage blown = picture();
    ASSERT_TRUE(waitFor([&] { return picture() != blown; }));
    widget<QCheckBox>("windSwitch")->setChecked(false);
    ASSERT_TRUE(rests());
    EXPECT_FALSE(action("wind")->isChecked());
    EXPECT_EQ(picture(), still) << "still air is the still tree";
}

TEST_F(MotionTest, TheWindGoesOnWhileValuesChange) {
    action("wind")->trigger();
    slider("1DownAngle")->setValue(slider("1DownAngle")->value() + 100);
    ASSERT_TRUE(showsNow(Model::Full));
    EXPECT_TRUE(window.shown()->sway);
    const QImage blown = picture();
    EXPECT_TRUE(waitFor([&] { return picture() != blown; }));
    window.timeline().setAge(0.5);
    ASSERT_TRUE(showsAge(0.5, Model::Full));
    EXPECT_TRUE(window.shown()->sway);
}

TEST_F(MotionTest, PresetsOfTheWindSetAndSwitchItOn) {
    widget<QPushButton>("preset:gale")->click();
    EXPECT_TRUE(window.wind().blowing());
    EXPECT_NEAR(window.wind().wind().strength, 1, 1e-9);
    widget<QPushButton>("preset:breeze")->click();
    EXPECT_LT(window.wind().wind().strength, 0.3);
}

TEST_F(MotionTest, TheArrowInThePictureTurnsTheWind) {
    window.wind().setDirection(0);
    action("wind")->trigger();
    window.viewport().lookFrom(0, 30);
    ASSERT_TRUE(waitFor([&] { return window.viewport().overlay().model().wind.has_value(); }));
    CViewOverlay& overlay = window.viewport().overlay();
    const double reach = overlay.model().reach * 1.15;
    const QPoint tip = overlay.toWidget({reach, 0, 0})->toPoint(), aside = overlay.toWidget({0, -reach, 0})->toPoint();
    ASSERT_TRUE(overlay.isOnWindArrow(tip));
    EXPECT_FALSE(overlay.isOnWindArrow(aside));
    const osg::Vec3d eye = window.viewport().camera().eye();
    QTest::mousePress(&window.viewport(), Qt::LeftButton, {}, tip);
    for (const double part : {0.3, 0.7, 1.0}) {
        const QPointF at = QPointF(tip) * (1 - part) + QPointF(aside) * part;
        QMouseEvent move(QEvent::MouseMove, at, window.viewport().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window.viewport(), &move);
    }
    QTest::mouseRelease(&window.viewport(), Qt::LeftButton, {}, aside);
    EXPECT_NEAR(window.wind().direction(), -90, 3);
    EXPECT_TRUE((window.viewport().camera().eye() - eye).length() < 1e-9) << "the view stays";
}

TEST_F(MotionTest, FlexibilityIsAValueOfTheTree) {
    auto* flexibility = widget<QSlider>("windFlexibility");
    flexibility->setValue(flexibility->maximum());
    EXPECT_EQ(value("Flexibility"), 2);
    EXPECT_TRUE(window.isWindowModified());
    action("undo")->trigger();
    EXPECT_EQ(value("Flexibility"), 1);
    EXPECT_EQ(flexibility->value(), flexibility->maximum() / 2);
}

} // namespace
} // namespace stromar
