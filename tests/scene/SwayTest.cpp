// The wind on the graphics card is the wind of the processor.
#include "Shaders.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Render.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/model/ModelSway.h"
#include "stromar/scene/Headless.h"
#include "stromar/scene/OsgGeometry.h"
#include <EGL/egl.h>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

namespace stromar::test {
namespace {

struct Swaying {
    std::shared_ptr<const TreeModel> model;
    std::shared_ptr<const ModelSway> sway;
    std::shared_ptr<WindPose> pose = std::make_shared<WindPose>();
    double seconds = 7.3, loop = 20;
};

Swaying swaying(const std::string& name, const Detail& detail) {
    Swaying all;
    CTreeCreator creator;
    all.model = creator.create(preset(name), detail, CProgress());
    all.sway = swayOf(all.model, nullptr, CProgress());
    all.sway->table->pose({.strength = 1, .gusts = 1, .loop = all.loop}, all.seconds, *all.pose, CProgress());
    return all;
}

template <typename Function>
Function proc(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

constexpr int kNodesOfLine = 1024;

/// Runs the viewport's own placing of vertices on the card and takes back what comes out.
class CPlacesOnCard {
public:
    explicit CPlacesOnCard(const Swaying& tree) : m_tree(tree) {
        const auto create = proc<PFNGLCREATESHADERPROC>("glCreateShader");
        const unsigned shader = create(GL_VERTEX_SHADER);
        const char* const sources[] = {
            kPlaceFunctions, "varying vec3 outPlace;\nvoid main() { outPlace = placeOfVertex(); gl_Position = vec4(outPlace, 1.0); }\n"};
        proc<PFNGLSHADERSOURCEPROC>("glShaderSource")(shader, 2, sources, nullptr);
        proc<PFNGLCOMPILESHADERPROC>("glCompileShader")(shader);
        m_program = proc<PFNGLCREATEPROGRAMPROC>("glCreateProgram")();
        proc<PFNGLATTACHSHADERPROC>("glAttachShader")(m_program, shader);
        const char* captured = "outPlace";
        proc<PFNGLTRANSFORMFEEDBACKVARYINGSPROC>("glTransformFeedbackVaryings")(m_program, 1, &captured,
                                                                                GL_INTERLEAVED_ATTRIBS);
        proc<PFNGLLINKPROGRAMPROC>("glLinkProgram")(m_program);
        int linked = 0;
        proc<PFNGLGETPROGRAMIVPROC>("glGetProgramiv")(m_program, GL_LINK_STATUS, &linked);
        EXPECT_TRUE(linked);
        proc<PFNGLUSEPROGRAMPROC>("glUseProgram")(m_program);
        const auto& still = tree.sway->table->still();
        const int lines = static_cast<int>(still.size()) / kNodesOfLine + 1;
        std::vector<glm::vec4> points(static_cast<std::size_t>(lines) * kNodesOfLine), rows(2 * points.size());
        for (std::size_t i = 0; i < still.size(); ++i) points[i] = glm::vec4(still[i], 0);
        std::ranges::copy(tree.pose->rows, rows.begin());
        upload(0, "swayRows", rows, 2 * kNodesOfLine, lines);
        upload(1, "swayStill", points, kNodesOfLine, lines);
        const auto uniform2 = proc<PFNGLUNIFORM2FPROC>("glUniform2f");
        proc<PFNGLUNIFORM1FPROC>("glUniform1f")(at("swaying"), 1);
        proc<PFNGLUNIFORM2FPROC>("glUniform2f")(at("swaySize"), kNodesOfLine, static_cast<float>(lines));
        uniform2(at("swayTime"), static_cast<float>(tree.seconds), static_cast<float>(tree.loop));
    }

    /// `instances` empty: wood; else for every vertex.
    std::vector<glm::vec3> places(const std::vector<glm::vec3>& vertices, const std::vector<glm::vec4>& hang,
                                  const std::vector<InstancePlace>& instances = {}) {
        proc<PFNGLUNIFORM1FPROC>("glUniform1f")(at("instanced"), instances.empty() ? 0.f : 1.f);
        proc<PFNGLUNIFORM1FPROC>("glUniform1f")(at("growth"), 1.f);
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(3, GL_FLOAT, 0, vertices.data());
        std::vector<glm::vec4> feet, turns;
        std::vector<float> widths;
        for (const InstancePlace& place : instances) {
            feet.emplace_back(place.position, place.length);
            turns.push_back(place.turn);
            widths.push_back(place.width);
        }
        attribute("swayPlace", 4, hang.data());
        if (!instances.empty()) {
            attribute("instancePlace", 4, feet.data());
            attribute("instanceTurn", 4, turns.data());
            attribute("instanceWidth", 1, widths.data());
        }
        unsigned buffer = 0;
        proc<PFNGLGENBUFFERSPROC>("glGenBuffers")(1, &buffer);
        proc<PFNGLBINDBUFFERBASEPROC>("glBindBufferBase")(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
        const auto bytes = static_cast<GLsizeiptr>(vertices.size() * sizeof(glm::vec3));
        proc<PFNGLBUFFERDATAPROC>("glBufferData")(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STATIC_READ);
        glEnable(GL_RASTERIZER_DISCARD);
        proc<PFNGLBEGINTRANSFORMFEEDBACKPROC>("glBeginTransformFeedback")(GL_POINTS);
        glDrawArrays(GL_POINTS, 0, static_cast<int>(vertices.size()));
        proc<PFNGLENDTRANSFORMFEEDBACKPROC>("glEndTransformFeedback")();
        glDisable(GL_RASTERIZER_DISCARD);
        std::vector<glm::vec3> out(vertices.size());
        proc<PFNGLGETBUFFERSUBDATAPROC>("glGetBufferSubData")(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, out.data());
        proc<PFNGLDELETEBUFFERSPROC>("glDeleteBuffers")(1, &buffer);
        for (const unsigned attribute : m_enabled) proc<PFNGLDISABLEVERTEXATTRIBARRAYPROC>("glDisableVertexAttribArray")(attribute);
        m_enabled.clear(); // the next draw must not read what is gone then
        EXPECT_EQ(glGetError(), unsigned{GL_NO_ERROR});
        return out;
    }

private:
    int at(const char* name) { return proc<PFNGLGETUNIFORMLOCATIONPROC>("glGetUniformLocation")(m_program, name); }

    void upload(int unit, const char* name, const std::vector<glm::vec4>& texels, int width, int lines) {
        unsigned texture = 0;
        glGenTextures(1, &texture);
        proc<PFNGLACTIVETEXTUREPROC>("glActiveTexture")(GL_TEXTURE0 + static_cast<unsigned>(unit));
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, lines, 0, GL_RGBA, GL_FLOAT, texels.data());
        proc<PFNGLUNIFORM1IPROC>("glUniform1i")(at(name), unit);
    }

    void attribute(const char* name, int size, const void* values) {
        const int place = proc<PFNGLGETATTRIBLOCATIONPROC>("glGetAttribLocation")(m_program, name);
        ASSERT_GE(place, 0) << name;
        m_enabled.push_back(static_cast<unsigned>(place));
        proc<PFNGLENABLEVERTEXATTRIBARRAYPROC>("glEnableVertexAttribArray")(m_enabled.back());
        proc<PFNGLVERTEXATTRIBPOINTERPROC>("glVertexAttribPointer")(static_cast<unsigned>(place), size, GL_FLOAT,
                                                                    GL_FALSE, 0, values);
    }

    const Swaying& m_tree;
    unsigned m_program = 0;
    std::vector<unsigned> m_enabled; ///< attributes
};

double largestStep(const std::vector<glm::vec3>& card, const RawVector<glm::vec3>& processor) {
    double largest = 0;
    for (std::size_t i = 0; i < card.size(); ++i)
        largest = std::max(largest, double(glm::distance(card[i], processor[i])));
    return largest;
}

TEST(Sway, TheCardPutsEveryVertexWhereTheProcessorDoes) {
    CViewScene scene;
    const CHeadlessPainter context(scene, 1); // makes a context current
    for (const char* name : {"quaking_aspen", "weeping_willow", "strand_oak", "abop_2_8b"}) {
        const Swaying tree = swaying(name, detailOf(Model::Simple));
        CPlacesOnCard card(tree);
        const double allowed = 1e-4 * tree.model->tree->height(); // 1 mm of 10 m
        tree.model->visitMeshes(
            [&](const std::shared_ptr<const CMesh>& mesh, int) {
                const SwayPlaces& places = *tree.sway->placesOf(*mesh);
                std::vector<glm::vec4> hang;
                for (const SwayPlace& place : places) hang.emplace_back(place.node, place.part, 0, 0);
                const auto drawn = card.places({mesh->positions.begin(), mesh->positions.end()}, hang);
                const auto computed = swayed(*mesh, places, *tree.sway->table, *tree.pose, CProgress());
                EXPECT_LT(largestStep(drawn, computed->positions), allowed) << name << " " << mesh->name;
                EXPECT_GT(largestStep(drawn, mesh->positions), 1e-3 * tree.model->tree->height())
                    << name << ": it sways";
            },
            [&](const std::shared_ptr<const COrganMesh>& organs, int) {
                const SwayPlaces& places = *tree.sway->placesOf(*organs);
                std::vector<glm::vec3> vertices;
                std::vector<glm::vec4> hang;
                std::vector<InstancePlace> instances;
                for (std::size_t i = 0; i < organs->count(); ++i)
                    for (const LeafBlade::Point& point : organs->blade().points) {
                        const Flutter own = flutterOf(tree.sway->table->tree(), organs->leaf(i));
                        vertices.emplace_back(point.place);
                        hang.emplace_back(places[i].node, places[i].part, own.phase, own.hertz);
                        instances.push_back(organs->place(i));
                    }
                const auto drawn = card.places(vertices, hang, instances);
                const auto computed =
                    swayed(*organs, places, *tree.sway->table, *tree.pose, tree.seconds, tree.loop, CProgress());
                EXPECT_LT(largestStep(drawn, computed->positions), allowed) << name << " " << organs->name();
            });
    }
}

/// The share of pixels that differ clearly.
double difference(const Pixels& a, const Pixels& b) {
    std::size_t other = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        int apart = 0;
        for (int c = 0; c < 3; ++c) apart = std::max(apart, std::abs(int(a[i][c]) - int(b[i][c])));
        other += apart > 24;
    }
    return double(other) / double(a.size());
}

Pixels painted(CViewScene& scene) {
    CHeadlessPainter painter(scene, 1);
    CCamera camera;
    camera.lookFrom(20, 5);
    camera.frame(osg::BoundingBoxd(-5, -5, 0, 5, 5, 13), 1);
    return painter.paint(camera, 300, 300);
}

TEST(Sway, PicturesOfASwayingTreeShowIt) {
    const Swaying tree = swaying("quaking_aspen", detailOf(Model::Simple));
    CViewScene still, onCard, posed;
    const std::vector<ViewPart> parts = viewPartsOf(*tree.model, {}, CProgress());
    still.show(parts);
    const Pixels calm = painted(still);
    onCard.show(viewPartsOf(*tree.model, {}, CProgress()));
    onCard.setPose(tree.sway, tree.pose, tree.seconds, tree.loop);
    const Pixels blown = painted(onCard);
    std::vector<ViewPart> moved;
    for (const auto& mesh : swayedMeshes(*tree.sway, *tree.pose, tree.seconds, tree.loop, CProgress()))
        moved.push_back({makeViewGeometry(mesh), mesh->surface, 0, mesh});
    posed.show(moved);
    const Pixels computed = painted(posed);
    EXPECT_GT(difference(calm, blown), 0.05) << "the wind moves it";
    EXPECT_LT(difference(blown, computed), 0.35 * difference(calm, blown)) << "leaves have other shades";
    onCard.endSway();
    EXPECT_EQ(difference(painted(onCard), calm), 0) << "still air is the still tree";
}

TEST(ViewScene, APictureIsTheSameWhetherTheTreeOrItsPainterComesFirst) {
    const Swaying tree = swaying("quaking_aspen", detailOf(Model::Simple));
    const std::vector<ViewPart> parts = viewPartsOf(*tree.model, {}, CProgress());
    CCamera camera;
    camera.frame(osg::BoundingBoxd(-5, -5, 0, 5, 5, 13), 1);
    CViewScene before, after;
    before.show(parts);
    CHeadlessPainter one(before, 4), other(after, 4);
    after.show(viewPartsOf(*tree.model, {}, CProgress()));
    EXPECT_EQ(difference(one.paint(camera, 200, 200), other.paint(camera, 200, 200)), 0);
}

/// Of the ground beside a felled tree, where its crown lies.
TEST(Sway, AFallenTreeThrowsAShadowWhereItLies) {
    const Swaying tree = swaying("quaking_aspen", detailOf(Model::Simple));
    const CFall fall(tree.sway->table, {.direction = 0, .height = 0});
    const auto pose = std::make_shared<WindPose>();
    fall.pose(fall.seconds(), *pose, CProgress());
    CViewScene scene;
    scene.show(viewPartsOf(*tree.model, {}, CProgress()));
    scene.setPose(tree.sway, pose, 0, 0);
    CHeadlessPainter painter(scene, 1);
    CCamera camera;
    camera.lookFrom(0, 60);
    camera.frame(osg::BoundingBoxd(-2, -6, 0, 16, 6, 3), 1);
    const Pixels shaded = painter.paint(camera, 200, 200);
    ViewLook none = scene.look();
    none.leaves = false; // and their shadows
    scene.setLook(none);
    const Pixels bare = painter.paint(camera, 200, 200);
    none.leaves = true;
    scene.setLook(none);
    std::size_t darker = 0;
    const auto ground = [](const auto& pixel) { return std::abs(int(pixel[0]) - int(pixel[1])) < 30; };
    for (std::size_t i = 0; i < bare.size(); ++i)
        darker += ground(bare[i]) && ground(shaded[i]) && bare[i][1] > shaded[i][1] + 25;
    EXPECT_GT(darker, bare.size() / 200);
}

TEST(Sway, ARayMeetsTheTreeWhereItIsSeen) {
    const Swaying tree = swaying("quaking_aspen", detailOf(Model::Simple));
    CViewScene scene;
    scene.show(viewPartsOf(*tree.model, {}, CProgress()));
    const CWindTable& table = *tree.sway->table;
    const CGeneration& trunk = tree.model->tree->generation(0);
    const std::uint32_t node = table.nodeOf(0, trunk.paths[0].segmentCount - 1);
    const glm::vec3 calm = table.still()[node], blown(tree.pose->rows[2 * node]);
    EXPECT_GT(glm::distance(calm, blown), 0.2);
    const auto meets = [&](const glm::vec3& point) {
        const osg::Vec3d from(point.x, point.y - 30, point.z);
        ViewLook look;
        look.leaves = false;
        scene.setLook(look);
        const auto hit = scene.pick(from, {0, 1, 0});
        return hit && hit->generation == 0;
    };
    EXPECT_TRUE(meets(calm));
    EXPECT_FALSE(meets(blown));
    scene.setPose(tree.sway, tree.pose, tree.seconds, tree.loop);
    EXPECT_TRUE(meets(blown));
    EXPECT_FALSE(meets(calm));
    const auto hit = scene.pick({blown.x, blown.y - 30, blown.z}, {0, 1, 0});
    const osg::Vec3d still(calm.x, calm.y, calm.z);
    EXPECT_LT((hit->point - still).length(), 0.1) << "what was hit, where it is in still air";
    scene.endSway();
    EXPECT_TRUE(meets(calm));
}

} // namespace
} // namespace stromar::test
