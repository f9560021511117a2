#pragma once
#include "BorrowedArrays.h"
#include "stromar/mesh/OrganMesh.h"
#include <glm/vec4.hpp>

namespace stromar {

/// Where the instances of a blade stand, as a graphics card reads it. It is there from when it is computed until it is
/// released, and computed anew when it is wanted once more: for another context. The first n are spread over the whole
/// tree, for any n: they can stand for all.
class CInstances {
public:
    explicit CInstances(std::shared_ptr<const COrganMesh> organs);

    void compute(const CProgress& progress);
    void release();
    std::size_t count() const { return m_organs->count(); }
    std::size_t vertexCount() const { return m_organs->vertexCount(); }
    /// Which of the mesh's is the i-th.
    std::size_t source(std::size_t i) const { return static_cast<std::size_t>(std::uint64_t(i) * m_stride % count()); }

    struct Values {
        std::vector<glm::vec4> places;   ///< position and length
        std::vector<glm::vec4> turns;    ///< the quaternion x y z w
        std::vector<float> widths;
    };
    const Values& values();

private:
    std::shared_ptr<const COrganMesh> m_organs;
    std::uint64_t m_stride;
    Values m_values;
};

/// One of the arrays of instances.
template <typename Value>
class CInstanceArray : public CForeignArray {
public:
    using Column = std::vector<Value> CInstances::Values::*;
    CInstanceArray(std::shared_ptr<CInstances> instances, Column column, Type type, int size, GLenum kind)
        : CForeignArray(type, size, kind, instances->count(), sizeof(Value)), m_instances(std::move(instances)),
          m_column(column) {}

private:
    const char* data() const override { return reinterpret_cast<const char*>((m_instances->values().*m_column).data()); }

    std::shared_ptr<CInstances> m_instances;
    Column m_column;
};

} // namespace stromar
