// Centre line, smoother and collar by themselves, on stems made by hand.
#include "stem/BarkScale.h"
#include "stem/CentreLine.h"
#include "stem/Collar.h"
#include "stem/CollarRoom.h"
#include "stem/Smoother.h"
#include "stromar/mesh/MeshBuilder.h"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace stromar {
namespace {

constexpr double kRight = std::numbers::pi / 2;

/// One straight or bent stem of segments of unequal length.
std::shared_ptr<CGeneration> bent(std::vector<double> lengths, double turn, double radius, double taper = 0) {
    auto generation = std::make_shared<CGeneration>();
    CStem stem{};
    stem.id = 1;
    stem.radius = radius;
    stem.parent = -1;
    stem.pathCount = 1;
    stem.segmentCount = static_cast<std::uint32_t>(lengths.size());
    for (const double length : lengths) stem.length += length;
    generation->paths.push_back({0, 0, stem.segmentCount, 0, -1});
    glm::dvec3 at(0);
    Frame frame(1.0);
    double start = 0;
    for (const double length : lengths) {
        CSegment segment{};
        segment.position = at;
        segment.frame = frame;
        segment.start = start;
        segment.length = length;
        start += length;
        segment.radiusBase = radius * (1 - taper * (start - length) / stem.length);
        segment.radiusEnd = radius * (1 - taper * start / stem.length);
        generation->segments.push_back(segment);
        at = segment.axisPoint(1);
        frame = rotatedX(frame, turn);
    }
    generation->stems.push_back(stem);
    return generation;
}

CTree treeOf(const std::vector<std::shared_ptr<CGeneration>>& generations, const BaseForm& base = {}) {
    return {10, {generations.begin(), generations.end()}, base};
}

struct Line {
    explicit Line(const std::shared_ptr<CGeneration>& own, double mostTurn)
        : generation(own), tree(treeOf({own})), surface(tree, 0, params), line(*own, surface) {
        line.start(own->stems[0], own->paths[0], mostTurn);
    }
    std::shared_ptr<CGeneration> generation;
    CTree tree;
    MeshParams params;
    CStemSurface surface;
    CCentreLine line;
};

TEST(CentreLine, IsTheAxisWhereNothingBends) {
    const Line straight(bent({1, 0.3, 2}, 0, 0.1), 0.1);
    for (std::uint32_t s = 0; s < 3; ++s)
        for (const double t : {0.0, 0.4, 1.0}) {
            const auto place = straight.line.at(s, t);
            EXPECT_LT(glm::distance(place.centre, straight.generation->segments[s].axisPoint(t)), 1e-12);
            EXPECT_EQ(place.stretch, 1);
        }
    std::vector<double> places;
    straight.line.addBendRings(1, places);
    EXPECT_TRUE(places.empty());
}

TEST(CentreLine, RoundsABendWithoutLeavingTheWood) {
    const double radius = 0.05;
    const Line knee(bent({1, 0.6}, 1.0, radius), 0.1);
    const glm::dvec3 corner = knee.generation->segments[1].position;
    std::vector<double> below, above;
    knee.line.addBendRings(0, below);
    knee.line.addBendRings(1, above);
    ASSERT_FALSE(below.empty());
    ASSERT_FALSE(above.empty());
    EXPECT_LE(below.size() + above.size(), 2u * CCentreLine::kMaxBendRings);
    EXPECT_TRUE(std::ranges::is_sorted(below) && std::ranges::is_sorted(above));
    const glm::dvec3 middle = knee.line.at(1, 0).centre;
    EXPECT_GT(glm::distance(middle, corner), 0.01 * radius) << "it cuts the corner";
    EXPECT_LE(glm::distance(middle, corner), 0.41 * radius) << "branches start on the axis";
    // Without a jump in place and direction from one segment to the next.
    const auto low = knee.line.at(0, 1 - 1e-9), high = knee.line.at(1, 1e-9);
    EXPECT_LT(glm::distance(low.centre, high.centre), 1e-6);
    EXPECT_GT(glm::dot(low.frame[2], high.frame[2]), 1 - 1e-6);
}

TEST(CentreLine, MitresWhereNothingIsRounded) {
    const Line knee(bent({1, 1}, 1.0, 0.05), 0);
    const auto ring = knee.line.at(1, 0);
    EXPECT_NEAR(ring.stretch, 1 / std::cos(0.5), 1e-9);
    EXPECT_NEAR(glm::dot(ring.frame[2], knee.generation->segments[0].frame[2]), std::cos(0.5), 1e-9) << "at half the angle";
    EXPECT_NEAR(knee.line.turnBelow(1), 1.0, 1e-9);
}

TEST(CentreLine, FramesDoNotTwist) {
    const Line bow(bent({0.5, 0.7, 0.2, 0.9}, 0.3, 0.02), 0.05);
    for (std::uint32_t s = 0; s < 4; ++s)
        EXPECT_LT(std::abs(bow.line.at(s, 0.5).frame[0].y), 1e-9) << "the bend is about X, which stays";
}

std::vector<double> smoothed(const CTree& tree, const MeshParams& params, int helixRings = 10) {
    const CStemSurface surface(tree, 0, params);
    std::vector<double> along;
    const CGeneration& generation = tree.generation(0);
    for (const CSegment& segment : generation.segments) {
        std::vector<double> places;
        CSmoother(surface).subdivide(generation.stems[0], segment, helixRings, places);
        EXPECT_TRUE(std::ranges::is_sorted(places));
        for (const double t : places) {
            EXPECT_TRUE(t > 0 && t < 1);
            along.push_back(segment.start + t * segment.length);
        }
    }
    return along;
}

TEST(Smoother, ACylinderAndAConeNeedNoMoreRings) {
    EXPECT_TRUE(smoothed(treeOf({bent({1, 3, 0.2}, 0, 0.1)}), {}).empty());
    EXPECT_TRUE(smoothed(treeOf({bent({1, 3, 0.2}, 0, 0.1, 0.9)}), {}).empty());
}

TEST(Smoother, AFlareIsFollowedWhereItBends) {
    const double length = 8, radius = 0.3, flare = 1.5;
    const CTree tree = treeOf({bent({0.4, 5, 2.6}, 0, radius)}, {.flare = flare});
    std::vector<double> along = smoothed(tree, {});
    ASSERT_GT(along.size(), 3u);
    // Between neighbouring rings a straight wall stays near the flare.
    for (const double end : {0.0, 0.4, 5.4, length}) along.push_back(end);
    std::ranges::sort(along);
    const auto radiusAt = [&](double a) { return radius * tree.base().flareAt(a / length); };
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
        const double middle = (along[i] + along[i + 1]) / 2;
        EXPECT_NEAR(radiusAt(middle), (radiusAt(along[i]) + radiusAt(along[i + 1])) / 2, 0.04 * radius) << middle;
    }
}

TEST(Smoother, SpheresGetRingsOnEachWhateverTheSegments) {
    const auto spheres = [](std::vector<double> lengths) {
        auto generation = bent(std::move(lengths), 0, 0.1);
        generation->stems[0].profile = {0, 1, RadiusProfile::Form::Spheres};
        return smoothed(treeOf({generation}), {}).size();
    };
    const std::size_t even = spheres({0.5, 0.5, 0.5, 0.5}), uneven = spheres({0.13, 1.07, 0.3, 0.5});
    EXPECT_GT(even, 60u) << "ten spheres";
    EXPECT_NEAR(double(uneven), double(even), 0.15 * double(even));
}

TEST(Smoother, AHelixHasItsRingsPerTurn) {
    auto generation = bent({1, 2}, 0, 0.05);
    for (CSegment& segment : generation->segments) segment.helixRadius = 0.1;
    EXPECT_EQ(smoothed(treeOf({generation}), {}, 10).size(), 18u);
    EXPECT_EQ(smoothed(treeOf({generation}), {}, 4).size(), 6u);
}

TEST(BarkScale, FollowsAFlareThatBendsWithinASegment) {
    BaseForm base;
    base.flare = 1.5;
    const auto trunk = bent({2, 6}, 0, 0.3, 0.8); // the flare is the first metre
    const CTree tree = treeOf({trunk}, base);
    const CStemSurface surface(tree, 0, {});
    CBarkScale bark(surface);
    bark.start(*trunk, trunk->stems[0], trunk->paths[0]);
    for (double along = 0.03; along < 1.9; along += 0.05) {
        const double radius = surface.woodRadius(trunk->stems[0], trunk->segments[0], along / 2);
        EXPECT_NEAR(bark.perMetreAt(along) * radius / (bark.perMetre() * 0.3), 1, 0.02) << along;
    }
}

/// A straight trunk with one branch, and what the collar maker needs.
struct Branch {
    Branch(double down, double offset, double radius, const std::vector<double>& lengths = {0.3, 0.9})
        : trunk(bent({0.7, 2.1, 1.2}, 0, 0.2)), branches(bent(lengths, 0.1, radius)) {
        CStem& stem = branches->stems[0];
        stem.parent = 0;
        stem.offset = offset;
        stem.parentRadius = 0.2;
        while (trunk->segments[stem.position].end() < offset) ++stem.position;
        const CSegment& wood = trunk->segments[stem.position];
        const Frame frame = rotatedX(wood.frame, down);
        glm::dvec3 at = wood.axisPoint((offset - wood.start) / wood.length);
        for (CSegment& segment : branches->segments) {
            segment.position = at;
            segment.frame = frame;
            at = segment.axisPoint(1);
        }
    }
    const Collar* make(std::uint32_t points) {
        tree.emplace(treeOf({trunk, branches}));
        parents = meshAllStems(*tree, {}, detailOf(Model::Full), CProgress()).front();
        maker.emplace(*tree, below);
        return maker->make(branches->stems[0], {branches->segments, branches->stems[0].radius, points}, {});
    }
    std::shared_ptr<CGeneration> trunk, branches;
    std::optional<CTree> tree;
    StemMesh parents;
    std::array<const StemMesh*, 1> below{&parents};
    std::optional<CCollarMaker> maker;
};

TEST(Collar, LiesOnTheParentsSurfaceAroundTheBranch) {
    Branch branch(kRight, 1.9, 0.05);
    const Collar* collar = branch.make(12);
    ASSERT_TRUE(collar);
    ASSERT_EQ(collar->points.size(), 12u);
    double low = 1e9, high = -1e9, left = 1e9, right = -1e9;
    for (const SurfacePoint& point : collar->points) {
        const double out = std::hypot(point.position.x, point.position.y);
        EXPECT_NEAR(out, 0.2, 0.004) << "a wall of the trunk's polygon";
        EXPECT_GT(glm::dot(point.normal, glm::dvec3(point.position.x, point.position.y, 0)), 0) << "outwards";
        low = std::min(low, point.position.z);
        high = std::max(high, point.position.z);
        left = std::min(left, point.position.x);
        right = std::max(right, point.position.x);
    }
    EXPECT_NEAR(high - low, 2 * CCollarMaker::kAlong * 0.05, 0.005);
    EXPECT_NEAR(right - left, 2 * CCollarMaker::kAcross * 0.05, 0.005);
    EXPECT_NEAR((low + high) / 2, 1.9, 0.01) << "where the branch sits, across segments of unequal length";
    EXPECT_GT(collar->clear, 0.2 - 0.05);
    EXPECT_LT(collar->clear, 0.25);
}

TEST(Collar, StretchesAlongTheParentOfASteepBranch) {
    Branch steep(0.6, 1.9, 0.05);
    const Collar* collar = steep.make(12);
    ASSERT_TRUE(collar);
    double low = 1e9, high = -1e9;
    for (const SurfacePoint& point : collar->points) {
        low = std::min(low, point.position.z);
        high = std::max(high, point.position.z);
    }
    EXPECT_GT(high - low, 2 * CCollarMaker::kAlong * 0.05 * 1.2);
    EXPECT_GT((low + high) / 2, 1.95) << "it leaves the wood above its base";
}

TEST(Collar, IsNotMadeForABranchThatStaysInside) {
    Branch along(0.05, 1.9, 0.05), out(0.6, 1.9, 0.05);
    EXPECT_FALSE(along.make(12)) << "nearly along the trunk";
    EXPECT_FALSE(along.maker->leavesWood());
    EXPECT_TRUE(along.maker->hides(along.branches->stems[0], along.branches->segments));
    EXPECT_TRUE(out.make(12));
    EXPECT_FALSE(out.maker->hides(out.branches->stems[0], out.branches->segments));
}

TEST(Collar, HidesBranchesThatAreTooShortToLeaveTheWood) {
    for (const double offset : {1.9, 3.97}) { // also beneath the flat end of a stem
        Branch inside(kRight, offset, 0.02, {0.15}), outside(kRight, offset, 0.02, {0.5});
        EXPECT_FALSE(inside.make(6));
        EXPECT_TRUE(inside.maker->hides(inside.branches->stems[0], inside.branches->segments)) << offset;
        outside.make(6);
        EXPECT_FALSE(outside.maker->hides(outside.branches->stems[0], outside.branches->segments)) << offset;
    }
}

/// Two branches of a trunk.
std::vector<float> roomOf(double apart, double turn, double radius, const CollarLimit& limit = {}) {
    Branch one(kRight, 1.5, radius);
    const Branch other(kRight, 1.5 + apart, radius);
    one.branches->stems.push_back(other.branches->stems[0]);
    one.branches->stems[1].firstSegment = static_cast<std::uint32_t>(one.branches->segments.size());
    for (CSegment segment : other.branches->segments) {
        segment.frame = rotatedX(rotatedZ(one.trunk->segments[0].frame, turn), kRight);
        one.branches->segments.push_back(segment);
    }
    return collarRoom(*one.branches, *one.trunk, std::array{BranchFoot{radius, limit}, BranchFoot{radius, limit}});
}

TEST(CollarRoom, IsSharedByBranchesThatSitCloseTogether) {
    EXPECT_EQ(roomOf(1, 0, 0.05), (std::vector<float>{1, 1})) << "far apart";
    EXPECT_EQ(roomOf(0.05, 2, 0.05), (std::vector<float>{1, 1})) << "on other sides";
    const std::vector<float> near = roomOf(0.13, 0, 0.05);
    EXPECT_EQ(near[0], near[1]);
    EXPECT_LT(2 * CCollarMaker::kAlong * 0.05 * double(near[0]), 0.13) << "one above the other";
    EXPECT_GT(2 * CCollarMaker::kAlong * 0.05 * double(near[0]), 0.11);
    EXPECT_EQ(roomOf(0.02, 0, 0.05), roomOf(0.01, 0, 0.05)) << "no stalks";
    EXPECT_EQ(roomOf(0.02, 0, 0.05, {.narrowest = 0.35})[0], 0.35f) << "which nobody sees of thin ones";
    EXPECT_EQ(roomOf(1, 0, 0.2)[0], 1) << "of one as thick as its parent";
    EXPECT_NEAR(double(roomOf(1, 0, 0.2, {.around = 0.65})[0]) * CCollarMaker::kAcross * 0.2, 0.65 * 0.2, 1e-6) << "a thin one";
}

} // namespace
} // namespace stromar
