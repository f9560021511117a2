// The checker itself: each fault, planted into a sound tree, is found and named.
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "mesh/MeshMeasures.h"
#include "mesh/SampleTrees.h"
#include <gtest/gtest.h>
#include <limits>

namespace stromar::test {

namespace {
/// A small tree whose meshes can be spoilt.
class MeshCheckTest : public testing::Test {
protected:
    MeshCheckTest() : m_params(preset("quaking_aspen")) {
        weberPenn(m_params).levels = 2;
        weberPenn(m_params).level[1].branches = 12;
        m_tree = grow(m_params);
        m_all = meshAllStems(*m_tree, meshParamsOf(m_params), detailOf(Model::Full), CProgress(2));
    }

    /// The faults of the branches after `spoil(mesh, tube)`, whose tube is the first with a collar.
    template <typename Spoil>
    MeshFaults faultsAfter(Spoil&& spoil) {
        auto mesh = std::make_shared<CMesh>(*m_all[1].mesh);
        for (const Tube& tube : m_all[1].plan.tubes)
            if (tube.collarRings > 0) {
                spoil(*mesh, tube);
                break;
            }
        return checkStems(*m_tree, 1, {m_all[1].plan, mesh}, m_all);
    }

    CParams m_params;
    std::shared_ptr<const CTree> m_tree;
    std::vector<StemMesh> m_all;
};

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
} // namespace

TEST_F(MeshCheckTest, ASoundMeshHasNone) {
    const MeshFaults faults = faultsAfter([](CMesh&, const Tube&) {});
    EXPECT_TRUE(faults.sound()) << inWords(faults);
    EXPECT_EQ(faults.surfaces, 12u);
    EXPECT_GT(faults.attached, 10u);
    EXPECT_EQ(faults.triangles, m_all[1].mesh->triangleCount());
}

TEST_F(MeshCheckTest, FindsNumbersThatAreNone) {
    const auto faults = faultsAfter([](CMesh& mesh, const Tube& tube) { mesh.texCoords[tube.firstVertex].y = kNaN; });
    EXPECT_EQ(faults.badNumbers, 1u);
    EXPECT_FALSE(faults.sound());
}

TEST_F(MeshCheckTest, FindsLongNormals) {
    const auto faults = faultsAfter([](CMesh& mesh, const Tube& tube) { mesh.normals[tube.firstVertex] *= 1.1f; });
    EXPECT_EQ(inWords(faults), "1 bad normals; ");
}

TEST_F(MeshCheckTest, FindsTurnedNormals) {
    const auto faults = faultsAfter([](CMesh& mesh, const Tube& tube) {
        mesh.normals[tube.firstVertex + 1] = -mesh.normals[tube.firstVertex + 1];
    });
    EXPECT_EQ(inWords(faults), "3 tilted normals; ");
}

TEST_F(MeshCheckTest, FindsIndicesOfAnotherSurface) {
    const auto faults = faultsAfter([](CMesh& mesh, const Tube& tube) {
        mesh.indices[tube.firstIndex] = tube.firstVertex + static_cast<std::uint32_t>(tube.vertexCount());
    });
    EXPECT_EQ(faults.badIndices, 1u);
}

TEST_F(MeshCheckTest, FindsAHole) {
    const auto faults = faultsAfter([](CMesh& mesh, const Tube& tube) {
        // The first triangle becomes a copy of one that lies on the other side of its own edge.
        for (int c = 0; c < 3; ++c)
            mesh.indices[tube.firstIndex + std::size_t(c)] = mesh.indices[tube.firstIndex + 9 + std::size_t(c)];
    });
    EXPECT_EQ(faults.open, 1u);
    EXPECT_EQ(faults.tangled, 1u);
}

TEST_F(MeshCheckTest, FindsATriangleTurnedOver) {
    const auto faults = faultsAfter([](CMesh& mesh, const Tube& tube) {
        std::swap(mesh.indices[tube.firstIndex], mesh.indices[tube.firstIndex + 1]);
    });
    EXPECT_EQ(faults.tangled, 1u);
    EXPECT_EQ(faults.tilted, 1u);
}

TEST_F(MeshCheckTest, FindsFlatTrianglesAndUnusedVertices) {
    const auto faults = faultsAfter(
        [](CMesh& mesh, const Tube& tube) { mesh.indices[tube.firstIndex] = mesh.indices[tube.firstIndex + 1]; });
    EXPECT_EQ(faults.flat, 1u);
    const auto idle = faultsAfter([](CMesh& mesh, const Tube& tube) {
        for (std::size_t i = tube.firstIndex; i < tube.firstIndex + tube.indexCount(); ++i)
            if (mesh.indices[i] == tube.firstVertex) mesh.indices[i] = tube.firstVertex + tube.points;
    });
    EXPECT_EQ(inWords(idle), "1 unused vertices; ");
}

TEST_F(MeshCheckTest, MeasuresCollars) {
    const auto moved = [&](double radii) {
        return faultsAfter([&](CMesh& mesh, const Tube& tube) {
            const CStem& stem = m_tree->generation(1).stems[tube.stem];
            const CSegment& first = m_tree->generation(1).segments[stem.firstSegment];
            for (std::uint32_t v = tube.firstVertex; v < tube.firstVertex + tube.vertexCount(); ++v)
                mesh.positions[v] += glm::vec3(radii * stem.radius * first.frame[2]);
        });
    };
    EXPECT_EQ(inWords(moved(0.05)), "1 floating collars; ");
    EXPECT_EQ(inWords(moved(-0.05)), "1 buried collars; ");
}

} // namespace stromar::test
