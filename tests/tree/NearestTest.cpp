#include "stromar/tree/Nearest.h"
#include "tree/Support.h"
#include <gtest/gtest.h>

namespace stromar {
namespace {

TEST(Nearest, EveryStemIsTheNearestToItsOwnAxis) {
    const std::shared_ptr<const CTree> tree = test::grow(test::preset("quaking_aspen"));
    for (std::size_t g = 0; g < 2; ++g)
        for (std::uint32_t i = 0; i < tree->generation(g).stems.size(); ++i) {
            const CStem& stem = tree->generation(g).stems[i];
            const CSegment& last = tree->generation(g).segments[stem.firstSegment + stem.segmentCount - 1];
            EXPECT_EQ(nearestStem(*tree, g, last.centre(0.7)), i);
        }
    EXPECT_FALSE(nearestStem(*tree, 9, {0, 0, 0}));
}

TEST(Nearest, EveryLeafIsTheNearestToItsMiddle) {
    const std::shared_ptr<const CTree> tree = test::grow(test::preset("quaking_aspen"));
    for (std::uint32_t i = 0; i < tree->leaves().size(); i += 500) {
        const CLeaf& leaf = tree->leaves()[i];
        EXPECT_EQ(nearestLeaf(*tree, glm::dvec3(leaf.position + 0.5f * leaf.length * leaf.axis)), i);
    }
}

} // namespace
} // namespace stromar
