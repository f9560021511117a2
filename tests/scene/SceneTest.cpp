// Nodes and arrays, without an OpenGL context.
#include "Checkout.h"
#include "mesh/SampleTrees.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/model/Material.h"
#include "stromar/model/MeshValues.h"
#include "stromar/scene/OsgGeometry.h"
#include "stromar/scene/ViewScene.h"
#include <cstring>
#include <gtest/gtest.h>
#include <osg/Texture2D>
#include <osg/TriangleFunctor>
#include <set>
#include <tuple>

namespace stromar::test {

namespace {
struct TriangleCounter {
    std::size_t count = 0;
    void operator()(const osg::Vec3&, const osg::Vec3&, const osg::Vec3&, bool = false) { ++count; }
};

std::vector<std::shared_ptr<const CMesh>> aspenMeshes() {
    const CParams params = preset("quaking_aspen");
    return meshesOf(*grow(params), params, detailOf(Model::Simple));
}

template <typename Array>
const Array& as(const osg::Array* array) {
    return dynamic_cast<const Array&>(*array);
}

std::size_t drawablesUnder(const osg::Group& group) {
    std::size_t count = 0;
    for (unsigned i = 0; i < group.getNumChildren(); ++i) {
        if (group.getChild(i)->getNodeMask() == 0) continue; // switched off
        if (const osg::Group* inner = group.getChild(i)->asGroup())
            count += drawablesUnder(*inner);
        else
            count += group.getChild(i)->asDrawable() != nullptr;
    }
    return count;
}
} // namespace

TEST(OsgGeometry, IsACopyOfTheMesh) {
    for (const auto& mesh : aspenMeshes()) {
        const osg::ref_ptr<osg::Geometry> geometry = makeGeometry(*mesh);
        EXPECT_EQ(geometry->getName(), mesh->name);
        const auto& points = as<osg::Vec3Array>(geometry->getVertexArray());
        const auto& normals = as<osg::Vec3Array>(geometry->getNormalArray());
        const auto& coords = as<osg::Vec2Array>(geometry->getTexCoordArray(0));
        ASSERT_EQ(points.size(), mesh->vertexCount());
        ASSERT_EQ(normals.size(), mesh->vertexCount());
        ASSERT_EQ(coords.size(), mesh->vertexCount());
        EXPECT_EQ(normals.getBinding(), osg::Array::BIND_PER_VERTEX);
        for (std::size_t v = 0; v < mesh->vertexCount(); ++v)
            for (int i = 0; i < 3; ++i) {
                ASSERT_EQ(points[v][i], mesh->positions[v][i]);
                ASSERT_EQ(normals[v][i], mesh->normals[v][i]);
                if (i < 2) {
                    ASSERT_EQ(coords[v][i], mesh->texCoords[v][i]);
                }
            }
        osg::TriangleFunctor<TriangleCounter> counter;
        geometry->accept(counter);
        EXPECT_EQ(counter.count, mesh->triangleCount());
        const Bounds box = mesh->bounds();
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(geometry->getBoundingBox()._min[i], box.min[i]);
            EXPECT_EQ(geometry->getBoundingBox()._max[i], box.max[i]);
        }
    }
}

TEST(OsgGeometry, ForTheViewportKnowsHowOpenItLies) {
    for (const auto& mesh : aspenMeshes()) {
        EXPECT_EQ(makeGeometry(*mesh)->getNumVertexAttribArrays(), 0u) << "files do not";
        const osg::ref_ptr<osg::Geometry> geometry = makeViewGeometry(mesh);
        const auto* looks = geometry->getVertexAttribArray(kLookAttribute);
        ASSERT_TRUE(looks);
        ASSERT_EQ(looks->getNumElements(), mesh->vertexCount());
        EXPECT_TRUE(looks->getNormalize());
        EXPECT_EQ(std::memcmp(looks->getDataPointer(), mesh->looks.data(), mesh->vertexCount() * sizeof(VertexLook)), 0);
    }
}

TEST(OsgGeometry, AFewInstancesStandForAll) {
    const CParams params = preset("quaking_aspen");
    const auto tree = grow(params);
    const std::vector<StemMesh> stems = meshAllStems(*tree, meshParamsOf(params), detailOf(Model::Full), CProgress());
    const auto organs = meshOfOrgans(*tree, Organ::Leaf, plansOf(stems), meshParamsOf(params), detailOf(Model::Full), CProgress())[0];
    const osg::ref_ptr<osg::Geometry> geometry = makeInstancedGeometry(organs, CProgress());
    const auto* places = static_cast<const glm::vec4*>(geometry->getVertexAttribArray(kInstancePlaceAttribute)->getDataPointer());
    const std::size_t count = organs->count(), points = organs->blade().points.size();
    const auto middle = [&](std::size_t first) {
        glm::dvec3 sum(0);
        for (std::size_t i = 0; i < first; ++i) sum += glm::dvec3(places[i]) / double(first);
        return sum;
    };
    const auto growth = [&] {
        float value = 0;
        geometry->getStateSet()->getUniform("growth")->get(value);
        return double(value);
    };
    EXPECT_EQ(growth(), 1);
    const glm::dvec3 all = middle(count);
    for (const std::size_t part : {4u, 50u}) {
        limitInstances(*geometry, count * points / part);
        const auto shown = static_cast<std::size_t>(geometry->getPrimitiveSet(0)->getNumInstances());
        EXPECT_NEAR(double(shown), double(count) / double(part), 1);
        EXPECT_NEAR(growth(), std::sqrt(double(part)), 0.01) << "the area stays";
        EXPECT_LT(glm::distance(middle(shown), all), 0.02 * tree->height()) << "spread over the tree";
    }
    limitInstances(*geometry, count * points);
    EXPECT_EQ(static_cast<std::size_t>(geometry->getPrimitiveSet(0)->getNumInstances()), count);
    EXPECT_EQ(growth(), 1);
    std::set<std::tuple<float, float, float>> drawn, there;
    for (std::size_t i = 0; i < count; ++i) {
        drawn.emplace(places[i].x, places[i].y, places[i].z);
        const glm::vec3 at = organs->place(i).position;
        there.emplace(at.x, at.y, at.z);
    }
    EXPECT_EQ(drawn, there) << "each once";
}

TEST(ViewScene, ShowsWhatItIsGiven) {
    CViewScene scene;
    const std::size_t stage = drawablesUnder(*scene.root());
    EXPECT_FALSE(scene.bounds().valid()) << "the stage is no tree";
    std::vector<ViewPart> parts;
    osg::BoundingBox wanted;
    for (const auto& mesh : aspenMeshes()) {
        parts.push_back({makeGeometry(*mesh), mesh->surface});
        wanted.expandBy(parts.back().geometry->getBoundingBox());
    }
    for (int times = 0; times < 2; ++times) {
        scene.show(parts);
        EXPECT_EQ(drawablesUnder(*scene.root()), stage + 2 * parts.size())
            << "by the eye and by the sun; the older tree is replaced";
        scene.finishFrame();
        EXPECT_EQ(drawablesUnder(*scene.root()), stage + parts.size()) << "the shadows are there";
        EXPECT_EQ(scene.bounds()._min, wanted._min);
        EXPECT_EQ(scene.bounds()._max, wanted._max);
    }
    scene.show({});
    EXPECT_EQ(drawablesUnder(*scene.root()), stage);
    EXPECT_FALSE(scene.bounds().valid());
}

TEST(ViewScene, AStandInIsDrawnInPlaceOfTheTreeWhereAPassWantsIt) {
    CViewScene scene;
    const auto meshes = aspenMeshes();
    std::vector<ViewPart> parts, simple;
    for (const auto& mesh : meshes) parts.push_back({makeGeometry(*mesh), mesh->surface});
    simple.push_back({makeGeometry(*meshes[0]), meshes[0]->surface});
    scene.show(parts);
    scene.finishFrame();
    const std::size_t whole = drawablesUnder(*scene.root());
    const osg::BoundingBox room = scene.bounds();
    ViewPass moving;
    moving.standIn = true;
    scene.setPass(moving, 0.001, 20);
    EXPECT_EQ(drawablesUnder(*scene.root()), whole) << "there is none yet";
    scene.setStandIn(simple);
    scene.setPass(moving, 0.001, 20);
    EXPECT_EQ(drawablesUnder(*scene.root()), whole - parts.size() + simple.size());
    EXPECT_EQ(scene.bounds()._max, room._max) << "framed as the tree itself";
    scene.setPass({}, 0.001, 20);
    EXPECT_EQ(drawablesUnder(*scene.root()), whole) << "at rest";
}

TEST(ViewScene, ARayMeetsTheTree) {
    CViewScene scene;
    std::vector<ViewPart> parts;
    int generation = 0;
    for (const auto& mesh : aspenMeshes())
        parts.push_back(
            {makeGeometry(*mesh), mesh->surface, mesh->surface == Surface::Leaf ? ViewPart::kLeaves : generation++});
    scene.show(parts);
    const auto trunk = scene.pick({0, -50, 1}, {0, 1, 0});
    ASSERT_TRUE(trunk);
    EXPECT_EQ(trunk->generation, 0);
    EXPECT_LT(trunk->point.y(), 0) << "the near side";
    EXPECT_NEAR(trunk->point.z(), 1, 1e-3);
    EXPECT_FALSE(scene.pick({0, -50, 1}, {0, -1, 0})) << "away from it";
    const osg::BoundingBox box = scene.bounds();
    bool leaf = false;
    for (float x = box.xMin(); x < box.xMax(); x += 0.1f) {
        const auto hit = scene.pick({x, -50, double(box.zMax()) * 0.7}, {0, 1, 0});
        leaf = leaf || (hit && hit->generation == ViewPart::kLeaves);
    }
    EXPECT_TRUE(leaf);
    scene.setLook({.leaves = false});
    for (float x = box.xMin(); x < box.xMax(); x += 0.1f) {
        const auto hit = scene.pick({x, -50, double(box.zMax()) * 0.7}, {0, 1, 0});
        EXPECT_FALSE(hit && hit->generation == ViewPart::kLeaves) << "hidden ones cannot be met";
    }
}

TEST(ViewScene, TheStageDoesNotChangeWhatIsFramed) {
    CViewScene scene;
    const auto trunk = makeGeometry(*aspenMeshes().front());
    scene.show({{trunk, Surface::Bark}});
    EXPECT_NEAR(scene.root()->getBound().radius(), trunk->getBound().radius(), 0.01 * trunk->getBound().radius());
}

class Barks : public testing::Test {
protected:
    /// Three levels, each less than half as thick as the one before.
    std::shared_ptr<const TreeModel> model() const {
        CTreeCreator creator;
        return creator.create(m_params, detailOf(Model::Simple), CProgress());
    }
    std::vector<ViewPart> parts() const { return viewPartsOf(*model(), {}, CProgress()); }

    CParams m_params = preset("quaking_aspen");
};

TEST_F(Barks, ThoseOfLevelsWithoutOneAreThatOfTheLevelBefore) {
    TextParams& text = m_params.text;
    text.bark1Texture = text.bark2Texture = text.bark3Texture = "";
    for (const Surface bark : kBarks) EXPECT_EQ(shownSurface(m_params, bark), Surface::Bark);
    text.bark2Texture = "bark:smooth";
    EXPECT_EQ(shownSurface(m_params, Surface::Bark1), Surface::Bark);
    EXPECT_EQ(shownSurface(m_params, Surface::Bark2), Surface::Bark2);
    EXPECT_EQ(shownSurface(m_params, Surface::Bark3), Surface::Bark2);
    EXPECT_EQ(shownSurface(m_params, Surface::Leaf), Surface::Leaf);
}

TEST_F(Barks, GiveWayToOneAnotherWhereWoodGetsThinner) {
    TextParams& text = m_params.text;
    text.bark1Texture = text.bark3Texture = "";
    text.bark2Texture = "bark:smooth";
    const auto shown = parts();
    ASSERT_GE(shown.size(), 3u);
    const auto tree = model()->tree;
    const auto thinness = [&](std::size_t generation) {
        double sum = 0;
        for (const CStem& stem : tree->generation(generation).stems) sum += stem.radius;
        return thinnessOf(sum / double(tree->generation(generation).stems.size()), tree->generation(0).stems[0].radius) / 255.0f;
    };
    for (const ViewPart& part : shown) {
        const auto& [older, younger] = part.neighbours;
        const auto share = [](const NeighbourBark& bark, float at) { return (at - bark.from) * bark.rate; };
        if (part.generation == 0 || part.generation == 1) {
            EXPECT_EQ(part.surface, Surface::Bark);
            EXPECT_EQ(older.rate, 0);
            EXPECT_EQ(younger.surface, Surface::Bark2);
            EXPECT_NEAR(share(younger, thinness(1)), 0, 1e-5);
            EXPECT_NEAR(share(younger, thinness(2)), 1, 1e-5);
        } else if (part.generation >= 2) {
            EXPECT_EQ(part.surface, Surface::Bark2);
            EXPECT_EQ(older.surface, Surface::Bark);
            EXPECT_NEAR(share(older, thinness(2)), 0, 1e-5);
            EXPECT_NEAR(share(older, thinness(1)), 1, 1e-5);
            EXPECT_EQ(younger.rate, 0);
        }
    }
}

TEST_F(Barks, AreSharedOnlyWhereThereAreSeveral) {
    m_params.text.bark1Texture = m_params.text.bark2Texture = m_params.text.bark3Texture = "";
    for (const ViewPart& part : parts())
        for (const NeighbourBark& other : part.neighbours) EXPECT_EQ(other.rate, 0);
}

TEST(ViewScene, SaysWhichPictureIsMissing) {
    CViewScene scene;
    for (const Surface surface : {Surface::Bark, Surface::Leaf}) {
        scene.setSurface(surface, *readSurface(surface, ""));
        EXPECT_EQ(readSurface(surface, inSource("textures/leaf.png"))->problem, "");
        EXPECT_NE(readSurface(surface, "/none/such.png")->problem.find("/none/such.png"), std::string::npos);
    }
}

} // namespace stromar::test
