#include "stromar/scene/BackdropPicture.h"
#include "stromar/texture/PictureSize.h"
#include "stromar/util/Error.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>

namespace stromar {

namespace {
constexpr float kSky = 0.5f;      // the brightness of a clear sky
constexpr float kBrightest = 40;  // times the mean: the sun's disc is left to the sun
constexpr double kLevel = 0.26;   // sine of the height up to which it is the horizon
constexpr int kRows = 64, kColumns = 128;

float brightness(const osg::Vec3& light) { return 0.2126f * light.x() + 0.7152f * light.y() + 0.0722f * light.z(); }

osg::Vec3 lightAt(const osg::Image& image, int row, int column) {
    const auto place = [](int i, int of, int size) { return static_cast<unsigned>(std::min(size - 1, (2 * i + 1) * size / (2 * of))); };
    const osg::Vec4 value = image.getColor(place(column, kColumns, image.s()), place(row, kRows, image.t()));
    const osg::Vec3 light(value.x(), value.y(), value.z());
    return std::isfinite(brightness(light)) ? light : osg::Vec3();
}

/// The means over the bands of a panorama, each by the part of the sky that it is.
void measure(BackdropPicture& picture) {
    osg::Vec3d sums[3];
    double sizes[3] = {};
    float mean = 0;
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) mean += brightness(lightAt(*picture.image, row, column)) / (kRows * kColumns);
    for (int row = 0; row < kRows; ++row) {
        const double up = std::sin((double(row) + 0.5 - kRows / 2.0) / kRows * std::numbers::pi), size = std::sqrt(1 - up * up);
        const int band = up < 0 ? 2 : up < kLevel ? 1 : 0;
        for (int column = 0; column < kColumns; ++column) {
            osg::Vec3 light = lightAt(*picture.image, row, column);
            if (const float bright = brightness(light); bright > kBrightest * mean) light *= kBrightest * mean / bright;
            sums[band] += osg::Vec3d(light) * size;
            sizes[band] += size;
        }
    }
    osg::Vec3* const means[] = {&picture.zenith, &picture.haze, &picture.ground};
    for (int band = 0; band < 3; ++band) *means[band] = osg::Vec3(sums[band] / sizes[band]);
    const float sky = (brightness(picture.zenith) + brightness(picture.haze)) / 2;
    picture.scale = sky > 0 ? kSky / sky : 1;
    for (osg::Vec3* light : means) *light *= picture.scale;
}
} // namespace

std::shared_ptr<const BackdropPicture> readBackdrop(const std::string& file) {
    auto picture = std::make_shared<BackdropPicture>();
    const std::string ending = osgDB::getLowerCaseFileExtension(file);
    picture->panorama = ending == "hdr";
    if (ending != "png" && ending != "jpg" && ending != "jpeg" && !picture->panorama)
        throw CError(translated(NC_("stromar", "a backdrop is a picture, .png or .jpg, or a panorama, .hdr: not %1"), file));
    refuseHugePicture(file);
    std::error_code problem;
    if (std::filesystem::is_regular_file(file, problem)) picture->image = osgDB::readRefImageFile(file);
    if (!picture->image || picture->image->s() < 1) throw CError(translated(NC_("stromar", "cannot read the backdrop %1"), file));
    if (picture->panorama) measure(*picture);
    return picture;
}

} // namespace stromar
