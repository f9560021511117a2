#include "ShadowMap.h"
#include "Programs.h"
#include "Shaders.h"
#include <algorithm>
#include <cmath>
#include <osg/CullFace>
#include <osg/Depth>

namespace stromar {

namespace {
constexpr double kOffset = 1.5;  // texels that a surface is lifted towards the sun, against shadows of itself
constexpr double kThinnest = 0.6; // texels, a radius
constexpr double kLowSun = 0.12; // sine: lower suns would throw shadows without end
} // namespace

CShadowMap::CShadowMap(osg::Group* casters)
    : m_camera(new osg::Camera), m_depth(new osg::Texture2D), m_texel(new osg::Uniform("shadowTexel", 0.f)),
      m_matrix(new osg::Uniform("shadowMatrix", osg::Matrixf())), m_offset(new osg::Uniform("shadowOffset", 0.f)),
      m_thinnest(new osg::Uniform("thinnestWood", 0.f)) {
    m_depth->setInternalFormat(GL_DEPTH_COMPONENT24);
    m_depth->setSourceFormat(GL_DEPTH_COMPONENT);
    m_depth->setSourceType(GL_UNSIGNED_INT);
    m_depth->setShadowComparison(true);
    m_depth->setShadowCompareFunc(osg::Texture::LEQUAL);
    m_depth->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    m_depth->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    m_depth->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_BORDER);
    m_depth->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_BORDER);
    m_depth->setBorderColor(osg::Vec4d(1, 1, 1, 1));
    m_camera->setRenderOrder(osg::Camera::PRE_RENDER);
    m_camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    m_camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    m_camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    m_camera->setCullingMode(osg::CullSettings::NO_CULLING);
    m_camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    m_camera->setDrawBuffer(GL_NONE);
    m_camera->setReadBuffer(GL_NONE);
    m_camera->attach(osg::Camera::DEPTH_BUFFER, m_depth);
    m_camera->addChild(casters);
    osg::StateSet* state = m_camera->getOrCreateStateSet();
    constexpr auto kStrong = osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE;
    state->setAttributeAndModes(makeTreeProgram("shadow", kShadowVertexShader, std::string(kFastLooks) + kCutOutFunctions + kShadowFragmentShader), kStrong);
    state->addUniform(m_thinnest);
    state->setAttributeAndModes(new osg::Depth, kStrong); // thin stems may hide nothing in the picture
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
    resize();
}

void CShadowMap::addTo(osg::StateSet* state, unsigned unit) const {
    state->setTextureAttributeAndModes(unit, m_depth);
    state->addUniform(new osg::Uniform("shadows", static_cast<int>(unit)));
    for (osg::Uniform* uniform : {m_texel.get(), m_matrix.get(), m_offset.get()}) state->addUniform(uniform);
}

void CShadowMap::resize() {
    m_texel->set(m_size > 0 ? 1.0f / static_cast<float>(m_size) : 0.f);
    const int side = std::max(1, m_size);
    m_depth->setTextureSize(side, side);
    m_depth->dirtyTextureObject();
    m_camera->setViewport(0, 0, side, side);
    m_camera->dirtyAttachmentMap();
    lift();
}

void CShadowMap::lift() {
    const double texel = 2 * m_aimed.radius() / std::max(1, m_size);
    m_offset->set(static_cast<float>(kOffset * texel));
    m_thinnest->set(static_cast<float>(m_lines ? kThinnest * texel : 0));
}

bool CShadowMap::covers(const osg::BoundingBox& box) const {
    for (unsigned corner = 0; corner < 8; ++corner)
        if (!m_aimed.contains(osg::Vec3d(box.corner(corner)))) return false;
    return true;
}

void CShadowMap::setSize(int size) {
    if (size == m_size) return;
    m_size = size;
    resize();
    setStale();
}

void CShadowMap::aim(const osg::BoundingBox& box, const osg::Vec3& sun) {
    m_box = box;
    osg::Vec3d towards(sun);
    towards.z() = std::max(towards.z(), kLowSun);
    towards.normalize();
    const osg::Vec3d centre(box.center());
    const double radius = std::max(1e-3, double(box.radius()));
    m_aimed.set(centre, radius * (1 + 1e-6)); // its own corners are in it
    const osg::Vec3d up = std::abs(towards.z()) > 0.99 ? osg::Vec3d(0, 1, 0) : osg::Vec3d(0, 0, 1);
    const osg::Matrixd view = osg::Matrixd::lookAt(centre + towards * (2 * radius), centre, up);
    const osg::Matrixd projection = osg::Matrixd::ortho(-radius, radius, -radius, radius, 0.5 * radius, 6 * radius);
    m_camera->setViewMatrix(view);
    m_camera->setProjectionMatrix(projection);
    m_matrix->set(
        osg::Matrixf(view * projection * osg::Matrixd::translate(1, 1, 1) * osg::Matrixd::scale(0.5, 0.5, 0.5)));
    lift();
    setStale();
}

void CShadowMap::setLines(bool on) {
    if (on == m_lines) return;
    m_lines = on;
    lift();
    setStale();
}

void CShadowMap::setStale() { m_camera->setNodeMask(m_size > 0 ? ~0u : 0u); }
void CShadowMap::setDrawn() { m_camera->setNodeMask(0); }

} // namespace stromar
