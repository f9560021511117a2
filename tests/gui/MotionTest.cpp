// The timeline and the wind of the window.
#include "WindowFixture.h"
#include "motion/FallController.h"
#include "motion/Recorder.h"
#include "motion/Timeline.h"
#include "motion/WindController.h"
#include "motion/WindPanel.h"
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProgressDialog>
#include <QPushButton>
#include <QSlider>
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
class SlowMotionTest : public MotionTest {};

TEST_F(MotionTest, TheAgeOfTheSliderIsTheTreesWithTheSimpleModelFirst) {
    std::vector<Model> models;
    QObject::connect(&window, &CMainWindow::modelShown, &window,
                     [&] { models.push_back(window.shown()->model->detail->model); });
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

TEST_F(SlowMotionTest, PlayingShowsSimpleModelsThatGrowAndThenTheFullOne) {
    std::vector<std::size_t> stems;
    bool simple = true;
    QObject::connect(&window, &CMainWindow::modelShown, &window, [&] {
        if (!window.timeline().playing() && window.timeline().age() >= 1) return;
        stems.push_back(window.shown()->model->tree->stemCount());
        simple = simple && window.shown()->model->detail->model == Model::Simple;
    });
    widget<QComboBox>("timelineSpeed")->setCurrentIndex(2); // time for some pictures on a slow machine
    action("play")->trigger();
    EXPECT_TRUE(window.timeline().playing());
    ASSERT_TRUE(waitFor([&] { return !window.timeline().playing(); }, 60000));
    EXPECT_FALSE(action("play")->isChecked());
    EXPECT_TRUE(simple);
    EXPECT_GT(stems.size(), 3u);
    EXPECT_TRUE(std::ranges::is_sorted(stems));
    EXPECT_EQ(stems.front(), 0u);
    EXPECT_TRUE(showsAge(1, Model::Full));
    EXPECT_TRUE(rests()) << "the clock stops";
}

TEST_F(SlowMotionTest, AnotherTreeIsGrown) {
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

TEST_F(SlowMotionTest, PicturesFollowOneAnotherWhileTheWindBlowsAndOnlyThen) {
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

TEST_F(MotionTest, AHandOnASliderOfTheWindSwitchesItOn) {
    for (const char* name : {"windStrength", "windDirection", "windGusts", "windFlexibility"}) {
        widget<QCheckBox>("windSwitch")->setChecked(false);
        auto* slider = widget<QSlider>(name);
        slider->setValue(slider->value() - 1);
        EXPECT_FALSE(window.wind().blowing()) << name << ": no hand";
        QTest::keyClick(slider, Qt::Key_Right);
        EXPECT_TRUE(window.wind().blowing()) << name;
    }
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
    EXPECT_EQ(value("Flexibility"), 1.2) << "the aspen's own";
    EXPECT_EQ(flexibility->value(), std::lround(0.6 * flexibility->maximum()));
}

/// Puts a program named ffmpeg first on the path.
class FakeFfmpeg {
public:
    explicit FakeFfmpeg(const char* script) : m_path(qgetenv("PATH")) {
        QFile file(m_folder.filePath(QStringLiteral("ffmpeg")));
        if (*script && file.open(QIODevice::WriteOnly)) {
            file.write(script);
            file.setPermissions(QFile::ReadOwner | QFile::ExeOwner);
        }
        qputenv("PATH", *script ? m_folder.path().toLocal8Bit() + ":" + m_path : m_folder.path().toLocal8Bit());
    }
    ~FakeFfmpeg() { qputenv("PATH", m_path); }

private:
    QTemporaryDir m_folder;
    QByteArray m_path;
};

class RecordTest : public MotionTest {
protected:
    RecordedTree tree() {
        return {window.document().params(),
                window.document().folder(),
                1,
                {.strength = 1},
                Felling{},
                SizeLimits::none(),
                {},
                window.viewport().camera()};
    }
    RecordOptions options(RecordOptions::What what, const char* name) {
        return {what, {64, 80}, 0.8, 5, false, folder.filePath(QLatin1String(name))};
    }
    QStringList files() const { return QDir(folder.path()).entryList(QDir::Files, QDir::Name); }
    QTemporaryDir folder;
};

TEST_F(RecordTest, GrowthIsNumberedPicturesThatEndWithTheGrownTree) {
    window.recorder().record(tree(), options(RecordOptions::What::Growth, "t.png"));
    EXPECT_EQ(files(), QStringList({"t_0001.png", "t_0002.png", "t_0003.png", "t_0004.png"}));
    const QImage first(folder.filePath(QStringLiteral("t_0001.png"))),
        last(folder.filePath(QStringLiteral("t_0004.png")));
    EXPECT_EQ(last.size(), QSize(64, 80));
    EXPECT_NE(first, last);
    EXPECT_NE(notice().indexOf(QLatin1String("4")), -1);
}

TEST_F(RecordTest, WindIsALoopOfPictures) {
    window.recorder().record(tree(), options(RecordOptions::What::Wind, "w.png"));
    ASSERT_EQ(files().size(), 4);
    EXPECT_NE(QImage(folder.filePath(QStringLiteral("w_0001.png"))),
              QImage(folder.filePath(QStringLiteral("w_0003.png"))));
}

TEST_F(RecordTest, AFallIsPicturesToo) {
    window.recorder().record(tree(), options(RecordOptions::What::Fall, "f.png"));
    ASSERT_EQ(files().size(), 4);
    EXPECT_NE(QImage(folder.filePath(QStringLiteral("f_0001.png"))),
              QImage(folder.filePath(QStringLiteral("f_0004.png"))));
}

TEST_F(SlowMotionTest, AFelledTreeFallsAndStandsAgain) {
    ASSERT_TRUE(rests());
    const QImage standing = picture();
    window.fall().fell({0, 1});
    ASSERT_TRUE(waitFor([&] { return window.timeline().playing(); }));
    EXPECT_TRUE(action("fell")->isChecked());
    ASSERT_TRUE(waitFor([&] { return !window.timeline().playing(); }, 60000));
    const double seconds = window.timeline().fallSeconds();
    EXPECT_GT(seconds, 1);
    const QImage lying = picture();
    EXPECT_NE(lying, standing);
    auto* age = widget<QSlider>("age");
    age->setValue(age->maximum() / 2); // scrubbing
    EXPECT_NEAR(window.timeline().fallSeconds(), seconds / 2, 0.02);
    EXPECT_NE(picture(), lying);
    EXPECT_EQ(window.timeline().age(), 1) << "the age stays";
    slider("1DownAngle")->setValue(slider("1DownAngle")->value() + 100); // it stays felled
    ASSERT_TRUE(showsNow(Model::Full));
    EXPECT_TRUE(window.fall().felling());
    EXPECT_GT(window.timeline().fallSeconds(), 0.3);
    action("undo")->trigger();
    ASSERT_TRUE(showsNow(Model::Full));
    action("fell")->setChecked(false);
    ASSERT_TRUE(rests());
    EXPECT_FALSE(window.fall().felling());
    EXPECT_EQ(picture(), standing);
    window.fall().fell({90, 0});
    ASSERT_TRUE(window.files().open(presetPath("apple")));
    EXPECT_FALSE(window.fall().felling()) << "another tree stands";
}

TEST_F(MotionTest, TheLineOfASelectedStemFallsWithIt) {
    ASSERT_TRUE(rests());
    QTest::mouseClick(&window.viewport(), Qt::LeftButton, {},
                      window.viewport().overlay().toWidget({0, 0, 2})->toPoint());
    const auto selected = [&] { return window.viewport().overlay().model().selection.lines.size(); };
    ASSERT_EQ(selected(), 1u);
    const auto orange = [&] { // pixels of the line, left and right of the trunk's place
        const QImage seen = window.viewport().overlay().grab().toImage();
        const double middle = window.viewport().overlay().toWidget({0, 0, 2})->x();
        int beside = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x)
                beside += std::abs(x - middle) > 60 && seen.pixelColor(x, y) == QColor(255, 150, 40);
        return beside;
    };
    EXPECT_EQ(orange(), 0) << "it stands";
    window.fall().fell({0, 0});
    ASSERT_TRUE(waitFor([&] { return window.timeline().playing(); }));
    ASSERT_TRUE(waitFor([&] { return !window.timeline().playing(); }, 60000));
    ASSERT_EQ(selected(), 1u) << "falling changes no selection";
    EXPECT_GT(orange(), 100) << "it lies";
    action("fell")->setChecked(false);
    EXPECT_EQ(orange(), 0) << "it stands again";
}

TEST_F(MotionTest, PicturesOfAgesChooseThem) {
    dock("variants")->raise();
    widget<QToolButton>("age1")->click();
    EXPECT_TRUE(showsAge(0.4, Model::Full));
}

TEST_F(RecordTest, AVideoIsMadeByFfmpegAndReplacesTheOldFileOnlyWhenItIsThere) {
    RecordOptions video = options(RecordOptions::What::Growth, "t.mp4");
    video.video = true;
    QFile old(video.path);
    ASSERT_TRUE(old.open(QIODevice::WriteOnly));
    old.write("older");
    old.close();
    const auto content = [&] {
        QFile file(video.path);
        file.open(QIODevice::ReadOnly);
        return file.readAll();
    };
    {
        const FakeFfmpeg failing("#!/bin/sh\necho no codec >&2\nexit 1\n");
        answerNext(QMessageBox::Ok);
        window.recorder().record(tree(), video);
        EXPECT_NE(question.indexOf(QLatin1String("no codec")), -1) << question.toStdString();
        EXPECT_EQ(content(), "older");
    }
    // Tells which frames it finds by the name with a number in it; the last argument is the file.
    const FakeFfmpeg working("#!/bin/sh\nwhile [ $# -gt 1 ]; do [ \"$1\" = -i ] && frames=$2; shift; done\n"
                             "i=1; while f=$(printf \"$frames\" $i); [ -e \"$f\" ]; do basename \"$f\"; i=$((i+1)); "
                             "done > \"$1\"\n");
    window.recorder().record(tree(), video);
    EXPECT_EQ(content(), "frame_0001.png\nframe_0002.png\nframe_0003.png\nframe_0004.png\n");
    EXPECT_EQ(files(), QStringList("t.mp4"));
}

TEST_F(RecordTest, WithoutFfmpegTheDialogSaysSo) {
    const FakeFfmpeg none("");
    const CRecordDialog without({100, 100}, false, false);
    EXPECT_TRUE(without.findChild<QLabel*>(QStringLiteral("noVideo")));
    EXPECT_EQ(without.findChild<QComboBox*>(QStringLiteral("kind"))->count(), 1);
}

TEST_F(RecordTest, CancellingKeepsWhatIsThereAndSaysHowMany) {
    RecordOptions many = options(RecordOptions::What::Wind, "w.png");
    many.seconds = 60;
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, &window, [&] {
        if (auto* progress = window.findChild<QProgressDialog*>(); progress && files().size() >= 3) progress->cancel();
    });
    poll.start(10);
    window.recorder().record(tree(), many);
    const auto count = files().size();
    EXPECT_GE(count, 3);
    EXPECT_LT(count, 300);
    EXPECT_NE(notice().indexOf(QString::number(count)), -1) << notice().toStdString();
    EXPECT_FALSE(window.recorder().busy());
}

TEST_F(RecordTest, WhatCannotBeWrittenIsTold) {
    RecordOptions nowhere = options(RecordOptions::What::Wind, "w.png");
    nowhere.path = QStringLiteral("/nowhere/w.png");
    answerNext(QMessageBox::Ok);
    window.recorder().record(tree(), nowhere);
    EXPECT_TRUE(asked);
    EXPECT_FALSE(window.recorder().busy());
}

} // namespace
} // namespace stromar
