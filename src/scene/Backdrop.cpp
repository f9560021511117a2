#include "Backdrop.h"
#include "Programs.h"
#include "Shaders.h"
#include <osg/Depth>
#include <osgUtil/Tessellator>

namespace stromar {

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
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0, 1, false));
    state->setRenderBinDetails(-10, "RenderBin");
    return background;
}

osg::ref_ptr<osg::Geometry> makeReference() {
    osg::ref_ptr<osg::Geometry> picture = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const osg::Vec3& corner : {osg::Vec3(-0.5f, 0, 0), osg::Vec3(0.5f, 0, 0), osg::Vec3(-0.5f, 1, 0), osg::Vec3(0.5f, 1, 0)})
        corners->push_back(corner);
    picture->setVertexArray(corners);
    picture->setUseDisplayList(false);
    picture->setUseVertexBufferObjects(true);
    picture->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
    picture->setCullingActive(false);
    picture->setComputeBoundingBoxCallback(new NoBounds);
    osg::StateSet* state = picture->getOrCreateStateSet();
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0, 1, false));
    state->setAttributeAndModes(makeProgram("reference", kReferenceVertexShader, kReferenceFragmentShader));
    state->setRenderBinDetails(-9, "RenderBin");
    return picture;
}

osg::ref_ptr<osg::Program> makeBackgroundProgram(const char* looks) {
    return makeProgram("background", kBackgroundVertexShader,
                       std::string(looks) + kLightFunctions + kGroundFunctions + kBackgroundFragmentShader);
}

namespace {
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

} // namespace

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

} // namespace stromar
