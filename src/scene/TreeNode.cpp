#include "TreeNode.h"
#include "Uniforms.h"
#include "stromar/model/Material.h"
#include "stromar/scene/OsgGeometry.h"
#include "stromar/texture/Opacity.h"
#include <algorithm>
#include <osg/BlendFunc>
#include <osg/Depth>

namespace stromar {

namespace {
#ifndef GL_SAMPLE_ALPHA_TO_COVERAGE
constexpr unsigned GL_SAMPLE_ALPHA_TO_COVERAGE = 0x809E, GL_SAMPLE_ALPHA_TO_ONE = 0x809F;
#endif
constexpr float kLeastCrown = 0.01f; // metres

/// Thin wood lets what is behind it through: leaves and background are drawn before it, thick wood before thin.
void fadeOverOthers(osg::StateSet& state) {
    state.setRenderBinDetails(1, "TraversalOrderBin");
    state.setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA));
}
} // namespace

CTreeNode::CTreeNode() {
    for (const Surface surface : kSurfaces) {
        m_surfaces[static_cast<std::size_t>(surface)] = new osg::Group;
        const Softening softening = softeningOf(surfaceOf(surface).manyLeaves());
        setFloat(&stateOf(surface), "leaf", surfaceOf(surface).cutOut);
        setPair(&stateOf(surface), "softening", softening.from, softening.to);
        if (isBark(surface)) fadeOverOthers(stateOf(surface));
        m_node->addChild(m_surfaces[static_cast<std::size_t>(surface)]);
        setSurface(surface, *readSurface(surface, {}));
    }
    standAt({});
}

void CTreeNode::standAt(const osg::Vec3& place) {
    m_place = place;
    m_node->setMatrix(osg::Matrixd::translate(place));
    setVector(m_node->getOrCreateStateSet(), "standsAt", place);
    updateCrown();
}

void CTreeNode::show(const std::vector<ViewPart>& parts, bool instancing) {
    m_parts = parts;
    m_drawn.clear();
    for (auto& surface : m_surfaces) surface->removeChildren(0, surface->getNumChildren());
    for (const ViewPart& part : m_parts) {
        osg::ref_ptr<osg::Geometry> geometry = part.geometry;
        if (part.organs && !instancing) geometry = makeViewGeometry(part.organs->expanded(CProgress()));
        geometry->setNodeMask(part.organs ? kInstancesMask : ~0u);
        osg::StateSet* state = geometry->getOrCreateStateSet();
        if (!state->getUniform("generation")) setFloat(state, "generation", part.generation);
        setFloat(state, "colourVariation", part.colourVariation);
        setFloat(state, "sunAndShade", part.sunAndShade);
        setFloat(state, "trunkRadius", part.trunkRadius);
        setNeighbours(*state, part.neighbours);
        m_surfaces[static_cast<std::size_t>(part.surface)]->addChild(geometry);
        m_drawn.push_back(geometry);
    }
    shareBarks();
    updateCrown();
}

void CTreeNode::setSurface(Surface surface, const SurfaceMaps& maps) {
    showSurface(stateOf(surface), maps);
    if (isBark(surface)) shareBarks();
}

/// Gives every bark the pictures of those that it gives way to.
void CTreeNode::shareBarks() {
    for (const ViewPart& part : m_parts)
        for (std::size_t i = 0; i < part.neighbours.size(); ++i)
            if (part.neighbours[i].rate != 0) shareSurface(stateOf(part.surface), i, stateOf(part.neighbours[i].surface));
}

void CTreeNode::showLeaves(bool on) {
    for (const Surface surface : kSurfaces)
        m_surfaces[static_cast<std::size_t>(surface)]->setNodeMask(on || isBark(surface) ? ~0u : 0u);
}

void CTreeNode::smoothEdges(bool on) {
    for (const Surface surface : kSurfaces) {
        if (!surfaceOf(surface).cutOut) continue;
        for (const int mode : {GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE})
            stateOf(surface).setMode(static_cast<unsigned>(mode), on ? osg::StateAttribute::ON : osg::StateAttribute::OFF);
    }
}

void CTreeNode::seeThrough(double radius) {
    static const osg::ref_ptr<osg::Depth> hides = new osg::Depth, lets = new osg::Depth(osg::Depth::LESS, 0, 1, false);
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        if (m_parts[i].trunkRadius <= 0) continue;
        const bool thin = m_parts[i].meanRadius < radius;
        osg::StateSet* state = m_drawn[i]->getOrCreateStateSet();
        state->setAttributeAndModes(thin ? lets : hides);
        state->setMode(GL_CULL_FACE, thin ? osg::StateAttribute::ON : osg::StateAttribute::OFF); // their far walls would count as well
    }
}

void CTreeNode::limitInstances(std::size_t vertices) {
    for (auto& drawn : m_drawn) stromar::limitInstances(*drawn, vertices);
}

void CTreeNode::releaseInstances() {
    for (const ViewPart& part : m_parts)
        if (part.organs) stromar::releaseInstances(*part.geometry);
}

osg::BoundingBox CTreeNode::bounds() const {
    osg::BoundingBox box;
    for (const auto& geometry : m_drawn) box.expandBy(geometry->getBoundingBox());
    return box.valid() ? osg::BoundingBox(box._min + m_place, box._max + m_place) : box;
}

/// The room of the leaves' shade, in the tree's own place.
void CTreeNode::updateCrown() {
    osg::BoundingBox box = bounds();
    if (!box.valid()) box = kNoTree;
    setCrown(m_node->getOrCreateStateSet(), osg::BoundingBox(box._min - m_place, box._max - m_place));
}

void setCrown(osg::StateSet* state, const osg::BoundingBox& room) {
    const osg::Vec3 half = (room._max - room._min) / 2;
    setVector(state, "crownMiddle", room.center());
    setVector(state, "crownSize", {std::max(half.x(), kLeastCrown), std::max(half.y(), kLeastCrown), std::max(half.z(), kLeastCrown)});
}

} // namespace stromar
