#pragma once
#include "stromar/mesh/MeshBuilder.h"

namespace stromar {

/// Turns the normals of a tube's rings, as little as it takes, until each lies on the front of the triangles it belongs
/// to: coarse rings on a steep crease and twisted ones need it. False when a fold leaves no such normal.
bool turnNormalsToFront(CMesh& mesh, const MeshPlan& plan, const Tube& tube);

/// The same for a whole mesh, whose seams are not kept closed.
bool turnNormalsToFront(CMesh& mesh);
/// Or for some triangles, by their first indices.
bool turnNormalsToFront(CMesh& mesh, const std::vector<std::size_t>& triangles);

} // namespace stromar
