#include "SwayTables.h"
#include <algorithm>
#include <cassert>
#include <cstring>
#include <osg/Image>

namespace stromar {

namespace {
constexpr int kNodesOfLine = 1024;
#ifndef GL_RGBA32F_ARB
constexpr int GL_RGBA32F_ARB = 0x8814;
#endif

void setUp(osg::Texture2D& texture) {
    texture.setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture.setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture.setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture.setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture.setResizeNonPowerOfTwoHint(false);
    texture.setUseHardwareMipMapGeneration(false);
    texture.setInternalFormat(GL_RGBA32F_ARB);
}

/// The picture of a texture, of this size at least; new only where it has to grow.
osg::Image& pictureOf(osg::Texture2D& texture, int width, int lines) {
    osg::Image* picture = texture.getImage();
    if (picture && picture->s() == width && picture->t() >= lines) return *picture;
    osg::ref_ptr<osg::Image> grown = new osg::Image;
    grown->allocateImage(width, lines, 1, GL_RGBA, GL_FLOAT);
    grown->setInternalTextureFormat(GL_RGBA32F_ARB);
    texture.setImage(grown);
    texture.dirtyTextureObject();
    return *grown;
}

int linesFor(std::size_t nodes) { return static_cast<int>((nodes + kNodesOfLine - 1) / kNodesOfLine); }
} // namespace

void CSwayTables::addTo(osg::StateSet* state, unsigned rowsUnit, unsigned stillUnit) {
    for (const auto& [texture, unit, name] :
         {std::tuple{m_rows, rowsUnit, "swayRows"}, std::tuple{m_still, stillUnit, "swayStill"}}) {
        setUp(*texture);
        state->setTextureAttribute(unit, texture);
        state->addUniform(new osg::Uniform(name, static_cast<int>(unit)));
    }
    setStill({});
    for (osg::Uniform* uniform : {m_on.get(), m_time.get(), m_size.get()}) state->addUniform(uniform);
}

void CSwayTables::setStill(const std::vector<glm::vec3>& nodes) {
    m_count = nodes.size();
    const int lines = std::max(1, linesFor(m_count));
    osg::Image& still = pictureOf(*m_still, kNodesOfLine, lines);
    pictureOf(*m_rows, 2 * kNodesOfLine, still.t());
    auto* texel = reinterpret_cast<glm::vec4*>(still.data());
    for (const glm::vec3& node : nodes) *texel++ = glm::vec4(node, 0);
    still.dirty();
    m_size->set(osg::Vec2(static_cast<float>(kNodesOfLine), static_cast<float>(still.t())));
}

void CSwayTables::setPose(const WindPose& pose, double seconds, double loop) {
    assert(pose.rows.size() == 2 * m_count);
    osg::Image& rows = *m_rows->getImage();
    std::memcpy(rows.data(), pose.rows.data(), pose.rows.size() * sizeof(glm::vec4));
    rows.dirty();
    m_time->set(osg::Vec2(static_cast<float>(seconds), static_cast<float>(loop)));
    m_on->set(1.f);
}

void CSwayTables::setOff() { m_on->set(0.f); }

} // namespace stromar
