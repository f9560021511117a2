#pragma once
#include <osg/Vec3>

namespace stromar {

/// Where the sun stands and what colours it gives. Linear light; the brightest sun is about 3.
struct Daylight {
    osg::Vec3 sun;      ///< unit, towards it
    osg::Vec3 sunlight; ///< what it sends; 0 below the horizon
    osg::Vec3 zenith, haze;
    osg::Vec3 ground; ///< light that comes up from it
};

/// `hour` 0..24 of a long summer day with the sun in the south, that is before the front, at noon; `turn` turns its
/// whole way about the tree, degrees.
Daylight daylightAt(double hour, double turn);

} // namespace stromar
