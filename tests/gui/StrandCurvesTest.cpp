// The curves of the strand model in the panel, and what they say of the tree.
#include "params/CurveEditor.h"
#include "view/ViewOverlay.h"
#include "view/Viewport.h"
#include "WindowFixture.h"
#include "stromar/params/ParamText.h"
#include "stromar/tree/strands/StrandsBuilder.h"
#include <QDoubleSpinBox>

namespace stromar {
namespace {

class StrandCurves : public WindowFixture {
protected:
    void SetUp() override {
        WindowFixture::SetUp();
        ASSERT_TRUE(window.files().open(presetPath("strand_winter")));
        ASSERT_TRUE(showsNow(Model::Full));
        window.panel().tabs().setCurrentIndex(0);
    }
    static ParamRef row(const char* key) { return *findParam(key, strandsBlock()); }
    CCurveEditor& curve(const char* key) { return *window.panel().editor(row(key))->curve(); }
    CViewOverlay::Model& overlay() { return window.viewport().overlay().model(); }
    const CStrandGeneration& generation(std::size_t g) {
        return static_cast<const CStrandGeneration&>(window.shown()->model->tree->generation(g));
    }
    /// The branches of the tree that is shown with these numbers of turns aside.
    std::size_t branchesOfOrders(std::size_t first, std::size_t last) {
        std::size_t count = 0;
        for (std::size_t g = first; g <= last; ++g) count += generation(g).segments.size();
        return count;
    }
};
class SlowStrandCurves : public StrandCurves {};

TEST_F(StrandCurves, OneOfEveryPictureIsUnfolded) {
    for (const char* first : {"StrandShareG", "SplitAngleG", "LengthLeastG", "StrandShareW"}) EXPECT_FALSE(curve(first).folded()) << first;
    for (const char* other : {"GravicentralismG", "PlaneTurnG", "GravimorphismG", "LengthMostG", "LengthFactorW"})
        EXPECT_TRUE(curve(other).folded()) << other;
    EXPECT_LT(curve("PlaneTurnG").height(), curve("SplitAngleG").height() / 3);
    QTest::mouseClick(&curve("GravimorphismG"), Qt::LeftButton);
    EXPECT_FALSE(curve("GravimorphismG").folded());
    EXPECT_TRUE(curve("SplitAngleG").folded());
    EXPECT_FALSE(curve("StrandShareG").folded()) << "another picture";
}

TEST_F(SlowStrandCurves, BranchesAreCountedBehindTheCurve) {
    const auto& use = curve("SplitAngleG").use();
    EXPECT_EQ(use.branches.size(), 2u * 6000 - 1);
    EXPECT_EQ(std::ranges::count(use.branches, 1.0), static_cast<std::ptrdiff_t>(generation(1).segments.size()));
    window.document().setValue(row("SplitAngleOver"), 1.0, 0);
    ASSERT_TRUE(showsNow(Model::Full));
    EXPECT_EQ(curve("SplitAngleG").axis().label, "height, m");
    EXPECT_GT(*std::ranges::max_element(curve("SplitAngleG").use().branches), 4);
}

TEST_F(SlowStrandCurves, APointThatIsHeldLightsUpWhatItTouches) {
    window.document().setValue(row("Strands"), 900.0, 0);
    ASSERT_TRUE(showsNow(Model::Full));
    CCurveEditor& angle = curve("SplitAngleG"); // points at 0, 2 and 5
    const QPoint middle = angle.placeOf(angle.curve().points()[1]).toPoint();
    QTest::mousePress(&angle, Qt::LeftButton, {}, middle);
    EXPECT_EQ(overlay().selection.lines.size(), branchesOfOrders(1, 4)) << "between its neighbours";
    EXPECT_TRUE(overlay().selectionText.contains(QStringLiteral("touches")));
    const auto before = window.shown()->model;
    QTest::mouseMove(&angle, middle - QPoint(0, 20));
    EXPECT_GT(strands(window.document().params()).splitAngleG.at(2), 72);
    ASSERT_TRUE(waitFor([&] { return window.shown()->model != before; })) << "it regrows while the hand moves";
    EXPECT_EQ(overlay().selection.lines.size(), branchesOfOrders(1, 4));
    QTest::mouseRelease(&angle, Qt::LeftButton, {}, middle - QPoint(0, 20));
    EXPECT_TRUE(overlay().selection.lines.empty());
    window.document().history().undo();
    EXPECT_EQ(strands(window.document().params()).splitAngleG.at(2), 72) << "one step";
}

TEST_F(StrandCurves, PointsStayWhereTheyAre) {
    window.document().setValue(row("Strands"), 50.0, 0);
    ASSERT_TRUE(showsNow(Model::Full));
    CCurveEditor& angle = curve("SplitAngleG"); // points at 0, 2 and 5
    const auto xs = [&] {
        std::vector<double> all;
        for (const CCurve::Point& point : strands(window.document().params()).splitAngleG.points()) all.push_back(point.x);
        return all;
    };
    const std::vector<double> before = xs();
    for (const std::size_t point : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
        const QPoint at = angle.placeOf(angle.curve().points()[point]).toPoint();
        QTest::mousePress(&angle, Qt::LeftButton, {}, at);
        QTest::mouseMove(&angle, at - QPoint(0, 15));
        QTest::mouseRelease(&angle, Qt::LeftButton, {}, at - QPoint(0, 15));
        EXPECT_EQ(xs(), before) << point << ": it was drawn straight up";
    }
    const QPoint middle = angle.placeOf(angle.curve().points()[1]).toPoint();
    QTest::mousePress(&angle, Qt::LeftButton, {}, middle);
    QTest::mouseMove(&angle, middle + QPoint(400, 0));
    QTest::mouseRelease(&angle, Qt::LeftButton, {}, middle + QPoint(400, 0));
    ASSERT_EQ(xs().size(), 3u);
    EXPECT_GT(xs()[1], 4.9);
    EXPECT_LT(xs()[1], 5) << "not past its neighbour";
    angle.findChild<QDoubleSpinBox*>(QStringLiteral("curveY"))->setValue(31);
    EXPECT_GT(xs()[1], 4.9);
    EXPECT_EQ(strands(window.document().params()).splitAngleG.points()[1].y, 31);
}

TEST_F(StrandCurves, ABranchThatIsPickedIsMarkedOnEveryCurve) {
    window.panel().tabs().setCurrentIndex(1);
    const CSegment& branch = generation(2).segments[10];
    const StrandBranch& known = generation(2).branches[10];
    const glm::dvec3 at = branch.axisPoint(0.5);
    emit window.viewport().picked(ViewHit{2, osg::Vec3d(at.x, at.y, at.z)});
    EXPECT_EQ(window.panel().tabs().currentIndex(), 0) << "the curves' tab";
    for (const char* key : {"SplitAngleG", "GravimorphismG"}) EXPECT_EQ(curve(key).use().marked, std::vector<double>{2}) << key;
    EXPECT_EQ(curve("SplitAngleW").use().marked, std::vector<double>{double(known.depth)});
    EXPECT_TRUE(overlay().selectionText.contains(QStringLiteral("Strands: %1").arg(known.strands)));
    window.document().startNew();
    EXPECT_TRUE(showsNow(Model::Full)) << "another method has no curves";
}

} // namespace
} // namespace stromar
