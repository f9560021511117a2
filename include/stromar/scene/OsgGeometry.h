#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/OrganMesh.h"
#include "stromar/mesh/Sway.h"
#include <osg/Geometry>
#include <osg/ref_ptr>

namespace stromar {

/// A copy of the mesh, ready to be drawn, its bounding box computed. Any thread, as long as it is not yet in a scene.
osg::ref_ptr<osg::Geometry> makeGeometry(const CMesh& mesh);

/// The same for the viewport, whose shader also wants to know the look of each vertex (CMesh::looks). It
/// borrows the vertices of the mesh, and holds it.
osg::ref_ptr<osg::Geometry> makeViewGeometry(const std::shared_ptr<const CMesh>& mesh);
constexpr unsigned kLookAttribute = 6; ///< of the shader; no driver uses it for anything else

/// Instances of one blade, for a shader that puts them in their places: OpenGL 3.3. Its uniforms say that there are
/// instances and how they are rounded.
osg::ref_ptr<osg::Geometry> makeInstancedGeometry(const std::shared_ptr<const COrganMesh>& organs,
                                                 const CProgress& progress);
/// Draws instances of at most so many vertices, one at least, evenly out of all and enlarged to keep their area: stochastic
/// simplification (Cook et al. 2007). Nothing for other geometry. Only the thread that draws.
void limitInstances(osg::Geometry& geometry, std::size_t vertices);
/// Frees what the graphics card has a copy of. Another context has it computed anew. Only the thread that draws.
void releaseInstances(osg::Geometry& geometry);
/// Attributes of an instance: position and length; quaternion; width.
constexpr unsigned kInstancePlaceAttribute = 7, kInstanceTurnAttribute = 9, kInstanceWidthAttribute = 10;

/// Tells the shader where each vertex, or each instance, hangs on the axes of the tree; it borrows the places of the mesh. Null: nowhere.
void setSwayPlaces(osg::Geometry& geometry, const std::shared_ptr<const SwayPlaces>& places);
void setSwayPlaces(osg::Geometry& geometry, const SwayPlaces& places, const CTree& tree, const COrganMesh& organs);
constexpr unsigned kSwayPlaceAttribute = 11;

} // namespace stromar
