#pragma once
#include "stromar/mesh/twig/CrownLook.h"
#include "stromar/texture/TextureMaps.h"
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

namespace stromar {

/// What a picture of leaves or of bark shows on the average, as light.
struct MeanLook {
    glm::dvec3 front{0}, back{0}; ///< albedo
    double roughness = 0, through = 0;
};

/// Makes up for what cards lack: leaves that shade each other, look upwards, and turn their upper sides to whoever looks. The cards' colours become
/// such that a crown of them is shown as bright as its twigs are, where the viewport changes from one to the other: in the viewport's light, tone
/// mapped, in pixels that mix what is shown at their samples. Less finely shaded by cards, other wood and blossoms are brighter between them than
/// between leaves: cards make up for a part of it.
class CCardLight {
public:
    /// `sunAndShade`: LeafSunShade.
    CCardLight(const CardLooks& looks, const MeanLook& bark, const MeanLook& blossom, double sunAndShade)
        : m_looks(looks), m_bark(bark), m_blossom(blossom), m_sunAndShade(sunAndShade) {}

    /// One kind of leaf; `weight`: how much of all.
    void add(const MeanLook& leaf, double weight) { m_leaves.emplace_back(leaf, weight); }
    void applyTo(TextureMaps& maps) const;

private:
    /// What is drawn of leaves' and cards' under sides.
    enum class UnderSides {
        Faded,   ///< the picture of the upper side, as the processor draws them, and nearly as most readers of files do
        Pictured ///< a picture of their own, as graphics cards draw them
    };
    /// By which cards' colours are multiplied.
    struct Shares {
        glm::dvec3 front{1}, behind{1};
    };

    /// What is to be as bright.
    enum class Whole {
        CardsAlone, ///< and their twigs
        Crown       ///< with what is beside them
    };

    static glm::dvec3 colourOf(const LitPlace& place, const MeanLook& look, UnderSides how);
    const MeanLook& lookOf(CrownLayer layer, const MeanLook& leaf, const Shares* cards) const;
    glm::dvec3 tintOf(const LitPlace& place, const Shares* cards) const;
    glm::dvec3 shownOf(const LitPlace& place, const glm::dvec3& sun, const MeanLook& leaf, UnderSides how, const Shares* cards) const;
    glm::dvec3 meanOf(const CrownLook& crown, Whole whole, UnderSides how, const Shares* cards) const; ///< without shares of twigs
    template <typename SharesOf> glm::dvec3 shareOfLight(UnderSides how, SharesOf&& sharesOf) const;

    const CardLooks& m_looks;
    MeanLook m_bark, m_blossom;
    double m_sunAndShade;
    std::vector<std::pair<MeanLook, double>> m_leaves; ///< of each kind, and how many
};

} // namespace stromar
