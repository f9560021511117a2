#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/twig/Twig.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <vector>

namespace stromar {

/// What the card of a twig shows at a place: its leaves from the front, as a picture of them does.
class CTwigMask {
public:
    explicit CTwigMask(const Twig& twig);

    static constexpr int kSide = 128;

    struct Texel {
        glm::vec3 normal{0}; ///< right, along, to the viewer; nothing: there is a gap
        bool back = false;   ///< of a leaf
    };
    /// Normals are the mean over 2^level texels each way, as in smaller pictures.
    Texel at(const glm::vec2& texCoord, int level) const;
    /// Whether there is a leaf.
    bool covers(const glm::vec2& texCoord) const;

private:
    static constexpr int kLevels = 8;
    std::vector<Texel> m_texels;
    std::vector<bool> m_covered;
    std::array<std::vector<glm::vec3>, kLevels> m_means; ///< of normals, by level
};

/// Where the crown is that is measured.
struct CrownFrame {
    glm::dvec3 middle{0};
    double radius = 0; ///< of a ball around it
};

/// Triangles that are measured: leaves of a kind, or cards of twigs.
struct CrownPart {
    std::shared_ptr<const CMesh> mesh;
    const CLeafMask* leaf = nullptr;
    const CTwigMask* twig = nullptr;
};

/// The share of pictures from eight sides that is covered.
double crownCover(const std::vector<CrownPart>& parts, const CrownFrame& frame, const CProgress& progress);
/// How what is seen from four sides lies in the light of one sun; crownCover(), which takes as long, is known.
CrownLook crownLook(const std::vector<CrownPart>& parts, const CrownFrame& frame, double covered, const CProgress& progress);

/// The leaves that a season left on some stems (none: on all), in the form of a level of detail, of `present` leaves. Of a part of them each is
/// larger.
std::vector<CrownPart> leafParts(const std::shared_ptr<const COrgans>& leaves, const StemSet* stems, double present, const CTree& tree,
                                 const MeshParams& params, const LeafMasks& masks, const Detail& detail, const CProgress& progress);

/// None where they have more than two million vertices: those of large trees would take too much memory.
std::vector<CrownPart> partsOf(const OrganMeshes& leaves, const LeafMasks& masks, const CProgress& progress);

/// By how much areas have to grow, and what is covered then.
struct CrownFit {
    double areas, covered;
};

/// For something to cover as much as is wanted: by secants from `start`.
template <typename CoverAt> CrownFit fitTo(double wanted, double start, CoverAt&& coverAt) {
    constexpr int kSteps = 3;
    constexpr double kGood = 0.01, kMin = 0.4, kMax = 2.5, kMinSlope = 0.2;
    CrownFit fit{start, coverAt(start)};
    double slope = 0.6; // by which power of its area a crown covers more
    for (int i = 0; i < kSteps && fit.covered > 0 && std::abs(fit.covered / wanted - 1) > kGood; ++i) {
        const double next = std::clamp(fit.areas * std::pow(wanted / fit.covered, 1 / slope), kMin, kMax);
        if (next == fit.areas) break;
        const double now = coverAt(next);
        slope = std::clamp(std::log(now / fit.covered) / std::log(next / fit.areas), kMinSlope, 1.0);
        fit = {next, now};
    }
    return fit;
}

} // namespace stromar
