#include "document/Autosave.h"
#include "window/Languages.h"
#include "window/MessageBar.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "window/Theme.h"
#include "library/Variants.h"
#include "WindowFixture.h"
#include "window/WindowKeeper.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include <QComboBox>
#include <QDialog>
#include <QWheelEvent>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUndoView>

namespace stromar {
namespace {

class DeskTest : public WindowFixture {
protected:
    void drag(QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton) {
        CViewport& view = window.viewport();
        QTest::mousePress(&view, button, {}, from.toPoint());
        for (int i = 1; i <= 4; ++i) {
            const QPointF at = from + (to - from) * i / 4;
            QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, button, {});
            QCoreApplication::sendEvent(&view, &move);
            QTest::qWait(10);
        }
        QTest::mouseRelease(&view, button, {}, to.toPoint());
        QTest::qWait(20);
    }
    QPointF seenAt(const osg::Vec3d& point) { return *window.viewport().overlay().toWidget(point); }
    QString selection() { return window.viewport().overlay().model().selectionText; }
};
class SlowDeskTest : public DeskTest {};

TEST_F(SlowDeskTest, AClickOnTheTrunkTellsAboutItAndOpensItsTab) {
    const QPointF trunk = seenAt({0, 0, 2});
    QTest::mouseClick(&window.viewport(), Qt::LeftButton, {}, trunk.toPoint());
    EXPECT_EQ(window.panel().tabs().currentIndex(), window.panel().tabOf(Group::Trunk));
    EXPECT_TRUE(selection().startsWith(QLatin1String("Trunk, stem 1 of 1\nLength 1"))) << selection().toStdString();
    EXPECT_EQ(window.viewport().overlay().model().selection.lines.size(), 1u);
    window.document().setValue(paramRef("Seed"), 14, 0);
    ASSERT_TRUE(showsNow(Model::Full));
    EXPECT_TRUE(selection().startsWith(QLatin1String("Trunk"))) << "the trunk of the next tree";
    action("stop")->trigger();
    EXPECT_TRUE(selection().isEmpty());
}

TEST_F(SlowDeskTest, AClickOnALeafAndOnABranch) {
    const auto click = [&] {
        window.viewport().lookFrom(0, 0);
        for (int y = 60; y < window.viewport().height() - 60 && selection().isEmpty(); y += 20)
            QTest::mouseClick(&window.viewport(), Qt::LeftButton, {}, {window.viewport().width() / 2 + 37, y});
    };
    click();
    EXPECT_TRUE(selection().startsWith(QLatin1String("Leaf "))) << selection().toStdString();
    EXPECT_EQ(window.panel().tabs().currentIndex(), window.panel().tabOf(Group::Leaves));
    action("stop")->trigger();
    action("bare")->trigger();
    click();
    EXPECT_TRUE(selection().startsWith(QLatin1String("Branches"))) << selection().toStdString();
    EXPECT_TRUE(selection().contains(QLatin1String("\nOn "))) << "its parent";
}

TEST_F(SlowDeskTest, ADraggedHandleOfTheEnvelopeIsOneStep) {
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Pruning));
    window.document().setValue(paramRef("PruneRatio"), 1, 0);
    ASSERT_TRUE(showsNow(Model::Full));
    const int steps = window.document().history().count();
    const double before = value("PruneWidth");
    const QPointF handle = window.viewport().overlay().handlePlace(0);
    ASSERT_TRUE(window.viewport().rect().contains(handle.toPoint()));
    EXPECT_EQ(window.viewport().overlay().handleAt(handle), std::optional<std::size_t>(0));
    const QImage pictureBefore = picture();
    drag(handle, handle - QPointF(60, 0));
    EXPECT_LT(value("PruneWidth"), before - 0.05);
    EXPECT_EQ(window.document().history().count(), steps + 1);
    EXPECT_NEAR(window.viewport().overlay().handlePlace(0).x(), handle.x() - 60, 4) << "it follows the mouse";
    EXPECT_TRUE(showsNow(Model::Full));
    EXPECT_NE(picture(), pictureBefore);
    action("undo")->trigger();
    EXPECT_EQ(value("PruneWidth"), before);
}

TEST_F(DeskTest, TheLevelOfTheValueInHandFlashesOnce) {
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Branches, 1));
    window.panel().editor(paramRef("1DownAngle"))->findChild<QSlider*>()->setFocus();
    ASSERT_TRUE(waitFor([&] { return window.viewport().tinted() == 1; }));
    EXPECT_TRUE(waitFor([&] { return window.viewport().tinted() == ViewPart::kNone; })) << "the tree in its own colours";
    window.panel().editor(paramRef("1Rotate"))->findChild<QSlider*>()->setFocus();
    EXPECT_EQ(window.viewport().tinted(), ViewPart::kNone) << "the same level";
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Leaves));
    window.panel().editor(paramRef("LeafScale"))->findChild<QSlider*>()->setFocus();
    ASSERT_TRUE(waitFor([&] { return window.viewport().tinted() == ViewPart::kLeaves; }));
    window.document().setValue(paramRef("LeafScale"), value("LeafScale") * 1.5, 0);
    EXPECT_EQ(window.viewport().tinted(), ViewPart::kNone) << "while it changes";
}

TEST_F(DeskTest, TheValueInHandTintsItsGenerationWhereThatIsWanted) {
    action("tintEdited")->setChecked(true);
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Branches, 1));
    const QImage plain = picture();
    window.panel().editor(paramRef("1DownAngle"))->findChild<QSlider*>()->setFocus();
    ASSERT_TRUE(waitFor([&] { return window.viewport().tinted() == 1; }));
    EXPECT_NE(picture(), plain);
    QTest::qWait(1000);
    EXPECT_EQ(window.viewport().tinted(), 1) << "it stays";
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Leaves));
    window.panel().editor(paramRef("LeafScale"))->findChild<QSlider*>()->setFocus();
    EXPECT_TRUE(waitFor([&] { return window.viewport().tinted() == ViewPart::kLeaves; }));
    action("tintEdited")->setChecked(false);
    EXPECT_EQ(window.viewport().tinted(), ViewPart::kNone);
}

TEST_F(DeskTest, OverlaysAreNoPartOfThePicture) {
    action("recentre")->trigger();
    const CCamera camera = window.viewport().camera();
    const QImage before = window.viewport().picture({300, 200}, ViewLook(), camera);
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Pruning));
    action("statistics")->trigger();
    QTest::qWait(50);
    EXPECT_FALSE(window.viewport().overlay().model().statistics.isEmpty());
    EXPECT_EQ(window.viewport().picture({300, 200}, ViewLook(), camera), before);
    action("statistics")->trigger();
}

TEST_F(DeskTest, APictureMayBeTransparent) {
    const QImage image =
        window.viewport().picture({400, 300}, {.backdrop = Backdrop::Nothing}, window.viewport().camera());
    ASSERT_EQ(image.size(), QSize(400, 300));
    EXPECT_EQ(image.pixelColor(2, 2).alpha(), 0);
    int solid = 0;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 400; ++x) solid += image.pixelColor(x, y).alpha() == 255;
    EXPECT_GT(solid, 3000);
}

TEST_F(SlowDeskTest, SwitchesOfTheView) {
    for (const char* name : {"wireframe", "wireframeOver", "bare", "ground", "backdropLight", "backdropDark", "orthographic"}) {
        const QImage before = picture();
        action(name)->trigger();
        QTest::qWait(30);
        EXPECT_NE(picture(), before) << name;
    }
    EXPECT_FALSE(action("wireframe")->isChecked()) << "wires over the tree took its place";
    for (const char* name : {"wireframeOver", "bare", "ground", "orthographic"}) action(name)->trigger();
    action("backdropSky")->trigger();
    action("trackball")->trigger();
    drag({100, 100}, {220, 260});
    EXPECT_GT(std::abs(window.viewport().camera().right().z()), 0.01) << "turned freely";
    action("trackball")->trigger();
    EXPECT_NEAR(window.viewport().camera().right().z(), 0, 1e-9);
    action("top")->trigger();
    EXPECT_LT(window.viewport().camera().forward().z(), -0.99);
    action("recentre")->trigger();
}

TEST_F(DeskTest, TheMouseMapIsAPreference) {
    const osg::Vec3d home = window.viewport().camera().eye();
    CSettings::instance().set("navigation", QStringLiteral("blender"));
    drag({200, 200}, {300, 200}, Qt::LeftButton);
    EXPECT_LT((window.viewport().camera().eye() - home).length(), 1e-9);
    drag({200, 200}, {300, 200}, Qt::MiddleButton);
    EXPECT_GT((window.viewport().camera().eye() - home).length(), 0.5);
    CSettings::instance().set("navigation", QStringLiteral("stromar"));
}

TEST_F(DeskTest, AnAxisOfTheCrossTurnsTheView) {
    CViewOverlay& overlay = window.viewport().overlay();
    window.viewport().lookFrom(30, 30);
    QPoint found(-1, -1);
    for (int y = 0; y < 110 && found.x() < 0; y += 2)
        for (int x = overlay.width() - 110; x < overlay.width(); x += 2)
            if (const auto axis = overlay.axisAt(QPointF(x, y)); axis && axis->second == 90) found = {x, y};
    ASSERT_GE(found.x(), 0);
    QTest::mouseClick(&window.viewport(), Qt::LeftButton, {}, found);
    EXPECT_LT(window.viewport().camera().forward().z(), -0.99) << "from above";
}

TEST_F(SlowDeskTest, LevelsOfDetailAreSeenAtTheirDistance) {
    const auto detail = [&] { return window.shown()->model->detail; };
    const auto shows = [&](int lod) {
        return waitFor([&] { return !window.busy() && detail()->model == Model::Full && detail()->lod == lod; }, 60000);
    };
    ASSERT_TRUE(shows(0));
    const std::size_t finest = window.shown()->model->triangleCount();
    const double near = window.viewport().camera().distance();
    window.findChild<QAction*>(QStringLiteral("statistics"))->setChecked(true);
    window.findChild<QAction*>(QStringLiteral("lod2"))->trigger();
    ASSERT_TRUE(shows(2));
    EXPECT_LT(window.shown()->model->triangleCount(), finest / 2);
    EXPECT_TRUE(window.findChild<QLabel*>(QStringLiteral("counts"))->text().contains(QLatin1String("Level of detail 2")));
    window.findChild<QAction*>(QStringLiteral("lodDistance"))->trigger();
    const double far = window.viewport().camera().distance();
    EXPECT_GT(far, 2.5 * near) << "the tree fills a quarter of the height";
    EXPECT_LT(far, 6 * near);
    EXPECT_TRUE(window.viewport().overlay().model().statistics.join(QLatin1Char('|')).contains(lengthText(far))) << "as it says";
    window.document().setValue(paramRef("Scale"), 20, 0);
    ASSERT_TRUE(waitFor([&] { return window.shown()->model->params == window.document().params(); }));
    ASSERT_TRUE(shows(2)) << "after the simple one";
    window.findChild<QAction*>(QStringLiteral("lod0"))->trigger();
    ASSERT_TRUE(shows(0));
}

TEST_F(DeskTest, ThePictureComesBackInANewContext) {
    const QImage before = picture();
    emit window.viewport().contextLost();
    ASSERT_TRUE(waitFor([&] { return window.viewport().isVisible(); }));
    QTest::qWait(100);
    EXPECT_EQ(picture().size(), before.size());
    EXPECT_EQ(picture(), before);
}

// Variants

TEST_F(SlowDeskTest, ASheetOfSeedsToChooseFromAndToLike) {
    auto* cell = window.variants().findChild<QToolButton*>(QStringLiteral("seed4"));
    ASSERT_TRUE(waitFor([&] { return !window.busy(); }));
    QTest::qWait(1000);
    EXPECT_TRUE(cell->icon().isNull() && !window.busy()) << "nobody sees them behind another tab";
    dock("variants")->raise();
    ASSERT_TRUE(waitFor([&] { return !cell->icon().isNull(); }, 60000));
    auto* level = window.variants().findChild<QComboBox*>(QStringLiteral("randomiseLevel"));
    EXPECT_EQ(level->focusPolicy(), Qt::StrongFocus);
    QWheelEvent wheel({5, 5}, level->mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(level, &wheel);
    EXPECT_FALSE(wheel.isAccepted()) << "what is behind scrolls";
    EXPECT_EQ(level->currentIndex(), 0);
    cell->click();
    const int seed = window.variants().seeds()[4];
    EXPECT_EQ(value("Seed"), seed);
    EXPECT_EQ(window.document().history().count(), 1);
    for (auto* button : window.variants().findChildren<QToolButton*>())
        if (button->text().contains(QChar(0x2665))) button->click();
    EXPECT_EQ(window.document().params().text.likedSeeds, std::to_string(seed));
    QTemporaryDir folder;
    ASSERT_TRUE(window.files().save(folder.filePath(QStringLiteral("liked.tree"))));
    EXPECT_EQ(CTreeFile::read(folder.filePath(QStringLiteral("liked.tree")).toStdString()).params().text.likedSeeds,
              std::to_string(seed));
}

TEST_F(DeskTest, RandomiseMovesWhatIsNotLocked) {
    auto* level = window.variants().findChild<QComboBox*>(QStringLiteral("randomiseLevel"));
    level->setCurrentText(QStringLiteral("Branches 1"));
    const CParams before = window.document().params();
    window.variants().findChild<QPushButton*>(QStringLiteral("randomise"))->click();
    ASSERT_TRUE(waitFor([&] { return window.document().history().count() > 0; })) << "it is looked for beside the window's work";
    const CParams after = window.document().params();
    EXPECT_NE(weberPenn(before).level[1], weberPenn(after).level[1]);
    EXPECT_EQ(weberPenn(before).level[2], weberPenn(after).level[2]);
    EXPECT_EQ(before.common, after.common);
    WeberPennParams others = weberPenn(after);
    others.level[1] = weberPenn(before).level[1];
    EXPECT_EQ(others, weberPenn(before));
    EXPECT_EQ(window.document().history().count(), 1) << "one step";
}

// Barks

TEST_F(SlowDeskTest, ABarkIsDrawnFromItsRecipe) {
    const ParamRef bark = *findParam("BarkTexture");
    action("bare")->trigger();
    const auto rests = [&] { return showsNow(Model::Full) && waitFor([&] { return !window.busy(); }); };
    window.document().setValue(bark, std::string("bark:birch"), 0);
    ASSERT_TRUE(rests());
    QTest::qWait(50);
    const QImage birch = picture();
    window.document().setValue(bark, std::string("bark:cherry"), 0);
    ASSERT_TRUE(rests());
    QTest::qWait(50);
    EXPECT_NE(picture(), birch);
    window.document().setValue(bark, std::string("bark:chery"), 0);
    EXPECT_TRUE(waitFor([&] { return notice().contains(QLatin1String("did you mean 'cherry'")); }));
    action("undo")->trigger();
    EXPECT_TRUE(showsNow(Model::Full));
    QTemporaryDir folder;
    ASSERT_TRUE(window.files().save(folder.filePath(QStringLiteral("a.tree"))));
    EXPECT_EQ(window.document().params().text.barkTexture, "bark:cherry") << "no path to be moved";
}

// Files

TEST_F(DeskTest, AFileChangedByAnotherProgramIsNoticed) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("shared.tree"));
    ASSERT_TRUE(window.files().save(path));
    QTest::qWait(400);
    EXPECT_FALSE(window.bar().isVisible()) << "our own writing is no news";
    std::string text = readFile(toPath(path));
    text.replace(text.find("Scale = 13"), 10, "Scale = 21");
    writeFile(toPath(path), text);
    ASSERT_TRUE(waitFor([&] { return window.bar().isVisible(); }));
    EXPECT_TRUE(window.bar().text().contains(QLatin1String("shared.tree")));
    window.bar().findChildren<QPushButton*>().front()->click();
    EXPECT_EQ(value("Scale"), 21);
    EXPECT_FALSE(window.bar().isVisible());
}

TEST_F(DeskTest, KeepingOnesOwnAgainstAChangedFileCountsAsAChange) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("shared.tree"));
    ASSERT_TRUE(window.files().save(path));
    std::string text = readFile(toPath(path));
    text.replace(text.find("Scale = 13"), 10, "Scale = 21");
    writeFile(toPath(path), text);
    ASSERT_TRUE(waitFor([&] { return window.bar().isVisible(); }));
    EXPECT_FALSE(window.isWindowModified());
    window.bar().findChildren<QPushButton*>().back()->click();
    EXPECT_TRUE(window.isWindowModified()) << "closing must ask";
    ASSERT_TRUE(window.files().save(path));
    EXPECT_FALSE(window.isWindowModified());
    EXPECT_NE(readFile(toPath(path)).find("Scale = 13"), std::string::npos);
}

TEST_F(DeskTest, WhatIsTypedButNotEnteredIsSaved) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("typed.tree"));
    ASSERT_TRUE(window.files().save(path));
    auto* box = window.panel().editor(paramRef("Scale"))->findChild<QDoubleSpinBox*>();
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("19"));
    EXPECT_EQ(value("Scale"), 13) << "not yet entered";
    action("save")->trigger();
    EXPECT_EQ(weberPenn(CTreeFile::read(toPath(path)).params()).scale, 19);
}

TEST_F(DeskTest, ASecondButtonDoesNotLetGoOfAHandle) {
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Pruning));
    const QPoint handle = window.viewport().overlay().handlePlace(0).toPoint();
    QTest::mousePress(&window.viewport(), Qt::LeftButton, {}, handle);
    const QPointF to = handle - QPoint(30, 0);
    QMouseEvent move(QEvent::MouseMove, to, window.viewport().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window.viewport(), &move);
    EXPECT_TRUE(window.view().held());
    QTest::mousePress(&window.viewport(), Qt::RightButton, {}, to.toPoint());
    QTest::mouseRelease(&window.viewport(), Qt::RightButton, {}, to.toPoint());
    EXPECT_TRUE(window.view().held());
    QTest::mouseRelease(&window.viewport(), Qt::LeftButton, {}, to.toPoint());
    EXPECT_FALSE(window.view().held());
    EXPECT_TRUE(showsNow(Model::Full));
}

TEST_F(DeskTest, FromAboveAHandleChangesTheWidthAlone) {
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Pruning));
    action("top")->trigger();
    const double peak = value("PruneWidthPeak"), width = value("PruneWidth");
    const QPointF handle = window.viewport().overlay().handlePlace(0);
    drag(handle, handle - QPointF(40, 0));
    EXPECT_NEAR(value("PruneWidthPeak"), peak, 0.002);
    EXPECT_LT(value("PruneWidth"), width - 0.02);
    EXPECT_GT(value("PruneWidth"), 0.1);
}

TEST_F(DeskTest, ATreeThatIsDroppedIsOpened) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(presetPath("ca_black_oak"))});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &drop);
    EXPECT_EQ(window.document().path(), presetPath("ca_black_oak"));
}

// Layout, theme, language

TEST_F(DeskTest, ClosedDocksComeBackWithTheLayout) {
    const auto docks = window.findChildren<QDockWidget*>();
    ASSERT_EQ(docks.size(), 7);
    for (QDockWidget* dock : docks) dock->close();
    for (QDockWidget* dock : docks) EXPECT_FALSE(dock->isVisible());
    EXPECT_FALSE(picture().isNull());
    action("resetLayout")->trigger();
    for (const char* name : {"parameters", "presets"})
        EXPECT_TRUE(window.findChild<QDockWidget*>(QLatin1String(name))->isVisible()) << name;
}

TEST_F(DeskTest, TheThemeChangesAtOnce) {
    CSettings::instance().set("theme", QStringLiteral("dark"));
    const auto lightness = [&] { return window.palette().color(QPalette::Window).lightness(); };
    EXPECT_TRUE(waitFor([&] { return lightness() < 100; }));
    CSettings::instance().set("theme", QStringLiteral("light"));
    EXPECT_TRUE(waitFor([&] { return lightness() > 180; }));
}

TEST_F(DeskTest, UnitsAndLanguageAskForANewWindowWithTheSameDocument) {
    window.document().setValue(paramRef("Scale"), 17, 0);
    QSignalSpy wanted(&window, &CMainWindow::rebuildWanted);
    CSettings::instance().set("units", QStringLiteral("ft"));
    EXPECT_EQ(wanted.count(), 1);
    {
        CMainWindow other(SizeLimits(), window.sharedDocument());
        auto* box = other.panel().editor(paramRef("Scale"))->findChild<QDoubleSpinBox*>();
        EXPECT_NEAR(box->value(), 17 / 0.3048, 0.01);
        EXPECT_TRUE(box->suffix().contains(QLatin1String("ft")));
        box->setValue(20 / 0.3048);
        EXPECT_NEAR(value("Scale"), 20, 0.01);
        other.document().history().undo();
        EXPECT_EQ(value("Scale"), 17);
    }
    CSettings::instance().set("units", QStringLiteral("m"));
}

TEST(WindowKeeper, AnotherLanguageKeepsDocumentAndHistory) {
    CWindowKeeper keeper;
    keeper.window().show();
    ASSERT_TRUE(keeper.window().files().open(presetPath("quaking_aspen")));
    keeper.window().document().setValue(paramRef("Scale"), 17, 0);
    QTimer::singleShot(100, [&] { // as a user: in the dialog, which closes afterwards
        auto* dialog = QApplication::activeModalWidget();
        auto* choice = dialog->findChild<QComboBox*>(QStringLiteral("language"));
        choice->setCurrentIndex(choice->findData(QStringLiteral("cs")));
        emit choice->activated(choice->currentIndex());
        QTest::qWait(50);
        static_cast<QDialog*>(dialog)->accept();
    });
    keeper.window().showPreferences();
    ASSERT_TRUE(waitFor([&] {
        return keeper.window().findChild<QAction*>(QStringLiteral("save"))->text() == QStringLiteral("&Uložit");
    }));
    EXPECT_TRUE(keeper.window().isVisible());
    EXPECT_TRUE(keeper.window().isWindowModified());
    EXPECT_EQ(keeper.window().document().path(), presetPath("quaking_aspen"));
    EXPECT_EQ(keeper.window().panel().tabs().tabText(1), QStringLiteral("Kmen"));
    keeper.window().findChild<QAction*>(QStringLiteral("undo"))->trigger();
    EXPECT_EQ(paramRef("Scale").get(keeper.window().document().params()), 13);
    ASSERT_TRUE(waitFor([&] { return keeper.window().shown() != nullptr; }));
    CSettings::instance().set("language", QStringLiteral("en"));
    EXPECT_TRUE(waitFor([&] {
        return keeper.window().findChild<QAction*>(QStringLiteral("save"))->text() == QStringLiteral("&Save");
    }));
}

TEST_F(DeskTest, HistoryIsListed) {
    window.document().setValue(paramRef("Scale"), 17, 0);
    window.document().setValue(paramRef("Ratio"), 0.03, 0);
    const auto* list = window.findChild<QUndoView*>();
    ASSERT_TRUE(list);
    EXPECT_EQ(list->model()->rowCount(), 3);
    window.document().history().setIndex(0);
    EXPECT_EQ(value("Scale"), 13);
}

// Crash

TEST(Crash, AKilledProgramsChangesAreRestored) {
    QProcess victim;
    victim.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--be-killed")});
    ASSERT_TRUE(waitFor([&] { return victim.readAllStandardOutput().contains("kept"); }, 60000));
    const auto whileAlive = CAutosave::leftovers(CAutosave::standardFolder());
    EXPECT_TRUE(whileAlive.empty()) << "its program lives";
    victim.kill(); // kill -9
    victim.waitForFinished();
    const auto left = CAutosave::leftovers(CAutosave::standardFolder());
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].path, presetPath("quaking_aspen"));

    CMainWindow window;
    window.show();
    QTimer poll;
    QString question;
    QObject::connect(&poll, &QTimer::timeout, &poll, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box) return;
        poll.stop();
        question = box->text();
        box->buttons().front()->click(); // Restore
    });
    poll.start(20);
    window.files().offerRestore();
    EXPECT_TRUE(question.contains(QLatin1String("quaking_aspen.tree"))) << question.toStdString();
    EXPECT_EQ(paramRef("Scale").get(window.document().params()), 17);
    EXPECT_EQ(window.document().path(), presetPath("quaking_aspen"));
    EXPECT_TRUE(window.isWindowModified()) << "it is not saved yet";
    EXPECT_TRUE(CAutosave::leftovers(CAutosave::standardFolder()).empty());
    EXPECT_TRUE(QFile::exists(window.files().autosave().file())) << "kept again";
    window.document().history().undo();
    QTest::qWait(50);
    EXPECT_TRUE(waitFor([&] { return !QFile::exists(window.files().autosave().file()); })) << "nothing to keep";
}

} // namespace
} // namespace stromar
