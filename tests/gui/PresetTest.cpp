#include "library/PresetBrowser.h"
#include "window/QtText.h"
#include "WindowFixture.h"
#include "stromar/params/TreeFile.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/FileSet.h"
#include <QDir>
#include <QLineEdit>
#include <QListWidget>

namespace stromar {
namespace {

class PresetTest : public WindowFixture {
protected:
    QListWidgetItem* item(const char* name) {
        const auto found = window.presets().list().findItems(QLatin1String(name), Qt::MatchExactly);
        return found.isEmpty() ? nullptr : found.front();
    }
};

TEST_F(PresetTest, AreShownWithPicturesAndFound) {
    ASSERT_TRUE(waitFor([&] { return window.presets().list().count() >= 4; }));
    const auto hasPicture = [&] {
        const QImage icon = item("Black Tupelo")->icon().pixmap(112).toImage();
        int green = 0;
        for (int i = 0; i < icon.height(); ++i)
            green += icon.pixelColor(icon.width() / 2, i).green() > icon.pixelColor(icon.width() / 2, i).blue() + 30;
        return green > 10;
    };
    EXPECT_TRUE(waitFor(hasPicture, 60000));
    EXPECT_TRUE(item("Black Tupelo")->toolTip().contains(QLatin1String("Stromar")));
    window.presets().filter().setText(QStringLiteral("weeping"));
    EXPECT_TRUE(item("Black Tupelo")->isHidden());
    EXPECT_FALSE(item("Weeping Willow")->isHidden());
}

TEST_F(PresetTest, KeysOfTheSearchActOnWhatIsFound) {
    ASSERT_TRUE(waitFor([&] { return item("Black Tupelo") && item("Weeping Willow") && !window.busy(); }, 120000));
    QLineEdit& filter = window.presets().filter();
    filter.setText(QStringLiteral("tupelo"));
    EXPECT_EQ(window.presets().list().currentItem(), item("Black Tupelo"));
    QTest::keyClick(&filter, Qt::Key_Return);
    EXPECT_EQ(value("Scale"), 23);
    EXPECT_FALSE(filter.hasFocus()) << "the next key is one of the view";
    filter.setText(QStringLiteral("weeping"));
    QTest::keyClick(&filter, Qt::Key_Down);
    ASSERT_EQ(window.presets().list().currentItem(), item("Weeping Willow"));
    QTest::keyClick(&window.presets().list(), Qt::Key_Return);
    EXPECT_EQ(value("Scale"), weberPenn(CTreeFile::read(toPath(presetPath("weeping_willow"))).params()).scale);
}

TEST_F(PresetTest, ASearchThatFindsNothingSaysSoUntilEsc) {
    ASSERT_TRUE(waitFor([&] { return item("Black Tupelo") != nullptr; }));
    CPresetBrowser& presets = window.presets();
    ASSERT_TRUE(presets.nothing().isHidden());
    presets.filter().setFocus();
    presets.filter().setText(QStringLiteral("baobab"));
    EXPECT_TRUE(presets.nothing().isVisible());
    EXPECT_TRUE(presets.nothing().text().contains(QLatin1String("baobab")));
    QTest::keyClick(&presets.filter(), Qt::Key_Return);
    QTest::keyClick(&presets.filter(), Qt::Key_Escape);
    EXPECT_TRUE(presets.filter().text().isEmpty());
    EXPECT_TRUE(presets.nothing().isHidden());
    EXPECT_TRUE(presets.list().isVisible());
}

TEST_F(PresetTest, KeysOfTheViewWorkInTheList) {
    QListWidget& list = window.presets().list();
    list.setFocus();
    const bool before = action("trackball")->isChecked();
    QTest::keyClick(&list, Qt::Key_T);
    EXPECT_NE(action("trackball")->isChecked(), before);
    action("trackball")->setChecked(before);
}

TEST_F(PresetTest, OpeningOneCanBeUndone) {
    ASSERT_TRUE(waitFor([&] { return item("Black Tupelo") != nullptr; }));
    window.document().setValue(paramRef("Scale"), 17, 0);
    answerNext(QMessageBox::Cancel);
    emit window.presets().list().itemClicked(item("Black Tupelo"));
    EXPECT_FALSE(asked) << "undo brings the changes back";
    EXPECT_EQ(value("Scale"), 23);
    EXPECT_FALSE(window.close());
    EXPECT_TRUE(asked) << "closing would lose them";
    EXPECT_TRUE(window.document().path().isEmpty()) << "saving must not write over the preset";
    EXPECT_FALSE(window.isWindowModified());
    EXPECT_TRUE(window.windowTitle().startsWith(QLatin1String("black_tupelo.tree")));
    ASSERT_TRUE(showsNow(Model::Full));
    action("undo")->trigger();
    EXPECT_EQ(value("Scale"), 17);
    EXPECT_EQ(window.document().path(), presetPath("quaking_aspen"));
    EXPECT_TRUE(window.isWindowModified());
    action("redo")->trigger();
    EXPECT_EQ(value("Scale"), 23);
}

TEST_F(PresetTest, OnesOwnAndBrokenOnes) {
    const QDir own(CPresetBrowser::ownFolder());
    writeFile(toPath(own.filePath(QStringLiteral("broken.tree"))), "Format = 1\nScale = big\n");
    window.document().saveCopy(own.filePath(QStringLiteral("mine.tree")), QStringLiteral("My Aspen"));
    window.presets().refresh();
    ASSERT_TRUE(item("My Aspen"));
    ASSERT_TRUE(item("broken"));
    EXPECT_TRUE(item("broken")->toolTip().contains(QLatin1String("broken.tree:2:9")));
    answerNext(QMessageBox::Ok);
    emit window.presets().list().itemClicked(item("broken"));
    EXPECT_TRUE(asked);
    EXPECT_EQ(window.document().path(), presetPath("quaking_aspen")) << "nothing has changed";
    QDir(own).removeRecursively();
    ASSERT_TRUE(waitFor([&] { return item("My Aspen") == nullptr; })) << "the folder is watched";
}

} // namespace
} // namespace stromar
