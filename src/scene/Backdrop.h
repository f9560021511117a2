#pragma once
#include <osg/Geometry>
#include <osg/Group>
#include <osg/Uniform>

namespace stromar {

/// Sky and ground, behind everything; they take no room.
osg::ref_ptr<osg::Geometry> makeBackground();

/// A person of 1.75 m at `place`, upright and turned to the eye.
osg::ref_ptr<osg::Group> makePerson(osg::Uniform* place);

} // namespace stromar
