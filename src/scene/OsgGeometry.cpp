#include "stromar/scene/OsgGeometry.h"
#include "BorrowedArrays.h"
#include "InstanceArrays.h"
#include <algorithm>
#include <cmath>
#include <osg/Array>
#include <osg/PrimitiveSet>
#include <osg/VertexAttribDivisor>

namespace stromar {

namespace {
static_assert(sizeof(osg::Vec3) == sizeof(glm::vec3) && sizeof(osg::Vec2) == sizeof(glm::vec2) &&
              sizeof(osg::Vec2ub) == sizeof(VertexLook));

template <typename Array, typename Source>
osg::ref_ptr<Array> copied(const Source& values) {
    using Element = typename Array::ElementDataType;
    return new Array(static_cast<unsigned>(values.size()), reinterpret_cast<const Element*>(values.data()));
}

/// Lets a geometry's instances be found.
struct CInstancesOwner : osg::Referenced {
    explicit CInstancesOwner(std::shared_ptr<CInstances> all) : instances(std::move(all)) {}
    std::shared_ptr<CInstances> instances;
};

CInstances* instancesOf(const osg::Geometry& geometry) {
    const auto* owner = dynamic_cast<const CInstancesOwner*>(geometry.getUserData());
    return owner ? owner->instances.get() : nullptr;
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
    const osg::ref_ptr<osg::Vec2ubArray> looks = new osg::Vec2ubArray(count);
    std::ranges::fill(*looks, osg::Vec2ub(255, 0));
    looks->setNormalize(true);
    geometry.setVertexArray(places);
    geometry.setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry.setTexCoordArray(0, texCoords, osg::Array::BIND_PER_VERTEX);
    geometry.setVertexAttribArray(kLookAttribute, looks, osg::Array::BIND_PER_VERTEX);
}

void addInstances(osg::Geometry& geometry, const std::shared_ptr<CInstances>& instances) {
    using Array = osg::Array;
    using Values = CInstances::Values;
    const auto add = [&](unsigned attribute, Array* values) {
        geometry.setVertexAttribArray(attribute, values, Array::BIND_PER_VERTEX);
        geometry.getOrCreateStateSet()->setAttribute(new osg::VertexAttribDivisor(attribute, 1));
    };
    add(kInstancePlaceAttribute, new CInstanceArray(instances, &Values::places, Array::Vec4ArrayType, 4, GL_FLOAT));
    add(kInstanceTurnAttribute, new CInstanceArray(instances, &Values::turns, Array::Vec4ArrayType, 4, GL_FLOAT));
    add(kInstanceWidthAttribute, new CInstanceArray(instances, &Values::widths, Array::FloatArrayType, 1, GL_FLOAT));
    geometry.setUserData(new CInstancesOwner(instances));
}

void addUniforms(osg::StateSet& state, const Rounding& rounding) {
    const glm::vec3 centre(rounding.centre);
    state.addUniform(new osg::Uniform("instanced", 1.0f));
    state.addUniform(new osg::Uniform("growth", 1.0f));
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
    const osg::ref_ptr<Array> looks = new CBorrowedArray(mesh, mesh->looks, Array::Vec2ubArrayType, 2, GL_UNSIGNED_BYTE);
    looks->setNormalize(true);
    geometry->setVertexAttribArray(kLookAttribute, looks, Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new CBorrowedTriangles(mesh));
    geometry->getBound();
    return geometry;
}

osg::ref_ptr<osg::Geometry> makeInstancedGeometry(const std::shared_ptr<const COrganMesh>& organs,
                                                 const CProgress& progress) {
    osg::ref_ptr<osg::Geometry> geometry = emptyGeometry(organs->name());
    const auto instances = std::make_shared<CInstances>(organs);
    instances->compute(progress);
    addBlade(*geometry, organs->blade());
    addInstances(*geometry, instances);
    addUniforms(*geometry->getOrCreateStateSet(), organs->rounding());
    const auto& indices = organs->blade().indices;
    geometry->addPrimitiveSet(new osg::DrawElementsUInt(GL_TRIANGLES, static_cast<unsigned>(indices.size()),
                                                        indices.data(), static_cast<int>(organs->count())));
    geometry->setComputeBoundingBoxCallback(new CFixedBox(organs->bounds(progress)));
    geometry->getBound();
    return geometry;
}

void setSwayPlaces(osg::Geometry& geometry, const std::shared_ptr<const SwayPlaces>& places) {
    static_assert(sizeof(SwayPlace) == 2 * sizeof(float));
    if (!places) return geometry.setVertexAttribArray(kSwayPlaceAttribute, nullptr);
    geometry.setVertexAttribArray(kSwayPlaceAttribute, new CBorrowedArray(places, *places, osg::Array::Vec2ArrayType, 2, GL_FLOAT),
                                  osg::Array::BIND_PER_VERTEX);
}

void setSwayPlaces(osg::Geometry& geometry, const SwayPlaces& places, const CTree& tree, const COrganMesh& organs) {
    const osg::ref_ptr<osg::Vec4Array> all = new osg::Vec4Array(static_cast<unsigned>(places.size()));
    const CInstances& instances = *instancesOf(geometry);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t source = instances.source(i);
        const Flutter own = flutterOf(tree, organs.leaf(source));
        (*all)[static_cast<unsigned>(i)] = {places[source].node, places[source].part, own.phase, own.hertz};
    }
    geometry.setVertexAttribArray(kSwayPlaceAttribute, all, osg::Array::BIND_PER_VERTEX);
    geometry.getOrCreateStateSet()->setAttribute(new osg::VertexAttribDivisor(kSwayPlaceAttribute, 1));
}

void limitInstances(osg::Geometry& geometry, std::size_t vertices) {
    const CInstances* instances = instancesOf(geometry);
    if (!instances || instances->count() == 0) return;
    const double share = std::min(1.0, double(vertices) / double(instances->vertexCount()));
    const int shown = std::max(1, static_cast<int>(std::ceil(share * double(instances->count()))));
    if (geometry.getPrimitiveSet(0)->getNumInstances() == shown) return;
    geometry.getPrimitiveSet(0)->setNumInstances(shown);
    geometry.getOrCreateStateSet()->getOrCreateUniform("growth", osg::Uniform::FLOAT)->set(static_cast<float>(1 / std::sqrt(share)));
}

void releaseInstances(osg::Geometry& geometry) {
    if (CInstances* instances = instancesOf(geometry)) instances->release();
}

} // namespace stromar
