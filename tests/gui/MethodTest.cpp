// Curves and texts in the panel, by a way to grow that only the tests know.
#include "params/CurveEditor.h"
#include "window/QtText.h"
#include "params/ParamEditor.h"
#include "params/ParamPanel.h"
#include "WindowFixture.h"
#include "methods/Pole.h"
#include "stromar/params/ParamText.h"
#include "stromar/util/FileSet.h"
#include <QDoubleSpinBox>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QTemporaryDir>

namespace stromar {
namespace {

using test::PoleParams;
using test::poleMethod;

ParamRef poleRow(const char* key) { return *findParam(key, *poleMethod().block); }

class CurveEditorTest : public testing::Test {
protected:
    CurveEditorTest() {
        editor.resize(300, 160);
        editor.showCurve(CCurve({{0, 0.3}, {4, 0.1}}));
        editor.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&editor));
        QObject::connect(&editor, &CCurveEditor::edited, [this](const CCurve& curve, int gesture) {
            shown.push_back(curve);
            gestures.push_back(gesture);
        });
    }
    QPoint placeOf(double x, double y) const { return editor.placeOf({x, y}).toPoint(); }
    const std::vector<CCurve::Point>& points() const { return editor.curve().points(); }

    CCurveEditor editor{*poleRow("PoleThickness").info};
    std::vector<CCurve> shown;
    std::vector<int> gestures;
};

TEST_F(CurveEditorTest, DraggingAPointIsOneGestureAndSnaps) {
    QTest::mousePress(&editor, Qt::LeftButton, {}, placeOf(4, 0.1));
    for (const double x : {4.3, 4.8, 5.2}) QTest::mouseMove(&editor, placeOf(x, 0.2));
    EXPECT_TRUE(editor.held());
    QTest::mouseRelease(&editor, Qt::LeftButton, {}, placeOf(5.2, 0.2));
    EXPECT_FALSE(editor.held());
    ASSERT_GE(shown.size(), 2u);
    EXPECT_GT(gestures.front(), 0);
    EXPECT_TRUE(std::ranges::all_of(gestures, [&](int g) { return g == gestures.front(); }));
    EXPECT_EQ(points().back().x, 5) << "whole pieces";
    EXPECT_NEAR(points().back().y, 0.2, 0.011);
    EXPECT_EQ(points().front(), (CCurve::Point{0, 0.3}));
}

TEST_F(CurveEditorTest, WithShiftNothingSnaps) {
    QTest::mousePress(&editor, Qt::LeftButton, Qt::ShiftModifier, placeOf(4, 0.1));
    QMouseEvent move(QEvent::MouseMove, placeOf(4.4, 0.1), editor.mapToGlobal(placeOf(4.4, 0.1)), Qt::NoButton, Qt::LeftButton,
                     Qt::ShiftModifier);
    QApplication::sendEvent(&editor, &move);
    EXPECT_NEAR(points().back().x, 4.4, 0.05);
    EXPECT_NE(points().back().x, 4);
}

TEST_F(CurveEditorTest, APointStaysBetweenItsNeighbours) {
    editor.showCurve(CCurve({{0, 0.3}, {2, 0.2}, {4, 0.1}}));
    QTest::mousePress(&editor, Qt::LeftButton, {}, placeOf(2, 0.2));
    QTest::mouseMove(&editor, placeOf(5.5, 0.2));
    EXPECT_LT(points()[1].x, 4);
    EXPECT_EQ(points().size(), 3u);
}

TEST_F(CurveEditorTest, ADoubleClickAddsAndDeleteTakesAway) {
    QTest::mouseDClick(&editor, Qt::LeftButton, {}, placeOf(2, 0.4));
    ASSERT_EQ(points().size(), 3u);
    EXPECT_EQ(points()[1].x, 2);
    EXPECT_NEAR(points()[1].y, 0.4, 0.011);
    EXPECT_EQ(editor.chosen(), 1u);
    QTest::keyClick(&editor, Qt::Key_Delete);
    EXPECT_EQ(points().size(), 2u);
    QTest::keyClick(&editor, Qt::Key_Delete);
    QTest::keyClick(&editor, Qt::Key_Delete);
    EXPECT_EQ(points().size(), 1u) << "the last one stays";
}

TEST_F(CurveEditorTest, NumbersOfThePointCanBeTyped) {
    QTest::mouseClick(&editor, Qt::LeftButton, {}, placeOf(4, 0.1));
    auto* y = editor.findChild<QDoubleSpinBox*>(QStringLiteral("curveY"));
    y->setValue(0.25);
    EXPECT_EQ(points().back().y, 0.25);
    editor.findChild<QDoubleSpinBox*>(QStringLiteral("curveX"))->setValue(6);
    EXPECT_EQ(points().back().x, 6);
}

class MethodWindowTest : public WindowFixture {
protected:
    QTemporaryDir folder;
};

TEST_F(MethodWindowTest, ATreeOfAnotherMethodHasItsOwnTabs) {
    const QString path = folder.filePath(QStringLiteral("pole.tree"));
    static_cast<void>(poleMethod());
    writeFile(toPath(path), "Format = 2\nMethod = pole\nPolePlan = \"\"\"\nLL\n\"\"\"\n");
    ASSERT_TRUE(window.files().open(path));
    CParamPanel& panel = window.panel();
    EXPECT_EQ(panel.tabs().tabText(1), QStringLiteral("Pole"));
    ASSERT_TRUE(panel.editor(poleRow("PoleThickness")));
    ASSERT_TRUE(panel.editor(poleRow("PolePlan")));
    EXPECT_FALSE(panel.editor(paramRef("1Branches")));
    EXPECT_TRUE(waitFor([&] { return window.shown() && window.shown()->model->tree->leaves().size() == 2; }));

    auto* plan = panel.editor(poleRow("PolePlan"))->findChild<QPlainTextEdit*>();
    plan->setFocus();
    plan->selectAll();
    QTest::keyClicks(plan, QStringLiteral("LxL"));
    QTest::keyClick(plan, Qt::Key_Return, Qt::ControlModifier);
    EXPECT_EQ(window.document().params().as<PoleParams>().plan, "LxL");
    window.document().history().undo();
    EXPECT_EQ(window.document().params().as<PoleParams>().plan, "LL");
    EXPECT_EQ(plan->toPlainText(), QStringLiteral("LL"));

    auto* curve = panel.editor(poleRow("PoleThickness"))->findChild<CCurveEditor*>();
    emit curve->edited(CCurve({{0, 0.1}}), 0);
    EXPECT_EQ(window.document().params().as<PoleParams>().thickness, CCurve({{0, 0.1}}));
    window.document().history().undo();
    EXPECT_EQ(window.document().params().as<PoleParams>().thickness, CCurve({{0, 0.3}, {5, 0.05}}));
    EXPECT_EQ(curve->curve(), CCurve({{0, 0.3}, {5, 0.05}}));

    window.document().startNew();
    EXPECT_TRUE(panel.editor(paramRef("1Branches"))) << "and back";
    EXPECT_FALSE(panel.editor(poleRow("PoleHeight")));
}

TEST_F(MethodWindowTest, FileNewOffersTheMethods) {
    static_cast<void>(poleMethod());
    CMainWindow other;
    auto* action = other.findChild<QAction*>(QStringLiteral("new:pole"));
    ASSERT_TRUE(action);
    action->trigger();
    EXPECT_EQ(other.document().params().block().method, "pole");
}

} // namespace
} // namespace stromar
