#include "stromar/scene/OsgGeometry.h"
#include "BorrowedArrays.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <osg/Array>
#include <osg/PrimitiveSet>
#include <osg/VertexAttribDivisor>

namespace stromar {

namespace {
static_assert(sizeof(osg::Vec3) == sizeof(glm::vec3) && sizeof(osg::Vec2) == sizeof(glm::vec2));

template <typename Array, typename Source>
osg::ref_ptr<Array> copied(const Source& values) {
    using Element = typename Array::ElementDataType;
    return new Array(static_cast<unsigned>(values.size()), reinterpret_cast<const Element*>(values.data()));
}

/// The box of all instances: the blade's own says nothing.
class CFixedBox : public osg::Drawable::ComputeBoundingBoxCallback {
public:
    explicit CFixedBox(const Bounds& box)
        : m_box(box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z) {}
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return m_box; }

private:
    osg::BoundingBox m_box;
};

void addBlade(osg::Geometry& geometry, const LeafBlade& blade) {
    const auto count = static_cast<unsigned>(blade.points.size());
    const osg::ref_ptr<osg::Vec3Array> places = new osg::Vec3Array(count), normals = new osg::Vec3Array(count);
    const osg::ref_ptr<osg::Vec2Array> texCoords = new osg::Vec2Array(count);
    for (unsigned i = 0; i < count; ++i) {
        const LeafBlade::Point& point = blade.points[i];
        (*places)[i] = osg::Vec3(osg::Vec3d(point.place.x, point.place.y, point.place.z));
        (*normals)[i] = osg::Vec3(osg::Vec3d(point.normal.x, point.normal.y, point.normal.z));
        (*texCoords)[i] = {point.texCoord.x, point.texCoord.y};
    }
    const osg::ref_ptr<osg::UByteArray> skyVisibility = new osg::UByteArray(count);
    std::ranges::fill(*skyVisibility, 255);
    skyVisibility->setNormalize(true);
    geometry.setVertexArray(places);
    geometry.setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry.setTexCoordArray(0, texCoords, osg::Array::BIND_PER_VERTEX);
    geometry.setVertexAttribArray(kSkyVisibilityAttribute, skyVisibility, osg::Array::BIND_PER_VERTEX);
}

void addPlaces(osg::Geometry& geometry, const COrganMesh& organs, const CProgress& progress) {
    constexpr std::size_t kGrain = 8192;
    const auto count = static_cast<unsigned>(organs.count());
    const osg::ref_ptr<osg::Vec4Array> places = new osg::Vec4Array(count), turns = new osg::Vec4Array(count);
    const osg::ref_ptr<osg::FloatArray> widths = new osg::FloatArray(count);
    parallelFor(
        count, kGrain,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const InstancePlace at = organs.place(i);
                (*places)[i] = {at.position.x, at.position.y, at.position.z, at.length};
                (*turns)[i] = {at.turn.x, at.turn.y, at.turn.z, at.turn.w};
                (*widths)[i] = at.width;
            }
        },
        progress);
    geometry.setVertexAttribArray(kInstancePlaceAttribute, places, osg::Array::BIND_PER_VERTEX);
    geometry.setVertexAttribArray(kInstanceTurnAttribute, turns, osg::Array::BIND_PER_VERTEX);
    geometry.setVertexAttribArray(kInstanceWidthAttribute, widths, osg::Array::BIND_PER_VERTEX);
    osg::StateSet* state = geometry.getOrCreateStateSet();
    for (const unsigned attribute : {kInstancePlaceAttribute, kInstanceTurnAttribute, kInstanceWidthAttribute})
        state->setAttribute(new osg::VertexAttribDivisor(attribute, 1));
}

void addUniforms(osg::StateSet& state, const Rounding& rounding) {
    const glm::vec3 centre(rounding.centre);
    state.addUniform(new osg::Uniform("instanced", 1.0f));
    state.addUniform(new osg::Uniform("roundingCentre", osg::Vec3(centre.x, centre.y, centre.z)));
    state.addUniform(new osg::Uniform("rounding", osg::Vec2(static_cast<float>(rounding.share), static_cast<float>(rounding.minCosine))));
}

osg::ref_ptr<osg::Geometry> emptyGeometry(const std::string& name) {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setName(name);
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    return geometry;
}
} // namespace

osg::ref_ptr<osg::Geometry> makeGeometry(const CMesh& mesh) {
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry(mesh.name);
    geometry->setVertexArray(copied<osg::Vec3Array>(mesh.positions));
    geometry->setNormalArray(copied<osg::Vec3Array>(mesh.normals), osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, copied<osg::Vec2Array>(mesh.texCoords), osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(mesh.indices.size()), mesh.indices.data()));
    geometry->getBound();
    return geometry;
}

osg::ref_ptr<osg::Geometry> makeViewGeometry(const std::shared_ptr<const CMesh>& mesh) {
    using Array = osg::Array;
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry(mesh->name);
    geometry->setVertexArray(new CBorrowedArray(mesh, mesh->positions, Array::Vec3ArrayType, 3, GL_FLOAT));
    geometry->setNormalArray(new CBorrowedArray(mesh, mesh->normals, Array::Vec3ArrayType, 3, GL_FLOAT),
                             Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, new CBorrowedArray(mesh, mesh->texCoords, Array::Vec2ArrayType, 2, GL_FLOAT),
                               Array::BIND_PER_VERTEX);
    const osg::ref_ptr<Array> skyVisibility =
        new CBorrowedArray(mesh, mesh->skyVisibility, Array::UByteArrayType, 1, GL_UNSIGNED_BYTE);
    skyVisibility->setNormalize(true);
    geometry->setVertexAttribArray(kSkyVisibilityAttribute, skyVisibility, Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new CBorrowedTriangles(mesh));
    geometry->getBound();
    return geometry;
}

osg::ref_ptr<osg::Geometry> makeInstancedGeometry(const COrganMesh& organs, const CProgress& progress) {
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry(organs.name());
    addBlade(*geometry, organs.blade());
    addPlaces(*geometry, organs, progress);
    addUniforms(*geometry->getOrCreateStateSet(), organs.rounding());
    const auto& indices = organs.blade().indices;
    geometry->addPrimitiveSet(new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(indices.size()),
                                                        indices.data(), static_cast<int>(organs.count())));
    geometry->setComputeBoundingBoxCallback(new CFixedBox(organs.bounds(progress)));
    geometry->getBound();
    return geometry;
}

} // namespace stromar
