#include "stromar/mesh/check/Crossings.h"
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace stromar::test {

namespace {
constexpr double kRadius = 0.05;

/// Appends a straight stem of one segment.
void addStem(CGeneration& all, const glm::dvec3& from, const glm::dvec3& to, double offset, double parentRadius,
             std::int32_t parent, double helixRadius = 0) {
    const auto index = static_cast<std::uint32_t>(all.stems.size());
    const double length = glm::distance(from, to);
    const Frame frame = transported(Frame(1), (to - from) / length);
    all.segments.push_back({from, frame, 0, length, kRadius, kRadius, helixRadius, false});
    all.paths.push_back({index, index, 1, 0, -1});
    CStem stem{};
    stem.id = index;
    stem.length = length;
    stem.radius = kRadius;
    stem.offset = offset;
    stem.parentRadius = parentRadius;
    stem.parent = parent;
    stem.firstPath = stem.firstSegment = index;
    stem.pathCount = stem.segmentCount = 1;
    all.stems.push_back(stem);
}

/// A trunk 4 m high with two branches, 1 m and 1.5 m up, that end at these places.
CTree treeWith(const glm::dvec3& low, const glm::dvec3& high, double helixRadius = 0) {
    const auto trunk = std::make_shared<CGeneration>(), branches = std::make_shared<CGeneration>();
    addStem(*trunk, {0, 0, 0}, {0, 0, 4}, 0, 0, -1);
    addStem(*branches, {0, 0, 1}, low, 1, kRadius, 0, helixRadius);
    addStem(*branches, {0, 0, 1.5}, high, 1.5, kRadius, 0);
    return CTree(4, {trunk, branches});
}
} // namespace

TEST(Crossings, BranchesThatMeetOutsideOfTheirParentCount) {
    EXPECT_EQ(countCrossings(treeWith({2, 0, 2}, {2, 0, 1}), CProgress(1)), 1u);
}

TEST(Crossings, ABranchDoesNotCrossItsParentNorOneThatLeavesElsewhere) {
    EXPECT_EQ(countCrossings(treeWith({2, 0, 1}, {2, 0, 2}), CProgress(1)), 0u);
    EXPECT_EQ(countCrossings(treeWith({2, 0, 2}, {-2, 0, 1}), CProgress(1)), 0u);
}

TEST(Crossings, OneThatPassesCloseByDoesNotCount) {
    EXPECT_EQ(countCrossings(treeWith({2, 0.3, 2}, {2, -0.3, 1}), CProgress(1)), 0u);
}

TEST(Crossings, OfAHelixTheLineCounts) {
    EXPECT_EQ(countCrossings(treeWith({2, 0.3, 2}, {2, -0.3, 1}, 0.2), CProgress(1)) +
                  countCrossings(treeWith({2, -0.3, 2}, {2, 0.3, 1}, 0.2), CProgress(1)),
              1u)
        << "it comes near on one side";
}

} // namespace stromar::test
