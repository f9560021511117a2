#pragma once
#include "stem/PointGenerator.h"
#include "stromar/mesh/MeshBuilder.h"

namespace stromar {

/// A place in a mesh to write vertices to.
inline VertexSink sinkAt(CMesh& mesh, std::size_t vertex) {
    return {mesh.positions.data() + vertex, mesh.normals.data() + vertex, mesh.texCoords.data() + vertex,
            mesh.looks.data() + vertex};
}

/// Writes a tube's vertices and triangles to its place in the mesh, whose arrays have the room. False when its collar
/// is so folded that some vertex has no normal on the front of all its triangles.
bool writeTube(const MeshPlan& plan, const Tube& tube, CPointGenerator& points, CMesh& mesh);

/// Sets how many vertices and indices a tube of the plan's rings has.
void measure(const MeshPlan& plan, Tube& tube);

} // namespace stromar
