#pragma once
#include <osg/Geometry>
#include <osg/Group>
#include <osg/Program>
#include <osg/Uniform>

namespace stromar {

/// Takes no room, so that it changes neither what is framed nor the depth range.
struct NoBounds : osg::Drawable::ComputeBoundingBoxCallback {
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return {}; }
};

/// Sky and ground, behind everything; they take no room. The program still has to be set.
osg::ref_ptr<osg::Geometry> makeBackground();
osg::ref_ptr<osg::Program> makeBackgroundProgram(const char* looks);

/// An upright picture turned to the eye, behind everything but the background: texture 0, metres in the uniform "size".
osg::ref_ptr<osg::Geometry> makeReference();

/// A person of 1.75 m at `place`, upright and turned to the eye.
osg::ref_ptr<osg::Group> makePerson(osg::Uniform* place);

} // namespace stromar
