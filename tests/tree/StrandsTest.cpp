// The strand model against its formulas: what holds for any values, and figures worked out by hand.
#include "stromar/tree/strands/StrandsBuilder.h"
#include "stromar/util/Random.h"
#include "tree/RandomStrands.h"
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

namespace stromar::test {
namespace {

constexpr double kRadian = std::numbers::pi / 180;

/// A branch with what it parts into.
struct Parting {
    const StrandBranch *below, *leader, *aside;
    const CSegment *segmentBelow, *segmentLeader, *segmentAside;
};

class Grown {
public:
    explicit Grown(const CParams& params, bool varied = true)
        : tree(CStrandsBuilder(varied).build(params, nullptr, 0, CProgress(2))) {
        for (std::size_t g = 0; g < tree->generationCount(); ++g)
            for (const CStem& stem : generation(g).stems)
                for (std::uint32_t s = 0; s < stem.segmentCount; ++s) {
                    ++branches;
                    deepest = std::max(deepest, generation(g).branches[stem.firstSegment + s].depth);
                }
        for (std::size_t g = 0; g + 1 < tree->generationCount(); ++g)
            for (const CStem& stem : generation(g + 1).stems) {
                const std::uint32_t at = generation(g).stems[static_cast<std::size_t>(stem.parent)].firstSegment + stem.position;
                const CStrandGeneration& own = generation(g);
                partings.push_back({&own.branches[at], &own.branches[at + 1], &generation(g + 1).branches[stem.firstSegment], &own.segments[at],
                                    &own.segments[at + 1], &generation(g + 1).segments[stem.firstSegment]});
            }
    }
    const CStrandGeneration& generation(std::size_t g) const { return static_cast<const CStrandGeneration&>(tree->generation(g)); }

    std::shared_ptr<const CTree> tree;
    std::vector<Parting> partings;
    std::size_t branches = 0;
    std::uint32_t deepest = 0;
};

CParams withStrands(int number, double share = 0.65) {
    CParams params(strandsBlock());
    strands(params).strands = number;
    strands(params).strandShareG = CCurve({{0, share}});
    return params;
}

double angleBetween(const CSegment& a, const CSegment& b) {
    return std::atan2(glm::length(glm::cross(a.frame[2], b.frame[2])), glm::dot(a.frame[2], b.frame[2])) / kRadian;
}
} // namespace

TEST(Strands, AreKept) {
    for (unsigned number = 1; number <= 300; ++number) {
        SCOPED_TRACE(number);
        const CParams params = randomStrands(number, 400);
        const StrandsParams& s = strands(params);
        const Grown grown(params);
        const auto total = static_cast<std::size_t>(s.strands);
        EXPECT_EQ(grown.branches, 2 * total - 1);
        EXPECT_EQ(grown.partings.size(), total - 1);
        EXPECT_EQ(grown.tree->stemCount(), total) << "each ends in one strand";
        for (std::size_t g = 0; g < grown.tree->generationCount(); ++g)
            for (const CStem& stem : grown.generation(g).stems)
                EXPECT_EQ(grown.generation(g).branches[stem.firstSegment + stem.segmentCount - 1].strands, 1);
        for (const Parting& p : grown.partings) {
            EXPECT_EQ(p.leader->strands + p.aside->strands, p.below->strands);
            EXPECT_GE(p.leader->strands, p.aside->strands);
            const double squares = p.leader->diameter * p.leader->diameter + p.aside->diameter * p.aside->diameter;
            EXPECT_NEAR(squares, p.below->diameter * p.below->diameter, 1e-12 * squares) << "da Vinci";
            EXPECT_EQ(p.leader->order, p.below->order);
            EXPECT_EQ(p.aside->order, p.below->order + 1);
            EXPECT_EQ(p.leader->depth, p.below->depth + 1);
            EXPECT_EQ(p.aside->depth, p.below->depth + 1);
            const double low = s.lengthLeastG.at(p.below->order), high = std::max(low, s.lengthMostG.at(p.below->order));
            for (const StrandBranch* child : {p.leader, p.aside}) {
                EXPECT_GE(child->inherited, low * p.below->inherited * (1 - 1e-12));
                EXPECT_LE(child->inherited, high * p.below->inherited * (1 + 1e-12));
            }
            const double factor = s.lengthFactorG.at(p.below->order);
            EXPECT_DOUBLE_EQ(p.segmentLeader->length, factor * p.leader->inherited);
            EXPECT_DOUBLE_EQ(p.segmentAside->length, factor * p.aside->inherited);
        }
    }
}

TEST(Strands, TurnAsTheFormulasSay) {
    for (unsigned number = 1; number <= 100; ++number) {
        CParams params = randomStrands(number, 200);
        StrandsParams& s = strands(params);
        s.gravimorphismG = CCurve();
        s.splitAngleOver = 0;
        s.splitAngleW = CCurve({{0, 1}});
        s.strandVariation = 0;
        for (const Parting& p : Grown(params).partings) {
            const double angle = s.splitAngleG.at(p.below->order);
            EXPECT_NEAR(angleBetween(*p.segmentLeader, *p.segmentAside), angle, 1e-9);
            const double leader = s.gravicentralismG.at(p.below->order) * std::sqrt(p.aside->strands / p.below->strands) * angle;
            EXPECT_NEAR(angleBetween(*p.segmentBelow, *p.segmentLeader), leader, 1e-9);
            EXPECT_NEAR(angleBetween(*p.segmentBelow, *p.segmentAside), angle - leader, 1e-9);
        }
    }
    CParams params = withStrands(2);
    strands(params).splitAngleG = CCurve({{0, 80}});
    strands(params).gravimorphismG = CCurve();
    strands(params).gravicentralismG = CCurve({{0, 1}});
    EXPECT_NEAR(angleBetween(*Grown(params).partings[0].segmentBelow, *Grown(params).partings[0].segmentLeader), 80 / std::sqrt(2.0), 1e-9)
        << "equal parts do not part equally";
    strands(params).gravicentralismG = CCurve();
    EXPECT_NEAR(angleBetween(*Grown(params).partings[0].segmentBelow, *Grown(params).partings[0].segmentLeader), 0, 1e-9);
}

TEST(Strands, AreSharedAsTheCeilingSays) {
    const std::tuple<int, double, int> figures[] = {{3, 0.5, 2}, {12, 0.6, 7}, {10, 0.5, 5}, {10, 0.75, 7}, {10, 1, 9}, {2, 0.5, 1}, {1000, 0.999, 999}};
    for (const auto& [all, share, leader] : figures)
        EXPECT_EQ(Grown(withStrands(all, share)).partings[0].leader->strands, leader) << all << ", " << share;
}

TEST(Strands, DepthsOfTheSpecification) {
    const std::map<int, std::vector<std::uint32_t>> depths{{10, {4, 5, 6, 9, 9}}, {100, {7, 9, 14, 28, 99}}, {1000, {10, 14, 22, 50, 999}}};
    const double shares[] = {0.5, 0.6, 0.75, 0.9, 1};
    for (const auto& [number, expected] : depths)
        for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(Grown(withStrands(number, shares[i])).deepest, expected[i]) << number << ", " << shares[i];
}

TEST(Strands, HangTowardsTheGroundAndNoFurther) {
    CParams params = withStrands(60);
    strands(params).gravicentralismG = CCurve({{0, 1}});
    strands(params).gravimorphismG = CCurve({{0, 180}});
    for (const Parting& p : Grown(params).partings)
        for (const CSegment* child : {p.segmentLeader, p.segmentAside}) EXPECT_NEAR(child->frame[2].z, -1, 1e-9);
    strands(params).gravimorphismG = CCurve({{0, 10}});
    CParams still = params;
    strands(still).gravimorphismG = CCurve();
    const Grown hanging(params), straight(still);
    EXPECT_NEAR(declination(hanging.partings[0].segmentAside->frame) - declination(straight.partings[0].segmentAside->frame), 10 * kRadian, 1e-9);
}

TEST(Strands, ALengthFactorChangesOneOrderAlone) {
    const CParams params = withStrands(80);
    CParams longer = params;
    strands(longer).lengthFactorG = CCurve({{1, 1}, {2, 1.5}, {3, 1}});
    const Grown before(params), after(longer);
    for (std::size_t i = 0; i < before.partings.size(); ++i) {
        const double factor = before.partings[i].below->order == 2 ? 1.5 : 1;
        EXPECT_DOUBLE_EQ(after.partings[i].segmentAside->length, factor * before.partings[i].segmentAside->length);
        EXPECT_DOUBLE_EQ(after.partings[i].aside->inherited, before.partings[i].aside->inherited) << "what is handed on stays";
    }
}

TEST(Strands, APointOnALineChangesNothing) {
    CParams params = withStrands(150);
    strands(params).splitAngleG = CCurve({{0, 60}, {4, 20}});
    const Grown before(params);
    strands(params).splitAngleG = CCurve({{0, 60}, {2, 40}, {4, 20}});
    const Grown after(params);
    for (std::size_t i = 0; i < before.partings.size(); ++i)
        EXPECT_LT(glm::distance(before.partings[i].segmentAside->position, after.partings[i].segmentAside->position), 1e-12);
}

TEST(Strands, CurvesRunOverOtherQuantities) {
    CParams params = withStrands(300);
    StrandsParams& s = strands(params);
    s.gravimorphismG = CCurve();
    s.splitAngleG = CCurve({{2, 20}, {6, 100}});
    for (const CurveOver over : {CurveOver::Height, CurveOver::RootLength, CurveOver::Thickness}) {
        s.splitAngleOver = static_cast<int>(over);
        double low = 1000, high = 0;
        for (const Parting& p : Grown(params).partings) {
            const double x = over == CurveOver::Height       ? p.segmentBelow->position.z
                             : over == CurveOver::RootLength ? p.below->rootLength
                                                             : 200 * p.segmentBelow->radiusBase;
            EXPECT_NEAR(angleBetween(*p.segmentLeader, *p.segmentAside), s.splitAngleG.at(x), 1e-9);
            low = std::min(low, x);
            high = std::max(high, x);
        }
        EXPECT_LT(low, 3);
        EXPECT_GT(high, 4);
    }
    s.splitAngleOver = 0;
    s.splitAngleW = CCurve({{0, 0}, {4, 1}});
    for (const Parting& p : Grown(params).partings)
        EXPECT_NEAR(angleBetween(*p.segmentLeader, *p.segmentAside), s.splitAngleG.at(p.below->order) * std::min(1.0, p.below->depth / 4.0), 1e-9);
}

TEST(Strands, OnlySeedsAndVariationMakeTwoTreesDiffer) {
    CParams params = withStrands(100);
    const auto tip = [](const Grown& grown) { return grown.tree->generation(1).segments.back().axisPoint(1); };
    const glm::dvec3 printed = tip(Grown(params));
    params.common.seed = 5;
    const glm::dvec3 turned = tip(Grown(params));
    EXPECT_GT(glm::distance(printed, turned), 0.01);
    EXPECT_NEAR(printed.z, turned.z, 1e-12) << "the tree is turned as a whole";
    EXPECT_EQ(tip(Grown(params, false)), printed) << "without variation";
    strands(params).strandVariation = 0.5;
    const Grown varied(params);
    EXPECT_GT(std::abs(tip(varied).z - printed.z), 1e-4);
    EXPECT_EQ(tip(varied), tip(Grown(params)));
    params.common.seed = 0;
    strands(params).strandVariation = 0;
    EXPECT_EQ(tip(Grown(params)), printed);
}

TEST(Strands, LeavesStandOnTheEndsOfOneStrand) {
    CParams params = withStrands(20);
    strands(params).stemLeaves = 5;
    const auto tree = growTree(CStrandsBuilder(), params, CProgress(2));
    ASSERT_EQ(tree->leaves().size(), 100u);
    for (const CLeaf& leaf : tree->leaves()) {
        const CStem& stem = tree->generation(leaf.generation).stems[leaf.stem];
        const CSegment& twig = tree->generation(leaf.generation).segments[stem.firstSegment + stem.segmentCount - 1];
        EXPECT_LT(glm::distance(leaf.position, glm::vec3(twig.axisPoint((leaf.number + 0.5) / 5))), 1e-6f);
        EXPECT_NEAR(glm::dot(glm::dvec3(leaf.axis), twig.frame[2]), 0, 1e-6);
    }
    const double turn = std::acos(glm::clamp(double(glm::dot(tree->leaves()[0].axis, tree->leaves()[1].axis)), -1.0, 1.0)) / kRadian;
    EXPECT_NEAR(turn, 137.5, 1e-3);
}

namespace {
/// Every branch of a tree by its path from the root.
std::map<std::uint64_t, const CSegment*> branchesOf(const CTree& tree) {
    std::map<std::uint64_t, const CSegment*> found;
    for (std::size_t g = 0; g < tree.generationCount(); ++g)
        for (const CStem& stem : tree.generation(g).stems)
            for (std::uint32_t s = 0; s < stem.segmentCount; ++s)
                found[hashCombine(stem.id, s)] = &tree.generation(g).segments[stem.firstSegment + s];
    return found;
}

CParams agingStrands(unsigned number) {
    CParams params = randomStrands(number, 60);
    strands(params).strandThickness = 0.02;
    return params;
}
} // namespace

TEST(Strands, GrowWithoutAJump) {
    for (unsigned number = 1; number <= 25; ++number) {
        SCOPED_TRACE(number);
        const CParams params = agingStrands(number);
        const CStrandsBuilder builder;
        const auto grown = builder.build(params, nullptr, 0, CProgress());
        const double reach = strands(params).trunkHeight + 20 * strands(params).inheritedLength;
        const double step = std::min(1e-3, 1.0 / (50 * strands(params).strands));
        double tallest = 0;
        for (const auto& [path, segment] : branchesOf(*grown)) tallest = std::max(tallest, glm::length(segment->axisPoint(1)));
        ASSERT_LT(tallest, reach);
        for (double age = 0.01; age + step <= 1; age += 0.0173) {
            const auto before = builder.atAge(params, grown, age, CProgress()), after = builder.atAge(params, grown, age + step, CProgress());
            const auto then = branchesOf(*after);
            for (const auto& [path, segment] : branchesOf(*before)) {
                const auto now = then.find(path);
                ASSERT_NE(now, then.end()) << "no branch goes, at " << age;
                EXPECT_LT(glm::distance(segment->position, now->second->position), 0.01 * tallest) << age;
                EXPECT_LT(glm::distance(segment->axisPoint(1), now->second->axisPoint(1)), 0.01 * tallest) << age;
                const double radius = grown->generation(0).stems[0].radius;
                EXPECT_LT(std::abs(segment->radiusBase - now->second->radiusBase), 0.01 * radius) << age;
            }
            EXPECT_GE(after->stemCount(), before->stemCount());
        }
    }
}

TEST(Strands, AYoungTreeIsPartOfTheGrownOne) {
    CParams params = agingStrands(3);
    strands(params).strands = 100;
    const CStrandsBuilder builder;
    const auto tree = builder.build(params, nullptr, 0, CProgress());
    const auto grown = branchesOf(*tree);
    const auto atOne = builder.atAge(params, tree, 1, CProgress());
    EXPECT_EQ(branchesOf(*atOne).size(), grown.size());
    EXPECT_EQ(builder.atAge(params, tree, 0, CProgress())->generationCount(), 0u);
    for (const double age : {0.05, 0.3, 0.5, 0.75, 0.99}) {
        const auto young = builder.atAge(params, tree, age, CProgress());
        for (const auto& [path, segment] : branchesOf(*young)) EXPECT_TRUE(grown.contains(path)) << age;
        EXPECT_EQ(young->stemCount(), static_cast<std::size_t>(std::max(1.0, std::ceil(100 * age * age - 1e-9))));
        EXPECT_NEAR(young->generation(0).stems[0].radius, tree->generation(0).stems[0].radius * age, 1e-12)
            << "the trunk thickens evenly";
    }
}

TEST(Strands, LeavesOfATipThatSplitsShrinkWhileItsChildrenGrow) {
    CParams params = withStrands(10);
    strands(params).stemLeaves = 4;
    const CStrandsBuilder builder;
    const auto tree = builder.atAge(params, builder.build(params, nullptr, 0, CProgress()), std::sqrt(0.475), CProgress()); // 4.75 strands
    const auto leaves = builder.growOrgans(params, *tree, Organ::Leaf, {}, CProgress());
    ASSERT_EQ(leaves->grown.size(), 24u) << "five tips, and the one that splits";
    double large = 0, fading = 0, coming = 0;
    for (const CLeaf& leaf : leaves->grown) {
        const double size = leaf.length / params.common.leafScale;
        (size > 0.99 ? large : size > 0.5 ? coming : fading) += 1;
    }
    EXPECT_EQ(large, 12);
    EXPECT_EQ(coming, 8) << "at three quarters";
    EXPECT_EQ(fading, 4) << "at one quarter";
}

TEST(Strands, ACancelledWalkEnds) {
    CProgress cancelled;
    cancelled.cancel();
    EXPECT_THROW(CStrandsBuilder().build(withStrands(1000), nullptr, 0, cancelled), CCancelled);
}

} // namespace stromar::test
