#pragma once
#include "stromar/tree/StemForm.h"
#include "stromar/util/Random.h"
#include "stromar/util/Turn.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace stromar {

/// The ridges that run from a trunk into the ground (Roots, RootReach, RootHeight). No two are alike. In the trunk's
/// radii; heights as parts of its length.
class CRootFlare {
public:
    /// How far the bark stands out of the trunk, and how that changes.
    struct Rise {
        double out = 0;
        double around = 0; ///< per radian
        double up = 0;     ///< per trunk's length
    };

    CRootFlare() = default;
    CRootFlare(const BaseForm& g, std::uint64_t trunk) : m_height(g.rootHeight) {
        const double apart = kTurn / std::max(1, g.roots);
        m_width = kWidth * apart;
        for (int k = 0; k < g.roots; ++k) {
            const auto random = [&, key = hashCombine(hashCombine(kOrder, trunk), static_cast<std::uint64_t>(k))](
                                    std::uint64_t draw) { return 2 * unitOf(hashCombine(key, draw)) - 1; };
            m_roots.push_back({(k + kAside * random(0)) * apart, g.rootReach * (1 + kUneven * random(1))});
        }
    }

    bool empty() const { return m_roots.empty(); }
    double height() const { return m_height; }

    Rise at(double angle, double along) const {
        const double left = 1 - along / m_height;
        if (left <= 0) return {};
        const double high = left * left * left, higher = -3 * left * left / m_height;
        Rise rise;
        for (const Root& root : m_roots) {
            const double off = std::remainder(angle - root.angle, kTurn) / m_width;
            const double ridge = root.reach * std::exp(-off * off);
            rise.out += ridge * high;
            rise.around -= 2 * off / m_width * ridge * high;
            rise.up += ridge * higher;
        }
        return rise;
    }

    /// What `out` can be at most at a height, of any trunk.
    static double maxOut(const BaseForm& g, double along) {
        const double left = g.roots > 0 ? std::max(0.0, 1 - along / g.rootHeight) : 0;
        return kOverlap * g.rootReach * (1 + kUneven) * left * left * left;
    }

private:
    static constexpr double kWidth = 0.24;  // of a ridge, as a part of what lies between two
    static constexpr double kAside = 0.22;  // how far one stands off its even place, likewise
    static constexpr double kUneven = 0.3;  // of the reach
    static constexpr double kOverlap = 1.2; // where two ridges meet
    static constexpr std::uint64_t kOrder = 0x726f6f74;

    struct Root {
        double angle, reach;
    };
    std::vector<Root> m_roots;
    double m_height = 1, m_width = 1;
};

} // namespace stromar
