// Weber and Penn's trees at an age: continuous, nested in the grown tree, and still.
#include "stromar/params/TreeFile.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/params/methods/strands/StrandsParams.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include "stromar/util/Random.h"
#include <filesystem>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <unordered_map>

namespace stromar::test {
namespace {

std::vector<std::pair<std::string, CParams>> species() {
    for (const ParamBlock* block : {&lsystemBlock(), &strandsBlock()}) registerBlock(*block); // no table of methods is there
    std::vector<std::pair<std::string, CParams>> found;
    for (const auto& entry : std::filesystem::directory_iterator(STROMAR_SOURCE "/presets")) {
        CParams params = CTreeFile::read(entry.path()).params();
        if (&params.block() == &weberPennBlock()) found.emplace_back(entry.path().stem(), params);
    }
    return found;
}

struct Piece {
    glm::dvec3 base, end;
    double radiusBase;
};
/// By the names of stem and path, and the place in it.
std::unordered_map<std::uint64_t, Piece> piecesOf(const CTree& tree) {
    std::unordered_map<std::uint64_t, Piece> pieces;
    for (std::size_t g = 0; g < tree.generationCount(); ++g) {
        const CGeneration& all = tree.generation(g);
        for (const CStem& stem : all.stems)
            for (std::uint32_t p = 0; p < stem.pathCount; ++p) {
                const CPath& path = all.paths[stem.firstPath + p];
                for (std::uint32_t s = 0; s < path.segmentCount; ++s) {
                    const CSegment& segment = all.segments[path.firstSegment + s];
                    pieces[hashCombine(hashCombine(stem.id, path.id), path.firstPosition + s)] = {segment.centre(0), segment.centre(1), segment.radiusBase};
                }
            }
    }
    return pieces;
}

bool isPalm(const CParams& params) { return weberPenn(params).baseSize > 0.8; }
} // namespace

TEST(Age, SpeciesGrowWithoutAJump) {
    constexpr double kStep = 1e-3;
    for (const auto& [name, params] : species()) {
        SCOPED_TRACE(name);
        const CWeberPennBuilder builder;
        const auto grown = builder.build(params, nullptr, 0, CProgress(2));
        const double height = grown->height(), trunk = grown->generation(0).stems[0].radius;
        for (const double age : {0.02, 0.11, 0.35, 0.62, 0.86, 0.97, 1 - kStep}) {
            const auto before = builder.atAge(params, grown, age, CProgress(2)), after = builder.atAge(params, grown, age + kStep, CProgress(2));
            const auto then = piecesOf(*after);
            double moved = 0, widened = 0;
            for (const auto& [id, piece] : piecesOf(*before)) {
                const auto now = then.find(id);
                ASSERT_NE(now, then.end()) << "nothing goes, at " << age;
                moved = std::max({moved, glm::distance(piece.base, now->second.base), glm::distance(piece.end, now->second.end)});
                widened = std::max(widened, std::abs(piece.radiusBase - now->second.radiusBase));
            }
            EXPECT_LT(moved, 0.01 * height) << age;
            EXPECT_LT(widened, 0.01 * trunk) << age;
            EXPECT_LE(before->stemCount(), after->stemCount()) << age;
        }
    }
}

TEST(Age, AYoungTreeIsTheGrownOneCut) {
    for (const auto& [name, params] : species()) {
        SCOPED_TRACE(name);
        const CWeberPennBuilder builder;
        const auto grown = builder.build(params, nullptr, 0, CProgress(2));
        EXPECT_EQ(builder.atAge(params, grown, 1, CProgress()), grown);
        EXPECT_EQ(builder.atAge(params, grown, 0, CProgress())->generationCount(), 0u);
        const auto all = piecesOf(*grown);
        const auto young = builder.atAge(params, grown, 0.6, CProgress(2));
        ASSERT_GT(young->generationCount(), 0u);
        EXPECT_NEAR(young->generation(0).stems[0].length, (1 - 0.064) * grown->generation(0).stems[0].length, 1e-9);
        for (const auto& [id, piece] : piecesOf(*young)) {
            ASSERT_TRUE(all.contains(id));
            if (!isPalm(params)) {
                EXPECT_LT(glm::distance(piece.base, all.at(id).base), 1e-9) << "wood never moves along its parent";
            }
            EXPECT_LE(piece.radiusBase, all.at(id).radiusBase * (1 + 1e-12));
        }
        for (std::size_t g = 1; g < young->generationCount(); ++g)
            for (const CStem& stem : young->generation(g).stems) {
                const CGeneration& below = young->generation(g - 1);
                const CStem& parent = below.stems.at(static_cast<std::size_t>(stem.parent));
                ASSERT_LT(stem.path, parent.pathCount);
                EXPECT_LE(stem.offset, parent.length * (1 + 1e-9));
                const CSegment& wood = below.segmentAt(parent, stem.path, stem.position);
                const double t = (stem.offset - wood.start) / wood.length;
                const glm::dvec3 base = young->generation(g).segments[stem.firstSegment].position;
                if (wood.helixRadius == 0) {
                    EXPECT_LT(glm::distance(base, wood.axisPoint(t)), 1e-6) << "it sits on its parent";
                }
            }
    }
}

TEST(Age, ChildrenAreNeverThickerThanTheirParents) {
    for (const auto& [name, params] : species()) {
        SCOPED_TRACE(name);
        const CWeberPennBuilder builder;
        const auto grown = builder.build(params, nullptr, 0, CProgress(2));
        for (const double age : {0.2, 0.5, 0.8, 0.95}) {
            const auto young = builder.atAge(params, grown, age, CProgress(2));
            for (std::size_t g = 1; g < young->generationCount(); ++g)
                for (const CStem& stem : young->generation(g).stems)
                    if (!isPalm(params)) {
                        EXPECT_LE(stem.radius, stem.parentRadius * (1 + 1e-9) + 1e-9) << age;
                    }
        }
    }
}

} // namespace stromar::test
