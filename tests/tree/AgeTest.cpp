// Trees at an age: continuous, part of the grown tree, and still. Strands have a file of their own.
#include "Checkout.h"
#include "stromar/params/TreeFile.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/params/methods/strands/StrandsParams.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/tree/lsystem/LSystemBuilder.h"
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include "stromar/util/Random.h"
#include <filesystem>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <unordered_map>

namespace stromar::test {
namespace {

std::vector<std::pair<std::string, CParams>> presetsOf(const ParamBlock& wanted) {
    for (const ParamBlock* block : {&lsystemBlock(), &strandsBlock()}) registerBlock(*block); // no table of methods is there
    std::vector<std::pair<std::string, CParams>> found;
    for (const auto& entry : std::filesystem::directory_iterator(inSource("presets"))) {
        CParams params = CTreeFile::read(entry.path()).params();
        if (&params.block() == &wanted) found.emplace_back(entry.path().stem(), params);
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

/// Points of the axes of a tree, found by their place.
class CAxisPoints {
public:
    explicit CAxisPoints(const CTree& tree, double reach) : m_reach(reach) {
        for (const auto& generation : tree.generations())
            for (const CSegment& segment : generation->segments) {
                add({segment.position, segment.radiusBase});
                add({segment.axisPoint(1), segment.radiusEnd});
            }
    }
    struct Point {
        glm::dvec3 at;
        double radius;
    };
    const std::vector<Point>& points() const { return m_points; }
    bool hasNear(const Point& p, double radiusApart) const {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z) {
                    const auto [begin, end] = m_cells.equal_range(cellOf(p.at + m_reach * glm::dvec3(x, y, z)));
                    for (auto i = begin; i != end; ++i) {
                        const Point& other = m_points[i->second];
                        if (glm::distance(other.at, p.at) < m_reach && std::abs(other.radius - p.radius) < radiusApart) return true;
                    }
                }
        return false;
    }

private:
    void add(const Point& point) {
        m_cells.emplace(cellOf(point.at), m_points.size());
        m_points.push_back(point);
    }
    std::uint64_t cellOf(const glm::dvec3& at) const {
        std::uint64_t hash = 0;
        for (int i = 0; i < 3; ++i) hash = hashCombine(hash, static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(at[i] / m_reach))));
        return hash;
    }
    double m_reach;
    std::vector<Point> m_points;
    std::unordered_multimap<std::uint64_t, std::size_t> m_cells;
};

bool isPalm(const CParams& params) { return weberPenn(params).baseSize > 0.8; }
} // namespace

TEST(Age, SpeciesGrowWithoutAJump) {
    constexpr double kStep = 1e-3;
    for (const auto& [name, params] : presetsOf(weberPennBlock())) {
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
    for (const auto& [name, params] : presetsOf(weberPennBlock())) {
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
    for (const auto& [name, params] : presetsOf(weberPennBlock())) {
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

/// A module is as wide as the trunk within one derivation, hence smaller steps than for other trees.
TEST(Age, GrammarsGrowWithoutAJump) {
    for (const auto& [name, params] : presetsOf(lsystemBlock())) {
        SCOPED_TRACE(name);
        const CLSystemBuilder builder;
        const auto grown = builder.build(params, nullptr, 0, CProgress(2));
        const int steps = lsystem(params).derivations + 1;
        const double step = std::min(1e-3, 0.005 / steps);
        double trunk = 0;
        for (const CSegment& segment : grown->generation(0).segments) trunk = std::max(trunk, segment.radiusBase);
        std::vector<double> ages{0.37, 0.913, 1 - step};
        for (int i = 1; i < steps; ++i) ages.push_back(double(i) / steps - step / 2); // across every derivation
        for (const double age : ages) {
            const auto before = builder.atAge(params, grown, age, CProgress(2)), after = builder.atAge(params, grown, age + step, CProgress(2));
            if (before->generationCount() == 0) continue; // the axiom draws nothing
            const CAxisPoints now(*before, 0.01 * grown->height()), then(*after, 0.01 * grown->height());
            const double anyRadius = 100 * trunk;
            std::size_t gone = 0, sprung = 0;
            for (const auto& point : now.points()) gone += !then.hasNear(point, 0.01 * trunk);
            for (const auto& generation : after->generations())
                for (const CSegment& segment : generation->segments)
                    sprung += segment.length > 0.01 * grown->height() && !now.hasNear({segment.axisPoint(1), 0}, anyRadius);
            EXPECT_EQ(gone, 0u) << age << " of " << now.points().size();
            EXPECT_EQ(sprung, 0u) << age << ": what is new starts with nothing";
            EXPECT_LE(before->stemCount(), after->stemCount()) << age;
        }
    }
}

TEST(Age, AGrammarGrowsFromNothingToItsLastWord) {
    CParams params(lsystemBlock());
    lsystem(params).grammar = "axiom: F(2)A\nA -> F(1)A\nF(l) -> F(l*2)";
    lsystem(params).derivations = 3;
    const CLSystemBuilder builder;
    const auto lengthAt = [&](double age) {
        const auto tree = builder.atAge(params, builder.build(params, nullptr, 0, CProgress()), age, CProgress());
        return tree->generationCount() == 0 ? 0 : tree->generation(0).stems[0].length;
    };
    EXPECT_EQ(lengthAt(0), 0);
    EXPECT_NEAR(lengthAt(0.125), 1, 1e-6) << "half of the axiom";
    EXPECT_NEAR(lengthAt(0.25), 2, 1e-9);
    EXPECT_NEAR(lengthAt(0.375), 3.5, 1e-6) << "2 on its way to 4, and half of a new F";
    EXPECT_NEAR(lengthAt(0.5), 5, 1e-9);
    EXPECT_NEAR(lengthAt(1), 16 + 4 + 2 + 1, 1e-9);
    lsystem(params).grammar = "axiom: F(2)F(1)\nF(l) : l > 1 -> G";
    lsystem(params).derivations = 1;
    EXPECT_NEAR(lengthAt(0.75), 2, 1e-6) << "what has no heir shrinks";
}

} // namespace stromar::test
