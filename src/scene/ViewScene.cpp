#include "stromar/scene/ViewScene.h"
#include "Shaders.h"
#include "stromar/scene/OsgGeometry.h"
#include <algorithm>
#include <osg/Depth>
#include <osg/PolygonMode>
#include <osg/PolygonOffset>
#include <osg/Program>
#include <osgDB/ReadFile>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/Tessellator>

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

/// The room of what the shader puts at a place: the depth range has to hold it.
struct BoundsAt : osg::Drawable::ComputeBoundingBoxCallback {
    explicit BoundsAt(const osg::Uniform* where) : place(where) {}
    osg::BoundingBox computeBound(const osg::Drawable&) const override {
        osg::Vec3 at;
        place->get(at);
        return {at - osg::Vec3(0.4f, 0.4f, 0), at + osg::Vec3(0.4f, 0.4f, 1.8f)};
    }
    osg::ref_ptr<const osg::Uniform> place;
};

/// A standing person seen from the front, feet at the origin, x and y in metres. Half of the outline, top to bottom.
constexpr float kPerson[][2] = {{0.00f, 1.750f}, {0.05f, 1.735f}, {0.078f, 1.69f}, {0.085f, 1.63f}, {0.07f, 1.56f},
                                {0.05f, 1.525f}, {0.055f, 1.48f}, {0.12f, 1.45f},  {0.19f, 1.42f},  {0.225f, 1.36f},
                                {0.24f, 1.20f},  {0.262f, 1.02f}, {0.285f, 0.84f}, {0.29f, 0.74f},  {0.25f, 0.73f},
                                {0.235f, 0.84f}, {0.21f, 1.02f},  {0.175f, 1.20f}, {0.165f, 1.10f}, {0.17f, 0.95f},
                                {0.18f, 0.85f},  {0.165f, 0.50f}, {0.135f, 0.09f}, {0.16f, 0.02f},  {0.16f, 0.00f},
                                {0.06f, 0.00f},  {0.055f, 0.45f}, {0.02f, 0.78f},  {0.00f, 0.78f}};

/// Faces the eye, upright.
osg::ref_ptr<osg::Group> makePerson(osg::Uniform* place) {
    osg::ref_ptr<osg::Geometry> person = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> outline = new osg::Vec3Array;
    for (const auto& [x, y] : kPerson) outline->push_back(osg::Vec3(x, y, 0));
    for (std::size_t i = std::size(kPerson) - 1; i-- > 1;)
        outline->push_back(osg::Vec3(-kPerson[i][0], kPerson[i][1], 0));
    person->setVertexArray(outline);
    person->addPrimitiveSet(new osg::DrawArrays(GL_POLYGON, 0, static_cast<int>(outline->size())));
    osgUtil::Tessellator().retessellatePolygons(*person);
    person->setUseDisplayList(false);
    person->setUseVertexBufferObjects(true);
    person->setCullingActive(false);
    person->setComputeBoundingBoxCallback(new BoundsAt(place));
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(person);
    osg::StateSet* state = group->getOrCreateStateSet();
    state->setAttributeAndModes(makeProgram("person", kPersonVertexShader, kPlainFragmentShader));
    state->addUniform(place);
    state->addUniform(new osg::Uniform("colour", osg::Vec4(0.24f, 0.26f, 0.29f, 1)));
    return group;
}

const osg::Vec4 kPlain[] = {{0.42f, 0.34f, 0.26f, 1}, {0.30f, 0.45f, 0.18f, 1}};
} // namespace

CViewScene::CViewScene()
    : m_root(new osg::Group), m_tree(new osg::Group), m_wires(new osg::Group),
      m_crownMiddle(new osg::Uniform("crownMiddle", osg::Vec3(0, 0, 1))),
      m_crownSize(new osg::Uniform("crownSize", osg::Vec3(1, 1, 1))), m_backdrop(new osg::Uniform("backdrop", 0)),
      m_grid(new osg::Uniform("grid", 0.f)), m_tint(new osg::Uniform("tinted", float(ViewPart::kNone))),
      m_personPlace(new osg::Uniform("place", osg::Vec3())) {
    m_person = makePerson(m_personPlace);
    m_root->addChild(makeBackground());
    m_root->addChild(m_tree);
    m_root->addChild(m_wires);
    for (osg::Uniform* uniform : {m_crownMiddle.get(), m_crownSize.get(), m_backdrop.get(), m_grid.get(), m_tint.get()})
        m_root->getOrCreateStateSet()->addUniform(uniform);
    osg::StateSet* state = m_tree->getOrCreateStateSet();
    const osg::ref_ptr<osg::Program> program = makeProgram("tree", kTreeVertexShader, kTreeFragmentShader);
    program->addBindAttribLocation("openAt", kOpennessAttribute);
    state->setAttributeAndModes(program);
    state->addUniform(new osg::Uniform("picture", 0));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    osg::StateSet* wires = m_wires->getOrCreateStateSet();
    wires->setAttributeAndModes(makeProgram("wires", kPlainVertexShader, kPlainFragmentShader));
    wires->addUniform(new osg::Uniform("colour", osg::Vec4(0.02f, 0.03f, 0.05f, 0.3f)));
    wires->setMode(GL_BLEND, osg::StateAttribute::ON);
    wires->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    wires->setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE));
    wires->setAttributeAndModes(new osg::PolygonOffset(-1, -1));
    wires->setMode(GL_POLYGON_OFFSET_LINE, osg::StateAttribute::ON);
    for (const Surface surface : {Surface::Bark, Surface::Leaf}) {
        const auto i = static_cast<std::size_t>(surface);
        m_surfaces[i] = new osg::Group;
        m_surfaces[i]->getOrCreateStateSet()->addUniform(
            new osg::Uniform("leaf", surface == Surface::Leaf ? 1.f : 0.f));
        m_tree->addChild(m_surfaces[i]);
        m_wires->addChild(m_surfaces[i]);
        setTexture(surface, {});
    }
    setLook({});
    updateLight();
}

void CViewScene::show(const std::vector<ViewPart>& parts) {
    for (auto& surface : m_surfaces) surface->removeChildren(0, surface->getNumChildren());
    for (const ViewPart& part : parts) {
        osg::StateSet* state = part.geometry->getOrCreateStateSet();
        if (!state->getUniform("generation"))
            state->addUniform(new osg::Uniform("generation", static_cast<float>(part.generation)));
        m_surfaces[static_cast<std::size_t>(part.surface)]->addChild(part.geometry);
    }
    m_parts = parts;
    updateLight();
}

void CViewScene::setLook(const ViewLook& look) {
    m_look = look;
    m_backdrop->set(static_cast<int>(look.backdrop));
    m_grid->set(look.ground ? 1.f : 0.f);
    const auto mode = look.wires == Wires::Only ? osg::PolygonMode::LINE : osg::PolygonMode::FILL;
    m_tree->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, mode));
    const auto show = [](osg::Node& node, bool on) { node.setNodeMask(on ? ~0u : 0u); };
    show(*m_wires, look.wires == Wires::Over);
    show(*m_surfaces[static_cast<std::size_t>(Surface::Leaf)], look.leaves);
    m_root->removeChild(m_person);
    if (look.ground) m_root->addChild(m_person); // only then does it take room
}

void CViewScene::tint(int generation) {
    m_tinted = generation;
    m_tint->set(static_cast<float>(generation));
}

std::optional<ViewHit> CViewScene::pick(const osg::Vec3d& from, const osg::Vec3d& direction) const {
    const double reach = (osg::Vec3d(bounds().center()) - from).length() + bounds().radius() + 1;
    osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
        new osgUtil::LineSegmentIntersector(from, from + direction * reach);
    ray->setIntersectionLimit(osgUtil::Intersector::LIMIT_NEAREST);
    osgUtil::IntersectionVisitor visitor(ray);
    m_tree->accept(visitor);
    if (!ray->containsIntersections()) return {};
    const auto hit = ray->getFirstIntersection();
    const auto part = std::ranges::find_if(m_parts, [&](const ViewPart& p) { return p.geometry == hit.drawable; });
    if (part == m_parts.end()) return {};
    return ViewHit{part->generation, hit.getWorldIntersectPoint()};
}

std::string CViewScene::setTexture(Surface surface, const std::string& file) {
    const auto i = static_cast<std::size_t>(surface);
    osg::ref_ptr<osg::Image> image = file.empty() ? nullptr : osgDB::readRefImageFile(file);
    const bool missing = !file.empty() && !image;
    if (!image) image = plainImage(kPlain[i]);
    m_surfaces[i]->getOrCreateStateSet()->setTextureAttributeAndModes(0, makeTexture(image));
    return missing ? "cannot show the picture " + file : std::string();
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
    m_person->getChild(0)->dirtyBound();
    m_personPlace->set(osg::Vec3(osg::Vec3d(personAt().x(), personAt().y(), 0)));
}

osg::Vec3d CViewScene::personAt() const {
    const osg::BoundingBox box = bounds();
    return {box.valid() ? box.xMin() - 0.6 : -1.5, 0, kPersonHeight};
}

} // namespace stromar
