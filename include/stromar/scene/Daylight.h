#pragma once
#include "stromar/model/Light.h"
#include <osg/Vec3>

namespace stromar {

/// Where the sun stands and what colours it gives. Linear light; the brightest sun is about 3.
struct Daylight {
    osg::Vec3 sun;      ///< unit, towards it
    osg::Vec3 sunlight; ///< what it sends; 0 below the horizon
    osg::Vec3 zenith, haze;
    osg::Vec3 ground; ///< light that comes up from it
};

/// Of a long summer day with the sun in the south, that is before the front, at noon. Exposure is left to who shows it.
Daylight daylightAt(const Light& light);

} // namespace stromar
