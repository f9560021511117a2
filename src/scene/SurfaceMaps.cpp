#include "SurfaceMaps.h"
#include "stromar/texture/Opacity.h"
#include "stromar/texture/TextureMaps.h"
#include <cstring>
#include <osg/Image>
#include <osg/Texture2D>
#include <osgDB/ReadFile>

namespace stromar {

namespace {
using ImageRef = osg::ref_ptr<osg::Image>;
constexpr float kPlainRoughness = 0.85f, kLeafThrough = 0.6f;

ImageRef plainImage(const osg::Vec4& colour) {
    ImageRef image = new osg::Image;
    image->allocateImage(1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    image->setColor(colour, 0, 0);
    return image;
}

osg::ref_ptr<osg::Texture2D> makeTexture(osg::Image* image) {
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

ImageRef readMap(const std::string& albedo, const char* suffix) {
    const std::string file = mapBeside(albedo, suffix).string();
    std::error_code problem;
    return std::filesystem::is_regular_file(file, problem) ? osgDB::readRefImageFile(file) : nullptr;
}

Pixels pixelsOf(const osg::Image& image) {
    Pixels pixels(static_cast<std::size_t>(image.s()) * static_cast<std::size_t>(image.t()));
    const bool asIs = image.getPixelFormat() == GL_RGBA && image.getDataType() == GL_UNSIGNED_BYTE;
    for (int y = 0; y < image.t(); ++y) {
        auto* row = pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.s());
        if (asIs) {
            std::memcpy(row, image.data(0, static_cast<unsigned>(y)), static_cast<std::size_t>(image.s()) * 4);
            continue;
        }
        for (int x = 0; x < image.s(); ++x) {
            const osg::Vec4 c = image.getColor(static_cast<unsigned>(x), static_cast<unsigned>(y));
            for (int i = 0; i < 4; ++i)
                row[x][static_cast<std::size_t>(i)] =
                    static_cast<std::uint8_t>(c[static_cast<unsigned>(i)] * 255 + 0.5f);
        }
    }
    return pixels;
}

/// With mip-maps of our own.
ImageRef cutOutImage(const osg::Image& source) {
    Pixels pixels = pixelsOf(source);
    spreadColours(pixels, source.s(), source.t());
    const std::vector<Pixels> levels = mipmapsKeepingCoverage(pixels, source.s(), source.t());
    std::size_t count = 0;
    osg::Image::MipmapDataType offsets;
    for (const Pixels& level : levels) {
        if (count > 0) offsets.push_back(static_cast<unsigned>(count * 4));
        count += level.size();
    }
    auto* data = new unsigned char[count * 4];
    std::size_t at = 0;
    for (const Pixels& level : levels) {
        std::memcpy(data + at, level.data(), level.size() * 4);
        at += level.size() * 4;
    }
    ImageRef image = new osg::Image;
    image->setImage(source.s(), source.t(), 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, data, osg::Image::USE_NEW_DELETE);
    image->setMipmapLevels(offsets);
    return image;
}

/// Red: roughness, green: what goes through.
ImageRef glossImage(const osg::Image* roughness, const osg::Image* through, bool cutOut) {
    if (!roughness) return plainImage({kPlainRoughness, cutOut ? kLeafThrough : 0, 0, 1});
    ImageRef image = new osg::Image;
    image->allocateImage(roughness->s(), roughness->t(), 1, GL_RGB, GL_UNSIGNED_BYTE);
    const bool same = through && through->s() == roughness->s() && through->t() == roughness->t() &&
                      through->getPixelSizeInBits() == roughness->getPixelSizeInBits();
    const auto other = static_cast<unsigned char>(cutOut ? 255 * kLeafThrough : 0);
    const unsigned step = roughness->getPixelSizeInBits() / 8;
    for (unsigned y = 0; y < static_cast<unsigned>(roughness->t()); ++y) {
        unsigned char* pixel = image->data(0, y);
        const unsigned char *rough = roughness->data(0, y), *passes = same ? through->data(0, y) : nullptr;
        for (int x = 0; x < roughness->s(); ++x, pixel += 3, rough += step) {
            pixel[0] = *rough;
            pixel[1] = passes ? passes[static_cast<unsigned>(x) * step] : other;
            pixel[2] = 0;
        }
    }
    return image;
}
} // namespace

std::string showSurface(osg::StateSet* state, const std::string& file, const osg::Vec4& plain, bool cutOut) {
    ImageRef albedo = file.empty() ? nullptr : osgDB::readRefImageFile(file);
    const bool missing = !file.empty() && !albedo;
    const ImageRef relief = albedo ? readMap(file, "_normal") : nullptr;
    const ImageRef roughness = albedo ? readMap(file, "_roughness") : nullptr,
                   through = albedo ? readMap(file, "_translucency") : nullptr,
                   under = albedo && cutOut ? readMap(file, "_back") : nullptr;
    if (!albedo) albedo = plainImage(plain);
    if (cutOut) albedo = cutOutImage(*albedo);
    state->setTextureAttributeAndModes(kAlbedoUnit, makeTexture(albedo));
    state->setTextureAttributeAndModes(kReliefUnit, makeTexture(relief ? relief : plainImage({0.5f, 0.5f, 1, 1})));
    state->setTextureAttributeAndModes(kGlossUnit, makeTexture(glossImage(roughness, through, cutOut)));
    if (under)
        state->setTextureAttributeAndModes(kUnderUnit, makeTexture(under));
    else
        state->removeTextureAttribute(kUnderUnit, osg::StateAttribute::TEXTURE);
    state->getOrCreateUniform("underSide", osg::Uniform::FLOAT)->set(under ? 1.0f : 0.0f);
    state->getOrCreateUniform("reliefDepth", osg::Uniform::FLOAT)->set(relief ? 1.0f : 0.0f);
    return missing ? "cannot show the picture " + file : std::string();
}

} // namespace stromar
