#include "CardLight.h"
#include "stromar/mesh/Shading.h"
#include "stromar/texture/Opacity.h"
#include "stromar/texture/Srgb.h"
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace stromar {

namespace {
constexpr glm::dvec3 kSunlight(2.9, 2.75, 2.5), kHaze(0.62, 0.75, 0.89), kZenith(0.11, 0.30, 0.74), kBounce(0.27, 0.30, 0.18); // on a clear day
constexpr double kLeast = 0.3, kMost = 1.6;

template <typename Curve> glm::dvec3 each(const glm::dvec3& c, Curve&& curve) { return {curve(float(c.x)), curve(float(c.y)), curve(float(c.z))}; }

/// The sky on a clear day, at a ray's end.
glm::dvec3 skyIn(const glm::dvec3& ray, const glm::dvec3& sun) {
    const double high = 0.3 * glm::smoothstep(0.0, 0.08, ray.z) + 0.7 * glm::smoothstep(0.0, 0.38, ray.z);
    return glm::mix(kHaze, kZenith, high) + 0.1 * std::pow(std::max(0.0, glm::dot(ray, sun)), 8) * kSunlight;
}

/// Fresnel's part of what is reflected (Schlick 1994).
double fresnel(double cosine) { return std::pow(1 - std::max(0.0, cosine), 5); }

/// The light that a place reflects to the viewer, as the viewport's fragments do (kTreeFragmentShader).
class CFragment {
public:
    CFragment(const LitPlace& place, const glm::dvec3& sun, const MeanLook& look)
        : m_normal(place.normal), m_toViewer(place.toViewer), m_sun(sun), m_direct(double(place.sunVisibility) * kSunlight), m_open(place.skyVisibility),
          m_facing(glm::dot(m_normal, sun)), m_rough(std::clamp(look.roughness + (place.behind ? 0.2 : 0), 0.15, 1.0)), m_through(look.through) {}

    glm::dvec3 lightOf(const glm::dvec3& colour) const { return colour * (front() + m_through * glm::dvec3(1.3, 1.25, 0.6) * behind()) + specular() + rim(); }

private:
    /// Of the sky and the ground, on a side that looks up so much.
    static glm::dvec3 around(double up) { return glm::mix(kBounce, 1.05 * glm::mix(kHaze, kZenith, 0.35), 0.5 + 0.5 * up); }
    glm::dvec3 front() const { return m_open * around(m_normal.z) + std::max(0.0, m_facing) * m_direct; }
    glm::dvec3 behind() const { return 0.35 * m_open * around(-m_normal.z) + std::max(0.0, -m_facing) * m_direct; }
    glm::dvec3 specular() const {
        const glm::dvec3 half = glm::normalize(m_sun + m_toViewer);
        const double sharp = 2 / std::pow(m_rough, 4) - 2 + 1e-3, mirror = 0.04 + 0.96 * fresnel(glm::dot(m_toViewer, half));
        return std::max(0.0, m_facing) * mirror * (sharp + 8) / 25 * std::pow(std::max(0.0, glm::dot(m_normal, half)), sharp) * m_direct;
    }
    glm::dvec3 rim() const {
        const double cosine = glm::dot(m_normal, m_toViewer);
        const glm::dvec3 ray = 2 * cosine * m_normal - m_toViewer;
        return ray.z < 0 ? glm::dvec3(0) : (0.04 + 0.5 * fresnel(cosine)) * (1 - m_rough) * m_open * skyIn(ray, m_sun);
    }

    glm::dvec3 m_normal, m_toViewer, m_sun, m_direct;
    double m_open, m_facing, m_rough, m_through;
};

/// Tone mapping (Narkowicz 2015), of colours that are faded a little; sRGB.
glm::dvec3 toneMapped(const glm::dvec3& light) {
    const glm::dvec3 c = 0.82 * glm::mix(glm::dvec3(glm::dot(light, glm::dvec3(0.25, 0.65, 0.1))), light, 0.86);
    return each((c * (2.51 * c + 0.03)) / (c * (2.43 * c + 0.59) + 0.14), encodedOf);
}

/// Of what is seen of cards, 0..1.
double woodOf(const CrownLook& cards) {
    std::size_t wood = 0, all = 0;
    for (const SeenPixel& pixel : cards.pixels)
        for (const LitPlace& place : pixel) {
            all += !isBesideCards(place.layer);
            wood += place.layer == CrownLayer::Wood;
        }
    return double(wood) / double(std::max<std::size_t>(1, all));
}

MeanLook mixed(const MeanLook& a, const MeanLook& b, double share) {
    return {glm::mix(a.front, b.front, share), glm::mix(a.back, b.back, share), glm::mix(a.roughness, b.roughness, share), glm::mix(a.through, b.through, share)};
}

void multiply(Pixels& pixels, const glm::dvec3& share) {
    for (auto& pixel : pixels)
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = byteOf(encodedOf(linearOf(float(pixel[c]) / 255) * float(share[static_cast<int>(c)])));
}
} // namespace

glm::dvec3 CCardLight::colourOf(const LitPlace& place, const MeanLook& look, UnderSides how) {
    if (isWood(place.layer)) return look.front;
    const bool pictured = how == UnderSides::Pictured, back = place.back != (!pictured && place.behind);
    const glm::dvec3& colour = back ? look.back : look.front;
    return pictured || !place.behind ? colour : 1.15 * glm::mix(colour, glm::dvec3(glm::dot(colour, glm::dvec3(0.3, 0.6, 0.1))), 0.25);
}

namespace {
/// A card's picture shows the wood of its twig as leaf.
bool showsBark(CrownLayer layer, bool onCards) { return layer == CrownLayer::OtherWood || (layer == CrownLayer::Wood && !onCards); }
} // namespace

const MeanLook& CCardLight::lookOf(CrownLayer layer, const MeanLook& leaf, const Shares* cards) const {
    if (layer == CrownLayer::Blossom) return m_blossom;
    return showsBark(layer, cards) ? m_bark : leaf;
}

glm::dvec3 CCardLight::tintOf(const LitPlace& place, const Shares* cards) const {
    constexpr double kLeastOpen = 0.35; // as in the fragments
    if (place.layer == CrownLayer::Blossom) return kLeafTint;
    if (showsBark(place.layer, cards)) return glm::dvec3(1);
    return kLeafTint * sunAndShadeAt(std::max(0.0, (double(place.skyVisibility) - kLeastOpen) / (1 - kLeastOpen)), m_sunAndShade);
}

/// sRGB. Of cards `leaf` is all that they show.
glm::dvec3 CCardLight::shownOf(const LitPlace& place, const glm::dvec3& sun, const MeanLook& leaf, UnderSides how, const Shares* cards) const {
    const MeanLook& look = lookOf(place.layer, leaf, cards);
    glm::dvec3 colour = colourOf(place, look, how) * tintOf(place, cards);
    if (cards && !isBesideCards(place.layer)) colour *= place.behind ? cards->behind : cards->front;
    return toneMapped(CFragment(place, sun, look).lightOf(colour));
}

/// Of the pixels' light.
glm::dvec3 CCardLight::meanOf(const CrownLook& crown, Whole whole, UnderSides how, const Shares* cards) const {
    glm::dvec3 sum(0);
    double weights = 1e-9;
    const double wood = cards ? woodOf(crown) : 0; // thinner than what is seen apart in their small pictures
    for (const auto& [leaf, weight] : m_leaves) {
        const MeanLook look = mixed(leaf, m_bark, wood);
        for (const SeenPixel& pixel : crown.pixels) {
            glm::dvec3 shown(0);
            double count = 0;
            for (const LitPlace& place : pixel) {
                if (whole == Whole::CardsAlone && isBesideCards(place.layer)) continue;
                shown += shownOf(place, glm::dvec3(crown.sun), look, how, cards);
                ++count;
            }
            if (count == 0) continue;
            sum += weight * count * each(shown / count, linearOf);
            weights += weight * count;
        }
    }
    return sum / weights;
}

/// That makes cards as bright as their twigs, and then the crown as bright: sharesOf(it) → Shares.
template <typename SharesOf> glm::dvec3 CCardLight::shareOfLight(UnderSides how, SharesOf&& sharesOf) const {
    constexpr int kSteps = 10;
    constexpr double kGood = 0.002;
    constexpr double kPower = 0.9, kOfBeside = 1.3; // of what is wanted over what is shown: light is nearly in proportion; by how much the second may differ
    const auto shownWith = [&](const glm::dvec3& share, Whole whole) {
        const Shares cards = sharesOf(share);
        return meanOf(m_looks.cards, whole, how, &cards);
    };
    glm::dvec3 share(1), least(kLeast), most(kMost);
    for (const Whole whole : {Whole::CardsAlone, Whole::Crown}) {
        const glm::dvec3 wanted = meanOf(m_looks.crown, whole, how, nullptr);
        if (wanted == glm::dvec3(0) || shownWith(share, whole) == glm::dvec3(0)) return share; // nothing is seen of them
        for (int i = 0; i < kSteps; ++i) {
            const glm::dvec3 now = glm::max(shownWith(share, whole), glm::dvec3(1e-9));
            if (glm::all(glm::lessThan(glm::abs(wanted / now - 1.0), glm::dvec3(kGood)))) break;
            share = glm::clamp(share * glm::pow(wanted / now, glm::dvec3(kPower)), least, most);
        }
        least = glm::max(least, share / kOfBeside);
        most = glm::min(most, share * kOfBeside);
    }
    return share;
}

void CCardLight::applyTo(TextureMaps& maps) const {
    const glm::dvec3 both = shareOfLight(UnderSides::Faded, [](const glm::dvec3& share) { return Shares{share, share}; });
    const glm::dvec3 behind = shareOfLight(UnderSides::Pictured, [&](const glm::dvec3& share) { return Shares{both, share}; });
    multiply(maps.albedo, both);
    multiply(maps.back, behind);
}

} // namespace stromar
