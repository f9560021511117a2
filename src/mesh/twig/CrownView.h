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

/// Seen from four sides in the light of one sun; what it covers, from eight. A seventh of a second for a million triangles.
CrownLook crownLook(const std::vector<CrownPart>& parts, const CrownFrame& frame, const CProgress& progress);
/// The first of its numbers alone, in a third of the time.
double crownCover(const std::vector<CrownPart>& parts, const CrownFrame& frame, const CProgress& progress);

/// The leaves that a season left on some stems (none: on all), in the form of a level of detail, of `present` leaves. Of a part of them each is
/// larger.
std::vector<CrownPart> leafParts(const std::shared_ptr<const COrgans>& leaves, const StemSet* stems, double present, const CTree& tree,
                                 const MeshParams& params, const LeafMasks& masks, const Detail& detail, const CProgress& progress);

/// None where they have more than two million vertices: those of large trees would take too much memory.
std::vector<CrownPart> partsOf(const OrganMeshes& leaves, const LeafMasks& masks, const CProgress& progress);

/// By how much areas have to grow for something to cover as much as is wanted: by secants from `start`.
template <typename CoverAt> double fitTo(double wanted, double start, CoverAt&& coverAt) {
    constexpr int kSteps = 3;
    constexpr double kGood = 0.01, kMin = 0.4, kMax = 2.5, kMinSlope = 0.2;
    double fit = start, slope = 0.6, covered = coverAt(fit); // slope: by which power of its area a crown covers more
    for (int i = 0; i < kSteps && covered > 0 && std::abs(covered / wanted - 1) > kGood; ++i) {
        const double next = std::clamp(fit * std::pow(wanted / covered, 1 / slope), kMin, kMax);
        if (next == fit) break;
        const double now = coverAt(next);
        slope = std::clamp(std::log(now / covered) / std::log(next / fit), kMinSlope, 1.0);
        fit = next;
        covered = now;
    }
    return fit;
}

} // namespace stromar
