#include "stromar/scene/OsgGeometry.h"
#include <osg/Array>
#include <osg/PrimitiveSet>

namespace stromar {

namespace {
static_assert(sizeof(osg::Vec3) == sizeof(glm::vec3) && sizeof(osg::Vec2) == sizeof(glm::vec2));

template <typename Array, typename Source>
osg::ref_ptr<Array> copied(const Source& values) {
    using Element = typename Array::ElementDataType;
    return new Array(static_cast<unsigned>(values.size()), reinterpret_cast<const Element*>(values.data()));
}
} // namespace

osg::ref_ptr<osg::Geometry> makeGeometry(const CMesh& mesh) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setName(mesh.name);
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(copied<osg::Vec3Array>(mesh.positions));
    geometry->setNormalArray(copied<osg::Vec3Array>(mesh.normals), osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, copied<osg::Vec2Array>(mesh.texCoords), osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(mesh.indices.size()), mesh.indices.data()));
    geometry->getBound();
    return geometry;
}

osg::ref_ptr<osg::Geometry> makeViewGeometry(const CMesh& mesh) {
    osg::ref_ptr<osg::Geometry> geometry = makeGeometry(mesh);
    const osg::ref_ptr<osg::UByteArray> skyVisibility =
        new osg::UByteArray(mesh.skyVisibility.data(), mesh.skyVisibility.data() + mesh.skyVisibility.size());
    skyVisibility->setNormalize(true);
    geometry->setVertexAttribArray(kSkyVisibilityAttribute, skyVisibility, osg::Array::BIND_PER_VERTEX);
    return geometry;
}

} // namespace stromar
