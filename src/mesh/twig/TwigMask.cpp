#include "twig/TwigMask.h"
#include "stromar/util/Rasterise.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace stromar {

namespace {
std::size_t texelAt(const glm::vec2& texCoord, int side) {
    const auto cell = [side](float v) { return static_cast<std::size_t>(std::clamp(static_cast<int>(v * float(side)), 0, side - 1)); };
    return cell(texCoord.y) * static_cast<std::size_t>(side) + cell(texCoord.x);
}
} // namespace

CTwigMask::CTwigMask(const Twig& twig) : m_texels(kSide * kSide) {
    std::vector<float> depths(m_texels.size(), -std::numeric_limits<float>::infinity());
    drawLeaves(twig, depths);
    drawWood(twig, depths);
    drawOutline();
    averageNormals();
}

template <typename Visit> void CTwigMask::draw(const CMesh& mesh, const Twig& twig, Visit&& visit) {
    const auto cell = [&](std::uint32_t corner) { return (glm::dvec2(mesh.positions[corner]) - twig.low) / (twig.high - twig.low) * double(kSide); };
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        const std::uint32_t* c = &mesh.indices[t];
        rasterise(cell(c[0]), cell(c[1]), cell(c[2]), kSide, kSide, [&](int x, int y, double u, double v) {
            const auto mixed = [&](const auto& values) { return float(1 - u - v) * values[c[0]] + float(u) * values[c[1]] + float(v) * values[c[2]]; };
            visit(t, static_cast<std::size_t>(y * kSide + x), mixed);
        });
    }
}

void CTwigMask::drawLeaves(const Twig& twig, std::vector<float>& depths) {
    const CMesh& leaves = *twig.leaves;
    draw(leaves, twig, [&](std::size_t index, std::size_t texel, const auto& mixed) {
        const auto kind = static_cast<std::size_t>(std::ranges::upper_bound(twig.kinds, index) - twig.kinds.begin()) - 1;
        const float depth = mixed(leaves.positions).z;
        if (depth <= depths[texel] || !twig.masks[kind].covers(mixed(leaves.texCoords))) return;
        depths[texel] = depth;
        const glm::vec3 normal = glm::normalize(mixed(leaves.normals));
        m_texels[texel] = {normal.z < 0 ? -normal : normal, normal.z < 0};
    });
}

void CTwigMask::drawWood(const Twig& twig, std::vector<float>& depths) {
    const CMesh& wood = *twig.wood;
    draw(wood, twig, [&](std::size_t, std::size_t texel, const auto& mixed) {
        const float depth = mixed(wood.positions).z;
        if (depth <= depths[texel]) return;
        depths[texel] = depth;
        m_texels[texel] = {glm::normalize(mixed(wood.normals)), false, true};
    });
}

void CTwigMask::drawOutline() {
    std::vector<bool> covered;
    for (const Texel& texel : m_texels) covered.push_back(texel.normal != glm::vec3(0));
    m_cutOut = CCutOut(covered, true);
}

void CTwigMask::averageNormals() {
    for (const Texel& texel : m_texels) m_means[0].push_back(texel.normal);
    for (std::size_t level = 1; level < m_means.size(); ++level) {
        const std::size_t side = kSide >> level;
        const std::vector<glm::vec3>& finer = m_means[level - 1];
        for (std::size_t y = 0; y < side; ++y)
            for (std::size_t x = 0; x < side; ++x) {
                const std::size_t i = 4 * y * side + 2 * x;
                m_means[level].push_back(finer[i] + finer[i + 1] + finer[i + 2 * side] + finer[i + 2 * side + 1]);
            }
    }
}

bool CTwigMask::shows(const glm::vec2& texCoord) const { return m_texels[texelAt(texCoord, kSide)].normal != glm::vec3(0); }

CTwigMask::Texel CTwigMask::at(const glm::vec2& texCoord, int level) const {
    const Texel& own = m_texels[texelAt(texCoord, kSide)];
    if (own.normal == glm::vec3(0)) return own;
    level = std::min(level, kLevels - 1);
    const glm::vec3& mean = m_means[static_cast<std::size_t>(level)][texelAt(texCoord, kSide >> level)];
    return {mean / std::max(1e-6f, glm::length(mean)), own.back, own.wood};
}

} // namespace stromar
