#pragma once
#include <memory>
#include <osg/Image>
#include <osg/Vec3>
#include <string>

namespace stromar {

/// A picture behind the tree. Immutable.
struct BackdropPicture {
    osg::ref_ptr<osg::Image> image;
    bool panorama = false;          ///< all around, as longitude by latitude, with the light that comes from there (.hdr)
    float scale = 1;                ///< of a panorama: times its values the sky is about as bright as on a clear day
    osg::Vec3 zenith, haze, ground; ///< likewise: the mean light from above, from the horizon and from below; linear
};

/// Reads .png, .jpg or .hdr. Any thread. Throws CError when it cannot be read.
std::shared_ptr<const BackdropPicture> readBackdrop(const std::string& file);

} // namespace stromar
