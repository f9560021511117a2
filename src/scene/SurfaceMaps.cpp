#include "stromar/scene/SurfaceMaps.h"
#include "stromar/texture/Opacity.h"
#include "stromar/texture/PictureSize.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Error.h"
#include <cstring>
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

/// Null, with the problem told, when it cannot be shown.
ImageRef readPicture(const std::string& file, std::string& problem) {
    try {
        refuseHugePicture(file);
    } catch (const CError& e) {
        problem = e.what();
        return nullptr;
    }
    const ImageRef image = osgDB::readRefImageFile(file);
    if (!image) problem = "cannot show the picture " + file;
    return image;
}

/// Null where there is none.
ImageRef readMap(const std::string& albedo, const char* suffix, std::string& problem) {
    const std::string file = mapBeside(albedo, suffix).string();
    std::error_code none;
    return std::filesystem::is_regular_file(file, none) ? readPicture(file, problem) : nullptr;
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

/// With mip-maps of our own. Colours are multiplied by opacity, so that filters weigh them by it; what lies in a gap counts nothing.
ImageRef cutOutImage(const osg::Image& source, const Softening& softening) {
    const Pixels pixels = pixelsOf(source);
    const std::vector<Pixels> levels = mipmapsKeepingCoverage(pixels, source.s(), source.t(), softening);
    std::size_t count = 0;
    osg::Image::MipmapDataType offsets;
    for (const Pixels& level : levels) {
        if (count > 0) offsets.push_back(static_cast<unsigned>(count * 4));
        count += level.size();
    }
    auto* data = new unsigned char[count * 4];
    std::size_t at = 0;
    for (const Pixels& level : levels)
        for (const auto& p : level) {
            for (std::size_t c = 0; c < 3; ++c) data[at++] = static_cast<unsigned char>((p[c] * p[3] + 127) / 255);
            data[at++] = p[3];
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

std::shared_ptr<const SurfaceMaps> readSurface(Surface surface, const std::string& file) {
    const SurfaceInfo& info = surfaceOf(surface);
    auto maps = std::make_shared<SurfaceMaps>();
    ImageRef albedo = file.empty() ? nullptr : readPicture(file, maps->problem);
    const ImageRef relief = albedo ? readMap(file, "_normal", maps->problem) : nullptr;
    const ImageRef roughness = albedo ? readMap(file, "_roughness", maps->problem) : nullptr,
                   through = albedo ? readMap(file, "_translucency", maps->problem) : nullptr;
    maps->under = albedo && info.cutOut ? readMap(file, "_back", maps->problem) : nullptr;
    if (!albedo) albedo = plainImage({info.colour.x, info.colour.y, info.colour.z, 1});
    maps->albedo = info.cutOut ? cutOutImage(*albedo, softeningOf(info.manyLeaves())) : albedo;
    if (maps->under) maps->under = cutOutImage(*maps->under, softeningOf(info.manyLeaves()));
    maps->bumpy = relief.valid();
    maps->relief = relief ? relief : plainImage({0.5f, 0.5f, 1, 1});
    maps->gloss = glossImage(roughness, through, info.cutOut);
    return maps;
}

void showSurface(osg::StateSet& state, const SurfaceMaps& maps) {
    state.setTextureAttributeAndModes(kAlbedoUnit, makeTexture(maps.albedo));
    state.setTextureAttributeAndModes(kReliefUnit, makeTexture(maps.relief));
    state.setTextureAttributeAndModes(kGlossUnit, makeTexture(maps.gloss));
    if (maps.under)
        state.setTextureAttributeAndModes(kUnderUnit, makeTexture(maps.under));
    else
        state.removeTextureAttribute(kUnderUnit, osg::StateAttribute::TEXTURE);
    state.getOrCreateUniform("underSide", osg::Uniform::FLOAT)->set(maps.under ? 1.0f : 0.0f);
    state.getOrCreateUniform("reliefDepth", osg::Uniform::FLOAT)->set(maps.bumpy ? 1.0f : 0.0f);
}

} // namespace stromar
