#pragma once
#include "stromar/mesh/Mesh.h"
#include <osg/Geometry>
#include <osg/ref_ptr>

namespace stromar {

/// A copy of the mesh, ready to be drawn, its bounding box computed. Any thread, as long as it is not yet in a scene.
osg::ref_ptr<osg::Geometry> makeGeometry(const CMesh& mesh);

/// The same for the viewport, whose shader also wants to know how open each vertex lies (CMesh::skyVisibility).
osg::ref_ptr<osg::Geometry> makeViewGeometry(const CMesh& mesh);
constexpr unsigned kSkyVisibilityAttribute = 6; ///< of the shader; no driver uses it for anything else

} // namespace stromar
