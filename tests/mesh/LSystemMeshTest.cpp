// Trees of another kind than Weber and Penn's, by the same mesher.
#include "mesh/MeshMeasures.h"
#include "stromar/mesh/JoinedStems.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/mesh/check/MeshCheck.h"
#include "stromar/tree/lsystem/TurtleStems.h"
#include <gtest/gtest.h>

namespace stromar::test {
namespace {

struct Figure {
    const char* name;
    std::string_view grammar;
    int steps;
    double lengthUnit, widthUnit, bend;
};
constexpr Figure kFigures[] = {
    {"monopodial", R"(
#define wr 0.707
axiom: A(1,10)
A(l,w) -> !(w)F(l)[&(30)B(l*0.7,w*wr)]/(137.5)A(l*0.9,w*wr)
B(l,w) -> !(w)F(l)[+(30)$C(l*0.7,w*wr)]C(l*0.9,w*wr)
C(l,w) -> !(w)F(l)[-(30)$B(l*0.7,w*wr)]B(l*0.9,w*wr))",
     8, 1, 0.03, 0},
    {"sympodial", R"(
#define wr 0.707
axiom: A(1,10)
A(l,w) -> !(w)F(l)[&(35)B(l*0.9,w*wr)]/(180)[&(35)B(l*0.8,w*wr)]
B(l,w) -> !(w)F(l)[+(35)$B(l*0.9,w*wr)][-(35)$B(l*0.8,w*wr)])",
     8, 1, 0.03, 0},
    {"ternary", R"(
#define vr 1.732
axiom: !(1)F(200)/(45)A
A -> !(vr)F(50)[&(18.95)F(50)A]/(94.74)[&(18.95)F(50)A]/(132.63)[&(18.95)F(50)A]
F(l) -> F(l*1.109)
!(w) -> !(w*vr))",
     5, 0.01, 0.01, 0.22}};
} // namespace

TEST(LSystemMesh, FiguresAreSoundAtEveryLevelOfDetail) {
    for (const Figure& figure : kFigures) {
        const CWord word = CRewriter(parseGrammar(figure.grammar), 1).derive(figure.steps, CProgress(2));
        TurtleParams params{.lengthUnit = figure.lengthUnit, .widthUnit = figure.widthUnit};
        params.tropism = {0, 0, -1};
        params.tropismBend = figure.bend;
        const auto generations = stemsOf(word, interpret(word, params, CProgress()), CProgress());
        const CTree tree(10, {generations.begin(), generations.end()});
        MeshParams mesh;
        mesh.minRadius = 0.0005;
        for (const Detail& detail : detailTable()) {
            SCOPED_TRACE(std::string(figure.name) + ", " + std::string(detail.name));
            const auto all = meshAllStems(tree, mesh, detail, CProgress(2));
            std::size_t surfaces = 0, attached = 0;
            for (std::size_t g = 0; g < all.size(); ++g) {
                const MeshFaults faults = checkStems(tree, static_cast<int>(g), all[g], all);
                EXPECT_EQ(inWords(faults), "") << "generation " << g;
                surfaces += faults.surfaces;
                attached += faults.attached;
            }
            EXPECT_GT(surfaces, 100u);
            if (detail.collarRings > 0) {
                EXPECT_GT(double(attached), 0.9 * double(surfaces)) << "branches grow out of the wood";
            }
        }
    }
}

/// A fork at each of its nodes: planning takes time linear in these, or this would take minutes.
TEST(LSystemMesh, AStemOfTwoThousandForksIsOneSurface) {
    const CWord word = CRewriter(parseGrammar(R"(
axiom: !(10)X(11)
X(k) : k > 0 -> X(k-1)X(k-1)
X(k) : k <= 0 -> F(10)[+(40)F(30)]/(90))"), 1).derive(12, CProgress());
    const auto generations = stemsOf(word, interpret(word, {.lengthUnit = 0.01, .widthUnit = 0.004}, CProgress()), CProgress());
    const CTree tree(10, {generations.begin(), generations.end()});
    const auto all = meshAllStems(tree, {}, detailOf(Model::Full), CProgress(2));
    const JoinedStems joined = joinStems(tree, all, CProgress(2));
    EXPECT_EQ(joined.joined, 2047u) << "all but the last, as which the stem runs on";
    const MeshFaults faults = checkJoined(joined, all);
    EXPECT_EQ(inWords(faults), "");
    EXPECT_EQ(faults.surfaces, 1u);
}

TEST(LSystemMesh, AStraightStemThinsWhereItsWidthDoesAtEveryLevelOfDetail) {
    const CWord word = CRewriter(parseGrammar("axiom: !(10)F(1)F(1)!(3)F(1)F(1)F(1)F(1)F(1)F(1)F(1)!(1)F(1)"), 1).derive(0, CProgress());
    const auto generations = stemsOf(word, interpret(word, {.lengthUnit = 1, .widthUnit = 0.03}, CProgress()), CProgress());
    const CTree tree(10, {generations.begin(), generations.end()});
    const auto volumeAt = [&](const Detail& detail) { return signedVolume(*meshAllStems(tree, {}, detail, CProgress()).front().mesh); };
    const double full = volumeAt(detailOf(Model::Full));
    for (const Detail& detail : detailTable()) EXPECT_NEAR(volumeAt(detail), full, 0.2 * full) << detail.name;
}

/// Of a branch's surface, 0..255.
double meanSkyVisibility(const CMesh& mesh) {
    double sum = 0, areas = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const std::uint32_t* v = &mesh.indices[t];
        const double area = glm::length(glm::cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]));
        for (int c = 0; c < 3; ++c) sum += area * mesh.looks[v[c]].skyVisibility / 3;
        areas += area;
    }
    return sum / areas;
}

TEST(LSystemMesh, ABranchOfOnePieceIsAsBrightAsOneOfManyWithoutACollar) {
    const auto brightnessOf = [](const std::string& branch) {
        const CWord word = CRewriter(parseGrammar("axiom: !(4)F(5)[&(90)!(1)" + branch + "]F(5)"), 1).derive(0, CProgress());
        const auto generations = stemsOf(word, interpret(word, {.lengthUnit = 1, .widthUnit = 0.06}, CProgress()), CProgress());
        const CTree tree(10, {generations.begin(), generations.end()});
        return meanSkyVisibility(*meshAllStems(tree, {}, detailOf(Model::Full, 3), CProgress()).at(1).mesh);
    };
    std::string pieces;
    for (int i = 0; i < 20; ++i) pieces += i % 2 == 0 ? "+(30)F(0.03)" : "-(30)F(0.03)";
    const double one = brightnessOf("F(0.6)"), many = brightnessOf(pieces);
    EXPECT_NEAR(one, many, 6);
    EXPECT_LT(one, 250) << "it is darker at its foot";
}

} // namespace stromar::test
