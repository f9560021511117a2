#pragma once
#include <cstddef>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace stromar {

inline constexpr std::string_view kMonopodial = R"(
axiom: A(1,10)
A(l,w) : * -> !(w)F(l)[&(a0)B(l*r2,w*wr)]/(d)A(l*r1,w*wr)
B(l,w) : * -> !(w)F(l)[-(a2)$C(l*r2,w*wr)]C(l*r1,w*wr)
C(l,w) : * -> !(w)F(l)[+(a2)$B(l*r2,w*wr)]B(l*r1,w*wr)
)";
inline constexpr std::string_view kSympodial = R"(
axiom: A(1,10)
A(l,w) : * -> !(w)F(l)[&(a1)B(l*r1,w*wr)]/(180)[&(a2)B(l*r2,w*wr)]
B(l,w) : * -> !(w)F(l)[+(a1)$B(l*r1,w*wr)][-(a2)$B(l*r2,w*wr)]
)";
inline constexpr std::string_view kTernary = R"(
axiom: !(1)F(200)/(45)A
A : * -> !(vr)F(50)[&(a)F(50)A]/(d1)[&(a)F(50)A]/(d2)[&(a)F(50)A]
F(l) : * -> F(l*lr)
!(w) : * -> !(w*vr)
)";

/// A figure of The Algorithmic Beauty of Plants, chapter 2, by an independent reference program.
struct Figure {
    const char* name;
    std::string_view rules;
    std::string defines;
    int steps;
    glm::dvec3 tropism; ///< y up, as printed
    double bend;
    std::size_t segments;
    double length;
    glm::dvec3 low, high; ///< y up
    double maxWidth, minWidth;
};

inline std::string honda(double r1, double r2, double a0, double a2) {
    return "#define r1 " + std::to_string(r1) + "\n#define r2 " + std::to_string(r2) + "\n#define a0 " +
           std::to_string(a0) + "\n#define a2 " + std::to_string(a2) + "\n#define d 137.5\n#define wr 0.707";
}
inline std::string aono(double r1, double r2, double a1, double a2) {
    return "#define r1 " + std::to_string(r1) + "\n#define r2 " + std::to_string(r2) + "\n#define a1 " +
           std::to_string(a1) + "\n#define a2 " + std::to_string(a2) + "\n#define wr 0.707";
}
inline std::string ternary(double d1, double d2, double a, double lr) {
    return "#define d1 " + std::to_string(d1) + "\n#define d2 " + std::to_string(d2) + "\n#define a " +
           std::to_string(a) + "\n#define lr " + std::to_string(lr) + "\n#define vr 1.732";
}

inline const Figure kFigures[] = {
    {"2.6a", kMonopodial, honda(.9, .6, 45, 45), 10, {}, 0, 1023, 113.3301, {-1.710, 0, -2.599}, {1.786, 6.513, 1.691}, 10, 0.4413},
    {"2.6b", kMonopodial, honda(.9, .9, 45, 45), 10, {}, 0, 1023, 445.0584, {-3.803, 0, -4.582}, {3.917, 6.513, 3.542}, 10, 0.4413},
    {"2.6c", kMonopodial, honda(.9, .8, 45, 45), 10, {}, 0, 1023, 286.5706, {-2.926, 0, -3.465}, {2.821, 6.513, 2.769}, 10, 0.4413},
    {"2.6d", kMonopodial, honda(.9, .7, 30, -30), 10, {}, 0, 1023, 181.5853, {-1.634, 0, -2.144}, {1.473, 6.513, 1.744}, 10, 0.4413},
    {"2.7a", kSympodial, aono(.9, .7, 5, 65), 10, {}, 0, 1023, 181.5853, {-2.240, 0, -2.495}, {3.021, 6.424, 3.599}, 10, 0.4413},
    {"2.7b", kSympodial, aono(.9, .7, 10, 60), 10, {}, 0, 1023, 181.5853, {-2.139, 0, -2.698}, {2.765, 6.165, 3.326}, 10, 0.4413},
    {"2.7c", kSympodial, aono(.9, .8, 20, 50), 10, {}, 0, 1023, 286.5706, {-2.820, 0, -3.235}, {3.063, 5.269, 3.680}, 10, 0.4413},
    {"2.7d", kSympodial, aono(.9, .8, 35, 35), 10, {}, 0, 1023, 286.5706, {-3.224, 0, -3.418}, {2.866, 3.625, 3.039}, 10, 0.4413},
    {"2.8a", kTernary, ternary(94.74, 132.63, 18.95, 1.109), 6, {0, -1, 0}, .22, 1457, 77277.3719, {-501.147, 0, -478.708}, {544.180, 1123.478, 510.327}, 26.9952, 1.732},
    {"2.8b", kTernary, ternary(137.5, 137.5, 18.95, 1.109), 8, {0, -1, 0}, .14, 13121, 694134.1714, {-766.483, 0, -804.019}, {797.522, 1602.719, 883.150}, 80.9810, 1.732},
    {"2.8c", kTernary, ternary(112.5, 157.5, 22.5, 1.790), 8, {-.02, -1, 0}, .27, 13121, 1088121.1845, {-5867.237, 0, -6018.974}, {5853.664, 33018.266, 6748.854}, 80.9810, 1.732},
    {"2.8d", kTernary, ternary(180, 252, 36, 1.070), 6, {-.61, .77, -.19}, .40, 1457, 75688.6714, {-604.308, 0, -353.997}, {35.795, 965.714, 289.293}, 26.9952, 1.732},
};

inline glm::dvec3 zUp(const glm::dvec3& v) { return {v.x, -v.z, v.y}; }
inline glm::dvec3 yUp(const glm::dvec3& v) { return {v.x, v.z, -v.y}; }

} // namespace stromar
