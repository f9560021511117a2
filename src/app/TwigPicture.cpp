#include "TwigPicture.h"
#include "CardLight.h"
#include "stromar/app/Pictures.h"
#include "stromar/texture/Opacity.h"
#include "stromar/texture/Srgb.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Rasterise.h"
#include "stromar/util/Random.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr int kSize = 512;
constexpr int kSamples = 3;               // of a pixel, each way
constexpr std::uint64_t kTwigVersion = 18; // rises when the same twig is drawn differently
constexpr float kWoodRoughness = 0.85f, kLeafRoughness = 0.6f, kLeafThrough = 0.6f;

/// What one surface shows at a place.
struct Look {
    glm::vec4 front{0, 0, 0, 1}, back{0, 0, 0, 1}; ///< light, and opacity
    glm::vec3 normal{0, 0, 1};
    float roughness = 0, through = 0;
};

/// Of sRGB.
glm::vec4 lightOf(const std::array<std::uint8_t, 4>& c) { return {linearOfByte(c[0]), linearOfByte(c[1]), linearOfByte(c[2]), float(c[3]) / 255}; }
std::uint8_t sRgbOf(float light) { return byteOf(encodedOf(light)); }

/// Of the leaf's picture at a place of it, v up.
class CLeafLook {
public:
    explicit CLeafLook(const fs::path& file) : m_maps(readPngs(file)) {
        spreadColours(m_maps.albedo, m_maps.width, m_maps.height);
    }

    /// The mean of so many pixels each way around a place.
    Look at(const glm::vec2& place, int pixels) const {
        Look sum{.front = glm::vec4(0), .back = glm::vec4(0), .normal = glm::vec3(0)};
        const glm::vec2 corner =
            place * glm::vec2(float(m_maps.width), float(m_maps.height)) - glm::vec2(float(pixels) / 2);
        for (int y = 0; y < pixels; ++y)
            for (int x = 0; x < pixels; ++x) add(corner + glm::vec2(float(x) + 0.5f, float(y) + 0.5f), sum);
        const float share = 1.0f / float(pixels * pixels);
        return {sum.front * share, sum.back * share, sum.normal * share, sum.roughness * share, sum.through * share};
    }

    int height() const { return m_maps.height; }

    /// The mean of what is not cut out.
    MeanLook mean() const {
        MeanLook sum;
        double count = 0;
        const TextureMaps& m = m_maps;
        const auto light = [](const auto& pixel) { return glm::dvec3(lightOf(pixel)); };
        for (std::size_t i = 0; i < m.albedo.size(); ++i) {
            if (lightOf(m.albedo[i]).w < float(kAlphaCut)) continue;
            sum.front += light(m.albedo[i]);
            sum.back += light(m.back.empty() ? m.albedo[i] : m.back[i]);
            sum.through += m.translucency.empty() ? kLeafThrough : float(m.translucency[i]) / 255;
            sum.roughness += m.roughness.empty() ? kLeafRoughness : float(m.roughness[i]) / 255;
            ++count;
        }
        const double share = 1 / std::max(1.0, count);
        return {share * sum.front, share * sum.back, share * sum.roughness, share * sum.through};
    }

private:
    void add(const glm::vec2& pixel, Look& sum) const {
        const int x = std::clamp(static_cast<int>(pixel.x), 0, m_maps.width - 1),
                  y = std::clamp(static_cast<int>(pixel.y), 0, m_maps.height - 1);
        const std::size_t i = m_maps.at(x, m_maps.height - 1 - y);
        sum.front += lightOf(m_maps.albedo[i]);
        sum.back += lightOf(m_maps.back.empty() ? m_maps.albedo[i] : m_maps.back[i]);
        const auto axis = [&](std::size_t c) { return float(m_maps.normal[i][c]) / 127.5f - 1; };
        sum.normal += m_maps.normal.empty() ? glm::vec3(0, 0, 1) : glm::vec3(axis(0), axis(1), axis(2));
        sum.roughness += m_maps.roughness.empty() ? kLeafRoughness : float(m_maps.roughness[i]) / 255;
        sum.through += m_maps.translucency.empty() ? kLeafThrough : float(m_maps.translucency[i]) / 255;
    }

    TextureMaps m_maps;
};

/// What the camera sees at one sample.
struct Sample {
    float z = -INFINITY;
    glm::vec3 albedo, under, normal; ///< `under`: what is behind it
    float roughness, through;
};

/// Draws triangles as a camera before the card sees them.
class CTwigCamera {
public:
    explicit CTwigCamera(const Twig& twig)
        : m_low(twig.low), m_scale(glm::dvec2(kSide) / (twig.high - twig.low)), m_samples(kSide * kSide) {}

    /// Those of some indices. lookAt(texCoord) → Look
    template <typename LookAt>
    void draw(const CMesh& mesh, std::size_t begin, std::size_t end, LookAt&& lookAt) {
        for (std::size_t t = begin; t < end; t += 3) drawTriangle(mesh, &mesh.indices[t], lookAt);
    }

    TextureMaps picture() const;

    /// Samples that a metre along the stem takes.
    double perMetre() const { return m_scale.y; }

private:
    static constexpr std::size_t kSide = kSize * kSamples;

    static std::size_t sampleAt(int x, int y) { return static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x); }

    template <typename LookAt>
    void drawTriangle(const CMesh& mesh, const std::uint32_t* corners, LookAt&& lookAt) {
        glm::dvec2 p[3];
        for (int i = 0; i < 3; ++i) p[i] = (glm::dvec2(mesh.positions[corners[i]]) - m_low) * m_scale;
        const Facing facing = facingOf(mesh, corners);
        rasterise(p[0], p[1], p[2], kSide, kSide, [&](int x, int y, double u, double v) {
            const auto mixed = [&](const auto& values) {
                return float(1 - u - v) * values[corners[0]] + float(u) * values[corners[1]] +
                       float(v) * values[corners[2]];
            };
            Sample& sample = m_samples[sampleAt(x, y)];
            const float z = mixed(mesh.positions).z;
            if (z <= sample.z) return;
            const Look look = lookAt(mixed(mesh.texCoords));
            if (look.front.w < float(kAlphaCut)) return;
            take(sample, z, look, facing, glm::normalize(mixed(mesh.normals)));
        });
    }

    /// How a triangle's picture lies before the camera.
    struct Facing {
        glm::vec3 right, up; ///< of its picture
    };

    static Facing facingOf(const CMesh& mesh, const std::uint32_t* corners) {
        const glm::vec3 e1 = mesh.positions[corners[1]] - mesh.positions[corners[0]],
                        e2 = mesh.positions[corners[2]] - mesh.positions[corners[0]];
        const glm::vec2 d1 = mesh.texCoords[corners[1]] - mesh.texCoords[corners[0]],
                        d2 = mesh.texCoords[corners[2]] - mesh.texCoords[corners[0]];
        const auto unit = [](const glm::vec3& v) { return v / std::max(1e-20f, glm::length(v)); };
        const float turn = d1.x * d2.y - d1.y * d2.x < 0 ? -1.0f : 1.0f;
        return {unit(turn * (d2.y * e1 - d1.y * e2)), unit(turn * (d1.x * e2 - d2.x * e1))};
    }

    static void take(Sample& sample, float z, const Look& look, const Facing& facing, const glm::vec3& surface) {
        const float side = surface.z < 0 ? -1.0f : 1.0f; // −1: its under side is seen
        const glm::vec3 relief = look.normal.x * facing.right + look.normal.y * facing.up + look.normal.z * surface;
        sample.z = z;
        sample.albedo = glm::vec3(side < 0 ? look.back : look.front);
        sample.under = glm::vec3(side < 0 ? look.front : look.back);
        sample.normal = side * relief / std::max(1e-6f, glm::length(relief));
        sample.roughness = look.roughness;
        sample.through = look.through;
    }

    glm::dvec2 m_low, m_scale;
    std::vector<Sample> m_samples; ///< rows from below
};

TextureMaps CTwigCamera::picture() const {
    TextureMaps maps;
    maps.width = maps.height = kSize;
    float farthest = 1e-6f;
    double covered = 0;
    for (const Sample& sample : m_samples)
        if (std::isfinite(sample.z)) farthest = std::max(farthest, std::abs(sample.z));
    for (int y = 0; y < maps.height; ++y)
        for (int x = 0; x < maps.width; ++x) {
            glm::vec3 albedo(0), under(0), normal(0);
            float roughness = 0, through = 0, z = 0, seen = 0;
            for (int i = 0; i < kSamples * kSamples; ++i) {
                const int row = (maps.height - 1 - y) * kSamples + i / kSamples, column = x * kSamples + i % kSamples;
                const Sample& sample =
                    m_samples[sampleAt(column, row)];
                if (!std::isfinite(sample.z)) continue;
                seen += 1;
                albedo += sample.albedo;
                under += sample.under;
                normal += sample.normal;
                roughness += sample.roughness;
                through += sample.through;
                z += sample.z;
            }
            const float each = 1 / std::max(1.0f, seen);
            covered += seen / (kSamples * kSamples);
            const glm::vec3 n = seen > 0 ? glm::normalize(normal + glm::vec3(0, 0, 1e-3f)) : glm::vec3(0, 0, 1);
            maps.albedo.push_back({sRgbOf(albedo.x * each), sRgbOf(albedo.y * each), sRgbOf(albedo.z * each),
                                   byteOf(seen / (kSamples * kSamples))});
            maps.back.push_back({sRgbOf(under.x * each), sRgbOf(under.y * each), sRgbOf(under.z * each), maps.albedo.back()[3]});
            maps.normal.push_back({byteOf(0.5f + 0.5f * n.x), byteOf(0.5f + 0.5f * n.y), byteOf(0.5f + 0.5f * n.z)});
            maps.roughness.push_back(byteOf(seen > 0 ? roughness * each : kLeafRoughness));
            maps.translucency.push_back(byteOf(seen > 0 ? through * each : kLeafThrough));
            maps.height01.push_back(byteOf(0.5f + 0.5f * z * each / farthest));
        }
    spreadMaps(maps);
    setCoverage(maps.albedo, maps.width, maps.height, covered / double(maps.albedo.size()));
    for (std::size_t i = 0; i < maps.albedo.size(); ++i) maps.back[i][3] = maps.albedo[i][3];
    return maps;
}

Look barkLook(const TwigSource& source) {
    const auto& plain = source.plainBark;
    const glm::vec4 light(linearOf(plain.x), linearOf(plain.y), linearOf(plain.z), 1);
    Look look{.front = light, .back = light, .roughness = kWoodRoughness};
    if (!isPng(source.bark)) return look;
    glm::vec4 sum(0);
    const TextureMaps maps = readPngs(source.bark);
    for (const auto& pixel : maps.albedo) sum += lightOf(pixel);
    look.front = look.back = glm::vec4(glm::vec3(sum) / std::max(1.0f, float(maps.albedo.size())), 1);
    return look;
}

template <typename Values>
std::uint64_t hashOf(std::uint64_t hash, const Values& values) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    for (std::size_t i = 0; i < values.size() * sizeof(values[0]); ++i) hash = hashCombine(hash, bytes[i]);
    return hash;
}

/// By when it was written; a recipe's name tells all, and another process may draw the same again.
std::uint64_t hashOfFile(std::uint64_t hash, const fs::path& file) {
    if (file.parent_path() == recipePictures()) return hashOf(hash, file.string());
    std::error_code problem;
    const auto time = fs::last_write_time(file, problem).time_since_epoch().count();
    hash = hashCombine(hash, problem ? 0 : static_cast<std::uint64_t>(time));
    return hashOf(hash, file.string());
}
} // namespace

namespace {
bool showsBlossoms(const CrownLook& crown) {
    const auto isBlossom = [](const LitPlace& place) { return place.layer == CrownLayer::Blossom; };
    return std::ranges::any_of(crown.pixels, [&](const SeenPixel& pixel) { return std::ranges::any_of(pixel, isBlossom); });
}
} // namespace

std::uint64_t twigHash(const Twig& twig, const TwigSource& source, const CProgress& progress) {
    const CardLooks& looks = twig.looks->get(progress);
    std::uint64_t hash = hashCombine(kTwigVersion, kSize);
    for (const auto& mesh : {twig.wood, twig.leaves}) hash = hashOf(hashOf(hash, mesh->positions), mesh->texCoords);
    hash = hashOf(hash, twig.kinds);
    for (const CrownLook* look : {&looks.crown, &looks.cards})
        for (const SeenPixel& pixel : look->pixels)
            for (const LitPlace& p : pixel)
                hash = hashOf(hash, std::array{p.normal.x, p.normal.y, p.normal.z, p.skyVisibility, p.sunVisibility, p.back ? 1.0f : 0.0f, p.behind ? 1.0f : 0.0f, float(p.layer)});
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind)
        if (twig.kinds[kind] < twig.kinds[kind + 1]) hash = hashOfFile(hash, source.leaves[kind]);
    if (showsBlossoms(looks.crown)) hash = hashOfFile(hash, source.blossom);
    return hashOfFile(hashOf(hash, std::array{source.sunAndShade}), source.bark);
}

TextureMaps drawTwig(const Twig& twig, const TwigSource& source, const CProgress& progress) {
    CTwigCamera camera(twig);
    const double samples = std::sqrt(twig.leafArea) * camera.perMetre(); // that a leaf is long
    const Look bark = barkLook(source);
    const glm::dvec3 barkColour(bark.front);
    camera.draw(*twig.wood, 0, twig.wood->indices.size(), [&](const glm::vec2&) { return bark; });
    const CardLooks& looks = twig.looks->get(progress);
    const MeanLook blossom = showsBlossoms(looks.crown) ? CLeafLook(source.blossom).mean() : MeanLook();
    CCardLight light(looks, {barkColour, barkColour, bark.roughness, 0}, blossom, source.sunAndShade);
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind) {
        progress.poll();
        if (twig.kinds[kind] == twig.kinds[kind + 1]) continue;
        const CLeafLook leaf(source.leaves[kind]);
        const int pixels = std::clamp(static_cast<int>(leaf.height() / std::max(1.0, samples)), 1, 8);
        camera.draw(*twig.leaves, twig.kinds[kind], twig.kinds[kind + 1], [&](const glm::vec2& place) { return leaf.at(place, pixels); });
        light.add(leaf.mean(), double(twig.kinds[kind + 1] - twig.kinds[kind]));
    }
    progress.poll();
    TextureMaps picture = camera.picture();
    light.applyTo(picture);
    return picture;
}

} // namespace stromar
