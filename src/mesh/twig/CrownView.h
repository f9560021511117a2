#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/mesh/twig/Twig.h"
#include "twig/TwigMask.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <memory>
#include <vector>

namespace stromar {

/// Where the crown is that is measured.
struct CrownFrame {
    glm::dvec3 middle{0};
    double radius = 0; ///< of a ball around it
};

/// That show the ball's diameter where a level of detail, 1 or more, of a tree so high takes over.
double pixelsOf(const CrownFrame& frame, double height, const Detail& detail);

/// Triangles that are measured: leaves of a kind, cards of twigs, wood or blossoms.
struct CrownPart {
    std::shared_ptr<const CMesh> mesh;
    const CCutOut* leaf = nullptr;
    const CTwigMask* twig = nullptr;
    CrownLayer layer = CrownLayer::Leaf; ///< of cards their masks say it

    const CCutOut* cutOut() const { return twig ? &twig->cutOut() : leaf; } ///< none: all is there
};

/// What a crown covers of pictures from eight sides, where so many pixels show the ball's diameter: cut-outs are as soft as the viewport draws them.
class CCrownCover {
public:
    /// `background`: what is there whatever else is, drawn once.
    CCrownCover(const CrownFrame& frame, double pixels, const std::vector<CrownPart>& background, const CProgress& progress);
    ~CCrownCover();

    /// The share of the pictures that is covered by these parts and the background. Throws CCancelled.
    double with(const std::vector<CrownPart>& parts) const;

private:
    class CBackground;

    const CProgress& m_progress;
    std::unique_ptr<const CBackground> m_background;
    double m_cells = 0; ///< of a picture
};

/// How many times as much is seen of one as of the other, each among what hides it, from eight sides.
double seenOverSeen(const std::vector<CrownPart>& one, const std::vector<CrownPart>& other, const std::vector<CrownPart>& hiding, const CrownFrame& frame,
                    double pixels, const CProgress& progress);
/// How what is seen from eight sides lies in the light of one sun, where so many pixels show the ball's diameter.
/// Takes 100 MB at most while it looks.
CrownLook crownLook(const std::vector<CrownPart>& parts, const CrownFrame& frame, double pixels, const CProgress& progress);

/// The leaves that a season left on some stems (none: on all), in the form of a level of detail, of `present` leaves. Of a part of them each is
/// larger.
std::vector<CrownPart> leafParts(const std::shared_ptr<const COrgans>& leaves, const StemSet* stems, double present, const CTree& tree,
                                 const MeshParams& params, const LeafMasks& masks, const Detail& detail, const CProgress& progress);

/// Likewise the blossoms that the season left; none where there are none.
std::vector<CrownPart> blossomParts(const CrownOrgans& organs, const CTree& tree, const MeshParams& params, const Detail& detail, const CProgress& progress);

/// The wood of all stems but twigs that cards stand for (woodBeside()).
CrownPart otherWood(const StemSet& twigs, const CTree& tree, double minRadius);

/// None where they have more than two million vertices: those of large trees would take too much memory.
std::vector<CrownPart> partsOf(const OrganMeshes& leaves, const LeafMasks& masks, const CProgress& progress);

/// By how much areas have to grow, and what is covered then.
struct CrownFit {
    double areas, covered;
};

constexpr double kGoodFit = 0.003; ///< parts of what is wanted
constexpr double kGoodFarFit = 0.01; ///< where level of detail 3 is first seen, in a few thousand pixels

/// For something to cover as much as is wanted, up to a part of it (`good`): by secants from `start`.
template <typename CoverAt> CrownFit fitTo(double wanted, double start, double good, CoverAt&& coverAt) {
    constexpr int kSteps = 4;
    constexpr double kMin = 0.4, kMax = 2.5, kMinSlope = 0.2;
    CrownFit fit{start, coverAt(start)};
    double slope = 0.6; // by which power of its area a crown covers more
    for (int i = 0; i < kSteps && fit.covered > 0 && std::abs(fit.covered / wanted - 1) > good; ++i) {
        const double next = std::clamp(fit.areas * std::pow(wanted / fit.covered, 1 / slope), kMin, kMax);
        if (next == fit.areas) break;
        const double now = coverAt(next);
        slope = std::clamp(std::log(now / fit.covered) / std::log(next / fit.areas), kMinSlope, 1.0);
        fit = {next, now};
    }
    return fit;
}

} // namespace stromar
