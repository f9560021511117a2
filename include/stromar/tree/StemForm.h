#pragma once
#include <algorithm>
#include <cmath>

namespace stromar {

/// How the radius of a stem runs between the ends of its segments.
struct RadiusProfile {
    enum class Form : unsigned char {
        Segments, ///< evenly from each segment's radiusBase to its radiusEnd
        Steps,    ///< every segment has one radius; wood runs evenly to that of the next (stems without clones)
        RoundEnd, ///< a cone that ends in half a sphere (Weber & Penn §4.4, taper 1..2)
        Spheres,  ///< a chain of spheres (taper 2..3)
    };
    double narrowing = 0; ///< the part of the base's radius that a cone loses along the stem
    double depth = 1;     ///< how far the spheres are cut into the cylinder, 0..1
    Form form = Form::Segments;

    /// Whether the radius changes evenly along each segment.
    bool isEven() const { return form == Form::Segments || form == Form::Steps; }
    /// `along` metres from the base of a stem of a length and a radius at its base; of Segments and Steps only where those end.
    double radiusAt(double along, double length, double radius) const {
        const double cone = radius * (1 - narrowing * along / length);
        if (isEven() || cone <= 0) return std::max(0.0, cone);
        const double toTip = length - along;
        if (form == Form::RoundEnd) return toTip >= cone ? cone : sphere(cone, toTip);
        const double inSphere = std::abs(toTip - 2 * cone * std::floor(toTip / (2 * cone) + 0.5));
        const double cut = toTip < cone ? 1 : depth;
        return (1 - cut) * cone + cut * sphere(cone, inSphere);
    }

private:
    static double sphere(double radius, double in) {
        return std::sqrt(std::max(0.0, radius * radius - (in - radius) * (in - radius)));
    }
};

/// The form of a trunk where it enters the ground, as parts of its radius; heights as parts of its length.
struct BaseForm {
    double flare = 0; ///< how much wider it is at the ground (Weber & Penn §4.4)
    int lobes = 0;    ///< bulges around it
    double lobeDepth = 0, lobeFade = 0; ///< LobeFade ends them above the ground as the thesis draws
    int roots = 0;
    double rootReach = 0, rootHeight = 1;

    bool operator==(const BaseForm&) const = default;
    int lobeCount() const { return lobeDepth > 0 ? lobes : 0; }
    int rootCount() const { return rootReach > 0 ? roots : 0; }
    /// The wider base as a factor on the radius at `z` = height / length.
    double flareAt(double z) const { return 1 + flare * (falloff(z) - 1) / 100; }
    double lobeDepthAt(double z) const { return lobeDepth * (1 + lobeFade * ((falloff(z) - 1) / 99 - 1)); }

    /// 100^max(0, 1 − 8z): 100 at z = 0, 1 from z = 1/8.
    static double falloff(double z) { return z < 0.125 ? std::pow(100.0, 1 - 8 * z) : 1; }
};

} // namespace stromar
