#pragma once
#include "stromar/mesh/Mesh.h"
#include <osg/Geometry>
#include <osg/ref_ptr>

namespace stromar {

/// A copy of the mesh, ready to be drawn, its bounding box computed. Any thread, as long as it is not yet in a scene.
osg::ref_ptr<osg::Geometry> makeGeometry(const CMesh& mesh);

} // namespace stromar
