#include "Grass.h"
#include "Backdrop.h"
#include "Programs.h"
#include "Shaders.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
constexpr int kTufts = 2600, kBlades = 5;
constexpr double kFarthestTuft = 9;                   // metres
constexpr double kTallEnough = 6;                 // metres: smaller trees stand in smaller grass
constexpr double kShortest = 0.06, kLongest = 0.22, kWide = 0.007; // metres

/// The k-th number of a tuft or blade, 0..1.
double number(std::uint64_t who, std::uint64_t k) { return unitOf(hashCombine(who, k)); }
} // namespace

CGrass::CGrass() : m_node(new osg::Geometry), m_size(new osg::Uniform("grassSize", osg::Vec2(4, 1))) {
    osg::ref_ptr<osg::Vec3Array> feet = new osg::Vec3Array, offsets = new osg::Vec3Array; // in the unit circle; metres
    for (std::uint64_t tuft = 1; tuft <= kTufts; ++tuft) {
        const double out = number(tuft, 0), around = 2 * std::numbers::pi * number(tuft, 1); // density falls as 1/r
        const osg::Vec3 foot(static_cast<float>(out * std::cos(around)), static_cast<float>(out * std::sin(around)),
                             static_cast<float>(number(tuft, 2))); // z: its shade
        for (std::uint64_t blade = 0; blade < kBlades; ++blade) {
            const std::uint64_t own = hashCombine(tuft, 100 + blade);
            const double turn = 2 * std::numbers::pi * number(own, 0), lean = 0.7 * number(own, 1);
            const double tall = (kShortest + (kLongest - kShortest) * number(own, 2)) * (1 - 0.7 * out);
            const osg::Vec3d across(std::cos(turn) * kWide, std::sin(turn) * kWide, 0);
            const osg::Vec3d tip(-std::sin(turn) * lean * tall, std::cos(turn) * lean * tall, tall);
            for (const osg::Vec3d& corner : {-across, across, tip}) {
                feet->push_back(foot);
                offsets->push_back(osg::Vec3(corner));
            }
        }
    }
    m_node->setVertexArray(feet);
    m_node->setTexCoordArray(0, offsets);
    m_node->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(feet->size())));
    m_node->setUseDisplayList(false);
    m_node->setUseVertexBufferObjects(true);
    m_node->setComputeBoundingBoxCallback(new NoBounds);
    m_node->setCullingActive(false);
    osg::StateSet* state = m_node->getOrCreateStateSet();
    state->addUniform(m_size);
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
}

void CGrass::setTree(const osg::BoundingBox& tree) {
    const float reach = std::min({tree.xMax(), -tree.xMin(), tree.yMax(), -tree.yMin()});
    m_size->set(osg::Vec2(std::clamp(reach, 0.f, static_cast<float>(kFarthestTuft)),
                          static_cast<float>(std::clamp(tree.zMax() / kTallEnough, 0.0, 1.0))));
}

void CGrass::setLooks(const char* looks) {
    m_node->getOrCreateStateSet()->setAttributeAndModes(
        makeProgram("grass", kGrassVertexShader, std::string(looks) + kLightFunctions + kGroundFunctions + kGrassFragmentShader));
}

} // namespace stromar
