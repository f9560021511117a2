#include "library/PresetBrowser.h"
#include "library/WelcomeCard.h"
#include "params/ValuesMenu.h"
#include "window/PreferencesDialog.h"
#include "WindowFixture.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Pictures.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include <QClipboard>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>

namespace stromar {
namespace {

class StartTest : public ::testing::Test {
protected:
    void SetUp() override {
        QSettings().remove(QStringLiteral("welcomed"));
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.showStart();
        ASSERT_TRUE(waitFor([&] { return window.shown() && window.shown()->model->params == window.document().params(); }));
    }
    CWelcomeCard* card() { return window.findChild<CWelcomeCard*>(); }
    CMainWindow window;
};

TEST_F(StartTest, ATreeAndACardWithTheWaysToBegin) {
    EXPECT_GT(window.shown()->model->tree->organs(Organ::Leaf)->total, 1000u) << "not a bare pole";
    EXPECT_FALSE(window.document().isModified());
    EXPECT_TRUE(window.document().path().isEmpty());
    EXPECT_EQ(window.document().history().count(), 0);
    ASSERT_TRUE(card());
    ASSERT_TRUE(card()->isVisible());
    const QRect free(0, 0, window.viewport().width(), card()->y());
    for (const osg::Vec3f& point : window.viewport().scene().outline())
        ASSERT_TRUE(free.contains(window.viewport().overlay().toWidget(osg::Vec3d(point))->toPoint())) << "the card hides nothing";
    card()->findChild<QToolButton*>(QStringLiteral("quaking_aspen"))->click();
    EXPECT_EQ(window.document().displayName(), QStringLiteral("quaking_aspen.tree"));
    EXPECT_TRUE(waitFor([&] { return !card(); }));
    EXPECT_FALSE(CWelcomeCard::wanted()) << "not again by itself";
    window.showWelcome();
    EXPECT_TRUE(card());
}

TEST_F(StartTest, EscClosesTheCard) {
    QApplication::setActiveWindow(&window); // a bare X server has no window manager to do it
    QTest::keyClick(&window.viewport(), Qt::Key_Escape);
    EXPECT_TRUE(waitFor([&] { return !card(); }));
    EXPECT_FALSE(CWelcomeCard::wanted());
}

TEST_F(StartTest, ANewTreeOfEveryMethod) {
    const auto methods = card()->findChild<QPushButton*>(QStringLiteral("newTree"))->menu()->actions();
    ASSERT_EQ(methods.size(), qsizetype(treeMethods().size()));
    methods.back()->trigger();
    EXPECT_EQ(&window.document().params().block(), treeMethods().back().block);
}

TEST_F(StartTest, AClickOpensAPresetOnce) {
    QListWidget& list = window.presets().list();
    ASSERT_TRUE(waitFor([&] { return list.count() > 10 && list.isVisible(); }));
    QListWidgetItem* item = list.item(1);
    list.scrollToItem(item);
    const QPoint at = list.visualItemRect(item).center();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, at);
    EXPECT_EQ(window.document().params().text.species, item->text().toStdString());
    EXPECT_EQ(window.document().history().count(), 1);
    QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, at);
    EXPECT_EQ(window.document().history().count(), 1) << "a double click is the same";
}

// Values

class ValuesTest : public WindowFixture {
protected:
    ParamValues take(const ValueSet& set, const char* text) { return valuesFor(set, weberPennBlock(), text); }
    const ValueSet level2{QStringLiteral("Branches 2"), QStringLiteral("Branches"), {paramRef("2DownAngle"), paramRef("2Branches")}};
};

TEST_F(ValuesTest, OfOneLevelGoToAnother) {
    const ParamValues values = take(level2, "1DownAngle = 33\n1Curve = 5\nScale = 3\n");
    ASSERT_EQ(values.size(), 1u) << "what the set has";
    EXPECT_EQ(values[0].first, paramRef("2DownAngle"));
    EXPECT_EQ(values[0].second, ParamValue(33.0));
    EXPECT_TRUE(take(level2, "").empty());
    EXPECT_THROW(take(level2, "1DownAngle = steep\n"), CInputError);
    EXPECT_THROW(take(level2, "what a day\n"), CError);
}

TEST_F(ValuesTest, AreCopiedPastedAndKept) {
    CParams params = window.document().params();
    paramRef("1DownAngle").set(params, 41);
    const ValueSet level1{QStringLiteral("Branches 1"), QStringLiteral("Branches"), {paramRef("1DownAngle"), paramRef("1Branches")}};
    ParamValues pasted;
    const auto assign = [&](const QString&, const ParamValues& values) { pasted = values; };
    QMenu copy;
    addValuesMenu(copy, level1, params, assign, &window);
    copy.actions()[1]->trigger();
    EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QLatin1String("1DownAngle = 41")));
    QMenu paste;
    addValuesMenu(paste, level2, params, assign, &window);
    paste.actions()[2]->trigger();
    ASSERT_EQ(pasted.size(), 2u);
    EXPECT_EQ(pasted[0].first, paramRef("2DownAngle"));
    EXPECT_EQ(pasted[0].second, ParamValue(41.0));
}

TEST_F(ValuesTest, TheTabsButtonPastesAsOneStep) {
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Branches, 2));
    auto* menu = window.panel().findChild<QPushButton*>(QStringLiteral("values"))->menu();
    QGuiApplication::clipboard()->setText(QStringLiteral("1DownAngle = 12\n1Rotate = 100\n"));
    emit menu->aboutToShow();
    const int steps = window.document().history().count();
    menu->actions()[2]->trigger();
    EXPECT_EQ(value("2DownAngle"), 12);
    EXPECT_EQ(value("2Rotate"), 100);
    EXPECT_EQ(window.document().history().count(), steps + 1);
}

// Pictures on the disk

TEST(PictureCache, IsEmptiedByAButton) {
    const auto file = pictureCache() / "own" / "a.png";
    std::filesystem::create_directories(file.parent_path());
    writeFile(file, std::string(5000, 'x'));
    CPreferencesDialog dialog;
    auto* button = dialog.findChild<QPushButton*>(QStringLiteral("emptyCache"));
    ASSERT_TRUE(button);
    const QString before = button->text();
    button->click();
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_NE(button->text(), before);
    EXPECT_EQ(pictureCacheSize(), 0u);
}

} // namespace
} // namespace stromar
