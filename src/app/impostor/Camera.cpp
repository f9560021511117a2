#include "VertexColours.h"
#include "stromar/app/Impostor.h"
#include "stromar/app/Pictures.h"
#include "stromar/model/Material.h"
#include "stromar/texture/Srgb.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Error.h"
#include "stromar/util/Random.h"
#include "stromar/util/Rasterise.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <limits>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr int kSamples = 3; // of a pixel, each way

/// Halves until nothing is left, of colours alone.
std::vector<Pixels> mipmapsOf(const TextureMaps& maps, bool cutOut, const Softening& softening) {
    Pixels pixels = maps.albedo;
    if (cutOut) {
        spreadColours(pixels, maps.width, maps.height);
    } else {
        for (auto& pixel : pixels) pixel[3] = 255;
    }
    return mipmapsKeepingCoverage(pixels, maps.width, maps.height, softening);
}
} // namespace

/// A surface's picture and its halves.
class CImpostorCamera::CTexture {
public:
    CTexture(const fs::path& file, const SurfaceInfo& surface) : m_cutOut(surface.cutOut), m_softening(softeningOf(surface.manyLeaves())) {
        if (!isPng(file))
            throw CError(translated(NC_("stromar", "an impostor can be made of PNG textures only, not of %1"), file.string()));
        const TextureMaps maps = readPng(file);
        m_size = {maps.width, maps.height};
        m_levels = mipmapsOf(maps, m_cutOut, m_softening);
    }

    struct Texel {
        glm::vec3 colour; ///< linear
        float cover;      ///< 0..1
    };
    /// `level`: how often the picture is halved.
    Texel at(const glm::vec2& texCoord, int level) const {
        const glm::ivec2 size(std::max(1, m_size.x >> level), std::max(1, m_size.y >> level));
        const auto cell = [](float v, int count) { return std::clamp(static_cast<int>((v - std::floor(v)) * float(count)), 0, count - 1); };
        const auto& pixel = m_levels[static_cast<std::size_t>(level)][static_cast<std::size_t>((size.y - 1 - cell(texCoord.y, size.y)) * size.x + cell(texCoord.x, size.x))];
        const auto channel = [&](std::size_t c) { return linearOf(float(pixel[c]) / 255); };
        return {{channel(0), channel(1), channel(2)}, m_cutOut ? float(coverOf(pixel[3] / 255.0, kAlphaCut, m_softening.at(1.0 / std::min(size.x, size.y)))) : 1.0f};
    }
    /// For a part of the picture, in its own units, that takes so many samples.
    int levelFor(double part, double samples) const {
        const double texels = part * m_size.x * m_size.y;
        return std::clamp(static_cast<int>(std::lround(0.5 * std::log2(std::max(1e-9, texels) / std::max(1e-9, samples)))), 0, static_cast<int>(m_levels.size()) - 1);
    }
    bool isCutOut() const { return m_cutOut; }

private:
    bool m_cutOut;
    Softening m_softening;
    glm::ivec2 m_size;
    std::vector<Pixels> m_levels;
};

struct CImpostorCamera::Part {
    std::shared_ptr<const CMesh> mesh;
    const CTexture* texture;
    std::string tints; ///< of vertices, four bytes each; or empty

    glm::vec3 tint(std::size_t vertex) const {
        if (tints.empty()) return glm::vec3(1);
        const auto channel = [&](std::size_t c) { return float(static_cast<std::uint8_t>(tints[4 * vertex + c])) / 255; };
        return {channel(0), channel(1), channel(2)};
    }
};

namespace {
struct Sample {
    float depth = -std::numeric_limits<float>::infinity(); ///< metres towards the viewer
    glm::vec3 colour;                                      ///< linear
    glm::vec3 normal;
};

double twiceArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// 0..1, evenly spread, for parts of a leaf's edge that cover a sample in part.
float thresholdOf(int x, int y, std::size_t triangle) {
    const std::uint64_t hash = hashCombine(hashCombine(static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(y)), triangle);
    return (float(hash >> 40) + 0.5f) / float(1 << 24);
}

/// The samples of one frame, rows from below.
class CImpostorCanvas {
public:
    CImpostorCanvas(const ImpostorFrame& frame, int width, int height)
        : m_frame(frame), m_size(width * kSamples, height * kSamples), m_samples(static_cast<std::size_t>(m_size.x) * static_cast<std::size_t>(m_size.y)),
          m_toView(glm::transpose(glm::dmat3(frame.view.right, frame.view.up, frame.view.towards))), m_perMetre(glm::dvec2(m_size) / (2.0 * frame.half)) {}

    template <typename Part>
    void draw(const Part& part, std::size_t first, std::size_t last) {
        for (std::size_t t = first; t < last; t += 3) drawTriangle(part, t);
    }

    ImpostorPicture picture() const;

private:
    glm::dvec3 seen(const glm::vec3& position) const {
        const glm::dvec3 p = m_toView * (glm::dvec3(position) - m_frame.centre);
        return {glm::dvec2(p) * m_perMetre + glm::dvec2(m_size) / 2.0, p.z};
    }

    template <typename Part>
    void drawTriangle(const Part& part, std::size_t triangle) {
        const CMesh& mesh = *part.mesh;
        const std::uint32_t* corners = &mesh.indices[triangle];
        const glm::dvec3 a = seen(mesh.positions[corners[0]]), b = seen(mesh.positions[corners[1]]), c = seen(mesh.positions[corners[2]]);
        const double twice = twiceArea(a, b, c);
        if (twice < 0 && !part.texture->isCutOut()) return; // the inside of wood
        const glm::vec2 *t = mesh.texCoords.data(), ta = t[corners[0]], tb = t[corners[1]], tc = t[corners[2]];
        const int level = part.texture->levelFor(std::abs(twiceArea(ta, tb, tc)), std::abs(twice));
        const glm::vec3 tint = part.tint(corners[0]);
        rasterise(a, b, c, m_size.x, m_size.y, [&](int x, int y, double u, double v) {
            const auto mixed = [&](const auto& p, const auto& q, const auto& r) { return float(1 - u - v) * p + float(u) * q + float(v) * r; };
            Sample& sample = m_samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.x) + static_cast<std::size_t>(x)];
            const float depth = mixed(float(a.z), float(b.z), float(c.z));
            if (depth <= sample.depth) return;
            const auto texel = part.texture->at(mixed(ta, tb, tc), level);
            if (texel.cover < 1 && texel.cover <= thresholdOf(x, y, triangle)) return;
            const auto* n = mesh.normals.data();
            sample = {depth, tint * texel.colour, (twice < 0 ? -1.0f : 1.0f) * glm::normalize(mixed(n[corners[0]], n[corners[1]], n[corners[2]]) + 1e-9f)};
        });
    }

    struct Mean {
        float weight = 0, depth = 0; ///< the weight of those that are covered; of all it is 1
        glm::vec3 colour{0}, normal{0};
    };
    /// Of a pixel's samples and, less, those around: opacities between a few steps, so that any coverage can be set.
    Mean meanAt(int pixelX, int pixelY) const {
        constexpr int kReach = kSamples - 1;
        Mean mean;
        for (int j = -kReach; j <= kReach; ++j)
            for (int i = -kReach; i <= kReach; ++i) {
                const int x = pixelX * kSamples + kSamples / 2 + i, y = pixelY * kSamples + kSamples / 2 + j;
                if (x < 0 || y < 0 || x >= m_size.x || y >= m_size.y) continue;
                const Sample& sample = m_samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.x) + static_cast<std::size_t>(x)];
                if (!std::isfinite(sample.depth)) continue;
                const float weight = float((kSamples - std::abs(i)) * (kSamples - std::abs(j))) / (kSamples * kSamples * kSamples * kSamples);
                mean.weight += weight;
                mean.colour += weight * sample.colour;
                mean.normal += weight * sample.normal;
                mean.depth += weight * sample.depth;
            }
        return mean;
    }

    ImpostorFrame m_frame;
    glm::ivec2 m_size;
    std::vector<Sample> m_samples;
    glm::dmat3 m_toView;
    glm::dvec2 m_perMetre;
};

std::array<std::uint8_t, 4> withAlpha(const glm::vec3& v, std::uint8_t alpha) { return {byteOf(v.x), byteOf(v.y), byteOf(v.z), alpha}; }

ImpostorPicture CImpostorCanvas::picture() const {
    ImpostorPicture picture{m_size.x / kSamples, m_size.y / kSamples, {}, {}};
    Pixels depths;
    for (int y = picture.height - 1; y >= 0; --y)
        for (int x = 0; x < picture.width; ++x) {
            const Mean mean = meanAt(x, y);
            const float each = 1 / std::max(1e-6f, mean.weight);
            const std::uint8_t cover = byteOf(mean.weight);
            const glm::vec3 colour = each * mean.colour;
            picture.albedo.push_back(withAlpha({encodedOf(colour.x), encodedOf(colour.y), encodedOf(colour.z)}, cover));
            picture.normalDepth.push_back(withAlpha(0.5f + 0.5f * each * mean.normal, cover));
            depths.push_back(withAlpha(glm::vec3(0.5f + 0.5f * mean.depth * each / float(m_frame.depth)), cover));
        }
    for (Pixels* pixels : {&picture.albedo, &picture.normalDepth, &depths}) spreadColours(*pixels, picture.width, picture.height);
    const auto covered = std::ranges::count_if(m_samples, [](const Sample& sample) { return std::isfinite(sample.depth); });
    setCoverage(picture.albedo, picture.width, picture.height, double(covered) / double(m_samples.size()));
    for (std::size_t i = 0; i < depths.size(); ++i) picture.normalDepth[i][3] = depths[i][0];
    return picture;
}

/// COLOR_0 of each mesh, as files have it without the sky's light.
std::vector<std::string> tintsOf(const TreeModel& model, const Meshes& meshes) {
    ExportModel tinted{{}, meshes, {}, {}};
    ExportOptions options;
    options.occlusion = static_cast<int>(ExportedOcclusion::None);
    const auto shared = std::shared_ptr<const TreeModel>(std::shared_ptr<void>(), &model);
    addColours(tinted, std::span(&shared, 1), options);
    std::vector<std::string> tints;
    for (VertexChannels& channels : tinted.channels) tints.push_back(channels.empty() ? std::string() : std::move(channels.front().bytes));
    return tints;
}
} // namespace

CImpostorCamera::CImpostorCamera(const TreeModel& model, const Meshes& meshes, const fs::path& treeFolder, const CProgress& progress) : m_progress(progress) {
    std::array<std::shared_ptr<const CTexture>, kSurfaces.size()> textures;
    std::vector<std::string> tints = tintsOf(model, meshes);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Surface surface = shownSurface(model.params, meshes[i]->surface);
        std::shared_ptr<const CTexture>& texture = textures[static_cast<std::size_t>(surface)];
        progress.poll();
        if (!texture) m_textures.push_back(texture = std::make_shared<CTexture>(textureOf(model, surface, treeFolder, progress), surfaceOf(surface)));
        m_parts.push_back({meshes[i], texture.get(), std::move(tints[i])});
    }
}
CImpostorCamera::~CImpostorCamera() = default;
CImpostorCamera::CImpostorCamera(CImpostorCamera&&) noexcept = default;

void CImpostorCamera::poll() const { m_progress.poll(); }

Bounds CImpostorCamera::bounds() const {
    Bounds all = m_parts.front().mesh->bounds();
    for (const Part& part : m_parts) {
        const Bounds own = part.mesh->bounds();
        all = {glm::min(all.min, own.min), glm::max(all.max, own.max)};
    }
    return all;
}

CImpostorCamera::Ball CImpostorCamera::ball() const {
    constexpr int kSteps = 50;
    Ball ball{(glm::dvec3(bounds().min) + glm::dvec3(bounds().max)) / 2.0, 0};
    glm::dvec3 farthest = ball.centre;
    const auto findFarthest = [&] {
        ball.radius = 0;
        for (const Part& part : m_parts)
            for (const glm::vec3& p : part.mesh->positions)
                if (const double distance = glm::distance(glm::dvec3(p), ball.centre); distance > ball.radius) ball.radius = distance, farthest = p;
    };
    findFarthest();
    for (int i = 2; i < kSteps; ++i) { // ever smaller steps towards it: Bădoiu & Clarkson 2003
        ball.centre += (farthest - ball.centre) / double(i);
        m_progress.poll();
        findFarthest();
    }
    return ball;
}

ImpostorPicture CImpostorCamera::draw(const ImpostorFrame& frame, int width, int height) const {
    constexpr std::size_t kBetweenPolls = 30'000;
    CImpostorCanvas canvas(frame, width, height);
    for (const Part& part : m_parts)
        for (std::size_t first = 0; first < part.mesh->indices.size(); first += kBetweenPolls) {
            m_progress.poll();
            canvas.draw(part, first, std::min(first + kBetweenPolls, part.mesh->indices.size()));
        }
    return canvas.picture();
}

} // namespace stromar
