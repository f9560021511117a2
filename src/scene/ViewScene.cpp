#include "stromar/scene/ViewScene.h"
#include "Shaders.h"
#include <algorithm>
#include <osg/Depth>
#include <osg/PolygonMode>
#include <osg/Program>
#include <osgDB/ReadFile>

namespace stromar {

namespace {
osg::ref_ptr<osg::Program> makeProgram(const char* name, const char* vertex, const char* fragment) {
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName(name);
    program->addShader(new osg::Shader(osg::Shader::VERTEX, vertex));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragment));
    return program;
}

/// Takes no room, so that it changes neither what is framed nor the depth range.
struct NoBounds : osg::Drawable::ComputeBoundingBoxCallback {
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return {}; }
};

/// Sky and ground, behind everything.
osg::ref_ptr<osg::Geometry> makeBackground() {
    osg::ref_ptr<osg::Geometry> background = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const osg::Vec3& corner : {osg::Vec3(-1, -1, 0), osg::Vec3(3, -1, 0), osg::Vec3(-1, 3, 0)})
        corners->push_back(corner);
    background->setVertexArray(corners);
    background->setUseDisplayList(false);
    background->setUseVertexBufferObjects(true);
    background->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    background->setCullingActive(false);
    background->setComputeBoundingBoxCallback(new NoBounds);
    osg::StateSet* state = background->getOrCreateStateSet();
    state->setAttributeAndModes(makeProgram("background", kBackgroundVertexShader, kBackgroundFragmentShader));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0, 1, false));
    state->setRenderBinDetails(-10, "RenderBin");
    return background;
}

osg::ref_ptr<osg::Image> plainImage(const osg::Vec4& colour) {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    image->setColor(colour, 0, 0);
    return image;
}

osg::ref_ptr<osg::Texture2D> makeTexture(osg::Image* image) {
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

const osg::Vec4 kPlain[] = {{0.42f, 0.34f, 0.26f, 1}, {0.30f, 0.45f, 0.18f, 1}};
} // namespace

CViewScene::CViewScene()
    : m_root(new osg::Group), m_tree(new osg::Group),
      m_crownMiddle(new osg::Uniform("crownMiddle", osg::Vec3(0, 0, 1))),
      m_crownSize(new osg::Uniform("crownSize", osg::Vec3(1, 1, 1))) {
    m_root->addChild(makeBackground());
    m_root->addChild(m_tree);
    m_root->getOrCreateStateSet()->addUniform(m_crownMiddle);
    m_root->getOrCreateStateSet()->addUniform(m_crownSize);
    osg::StateSet* state = m_tree->getOrCreateStateSet();
    state->setAttributeAndModes(makeProgram("tree", kTreeVertexShader, kTreeFragmentShader));
    state->addUniform(new osg::Uniform("picture", 0));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    for (const Surface surface : {Surface::Bark, Surface::Leaf}) {
        const auto i = static_cast<std::size_t>(surface);
        m_surfaces[i] = new osg::Group;
        m_surfaces[i]->getOrCreateStateSet()->addUniform(
            new osg::Uniform("leaf", surface == Surface::Leaf ? 1.f : 0.f));
        m_tree->addChild(m_surfaces[i]);
        setTexture(surface, {});
    }
    updateLight();
}

void CViewScene::show(const std::vector<ViewPart>& parts) {
    for (auto& surface : m_surfaces) surface->removeChildren(0, surface->getNumChildren());
    for (const ViewPart& part : parts) m_surfaces[static_cast<std::size_t>(part.surface)]->addChild(part.geometry);
    updateLight();
}

std::string CViewScene::setTexture(Surface surface, const std::string& file) {
    const auto i = static_cast<std::size_t>(surface);
    osg::ref_ptr<osg::Image> image = file.empty() ? nullptr : osgDB::readRefImageFile(file);
    const bool missing = !file.empty() && !image;
    if (!image) image = plainImage(kPlain[i]);
    m_surfaces[i]->getOrCreateStateSet()->setTextureAttributeAndModes(0, makeTexture(image));
    return missing ? "cannot show the picture " + file : std::string();
}

void CViewScene::setWireframe(bool on) {
    const auto mode = on ? osg::PolygonMode::LINE : osg::PolygonMode::FILL;
    m_tree->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, mode));
}

osg::BoundingBox CViewScene::bounds() const {
    osg::BoundingBox box;
    for (const auto& surface : m_surfaces)
        for (unsigned i = 0; i < surface->getNumChildren(); ++i)
            box.expandBy(surface->getChild(i)->asGeometry()->getBoundingBox());
    return box;
}

void CViewScene::updateLight() {
    osg::BoundingBox box = bounds();
    if (!box.valid()) box = osg::BoundingBox(-1, -1, 0, 1, 1, 2);
    const osg::Vec3 half = (box._max - box._min) / 2;
    m_crownMiddle->set(box.center());
    m_crownSize->set(osg::Vec3(std::max(half.x(), 0.01f), std::max(half.y(), 0.01f), std::max(half.z(), 0.01f)));
}

} // namespace stromar
