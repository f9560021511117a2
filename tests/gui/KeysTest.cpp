#include "WindowFixture.h"
#include "window/QtText.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include <QAbstractItemView>
#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QToolButton>

namespace stromar {
namespace {

/// What a reader aloud would say of a widget.
QString spokenName(QWidget* widget) {
    QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
    return interface ? interface->text(QAccessible::Name) : QString();
}

class KeysTest : public WindowFixture {};

TEST_F(KeysTest, KeysGoToTheWidgetThatUsesThem) {
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Tree));
    window.document().setValue(paramRef("1SegSplits"), 0.5, 0); // else the switch does nothing
    auto* halve = window.panel().editor(paramRef("CloneHalving"))->findChild<QCheckBox*>();
    window.viewport().lookFrom(40, 20);
    const osg::Vec3d eye = window.viewport().camera().eye();
    halve->setFocus();
    QTest::keyClick(halve, Qt::Key_Space);
    EXPECT_EQ(value("CloneHalving"), 0) << "space presses it";
    EXPECT_LT((window.viewport().camera().eye() - eye).length(), 1e-9) << "and does not recentre";
    auto* shape = window.panel().editor(paramRef("Shape"))->findChild<QComboBox*>();
    shape->setFocus();
    const double form = value("Shape");
    QTest::keyClick(shape, Qt::Key_T);
    EXPECT_TRUE(action("trackball")->isChecked()) << "no text is typed in a closed list";
    QTest::keyClick(shape, Qt::Key_C);
    EXPECT_EQ(value("Shape"), form) << "a letter does not choose another";
    window.viewport().setFocus();
    QTest::keyClick(&window.viewport(), Qt::Key_T);
    EXPECT_FALSE(action("trackball")->isChecked());
    auto* box = window.panel().editor(paramRef("Scale"))->findChild<QDoubleSpinBox*>();
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Up);
    const double raised = value("Scale");
    EXPECT_GT(raised, 13);
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(value("Scale"), 13) << "undo is the document's";
}

TEST_F(KeysTest, CommandsComeBeforeWhatOtherEditorsDoWithTheirKeys) {
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Tree));
    auto* box = window.panel().editor(paramRef("Scale"))->findChild<QDoubleSpinBox*>();
    box->setFocus();
    bool opened = false;
    QTimer::singleShot(300, &window, [&] {
        if (QWidget* dialog = QApplication::activeModalWidget()) opened = true, dialog->close();
    });
    QTest::keyClick(box->findChild<QLineEdit*>(), Qt::Key_E, Qt::ControlModifier);
    EXPECT_TRUE(waitFor([&] { return opened; })) << "Ctrl+E exports";
    QTest::keyClick(box->findChild<QLineEdit*>(), Qt::Key_A, Qt::ControlModifier);
    EXPECT_TRUE(box->findChild<QLineEdit*>()->hasSelectedText()) << "what edits text is the field's";
}

TEST_F(KeysTest, UndoInALineOfTextIsTheDocuments) {
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Textures));
    auto* line = window.panel().findChild<QLineEdit*>(QStringLiteral("BarkTexture"));
    const std::string before = window.document().params().text.barkTexture;
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("bark:birch"));
    QTest::keyClick(line, Qt::Key_Return);
    ASSERT_EQ(window.document().params().text.barkTexture, "bark:birch");
    QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window.document().params().text.barkTexture, before);
    EXPECT_EQ(line->text().toStdString(), before);
}

TEST_F(KeysTest, EnterAcceptsInAnOpenedDropDown) {
    auto* shape = window.panel().editor(paramRef("Shape"))->findChild<QComboBox*>();
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Tree));
    const int before = shape->currentIndex();
    shape->showPopup();
    ASSERT_TRUE(waitFor([&] { return shape->view()->isVisible(); }));
    shape->view()->setCurrentIndex(shape->model()->index(before + 1, 0));
    QTest::keyClick(shape->view(), Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return !shape->view()->isVisible(); }));
    EXPECT_EQ(shape->currentIndex(), before + 1);
}

TEST_F(KeysTest, WhatTakesTheFocusHasAName) {
    int count = 0;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        const bool inside =
            qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) || qobject_cast<QComboBox*>(widget->parentWidget());
        if (!(widget->focusPolicy() & Qt::TabFocus) || inside || qobject_cast<QScrollArea*>(widget) ||
            widget->inherits("QComboBoxPrivateContainer") || widget->inherits("QComboBoxListView"))
            continue;
        EXPECT_FALSE(spokenName(widget).isEmpty())
            << widget->metaObject()->className() << " " << widget->objectName().toStdString() << " in "
            << widget->parentWidget()->metaObject()->className();
        ++count;
    }
    EXPECT_GT(count, 100);
}

TEST_F(KeysTest, EveryEditorIsReachedByTheKeyboard) {
    window.panel().tabs().setCurrentIndex(window.panel().tabOf(Group::Branches, 1));
    std::vector<QWidget*> visited;
    QWidget* at = window.panel().editor(paramRef("1Branches"))->findChild<QSlider*>();
    at->setFocus();
    for (int i = 0; i < 60; ++i) {
        visited.push_back(QApplication::focusWidget());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    int last = -1;
    for (const char* key : {"1BranchDist", "1DownAngle", "1DownAngleV", "1Rotate", "1Length", "1Taper", "1CurveRes"}) {
        const QWidget* editor = window.panel().editor(paramRef(key));
        const auto found = std::ranges::find_if(visited, [&](const QWidget* w) { return editor->isAncestorOf(w); });
        ASSERT_NE(found, visited.end()) << key;
        EXPECT_GT(found - visited.begin(), last) << key << ": in the order of the rows";
        last = static_cast<int>(found - visited.begin());
    }
}

} // namespace
} // namespace stromar
