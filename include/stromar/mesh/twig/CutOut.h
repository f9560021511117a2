#pragma once
#include "stromar/util/Softening.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace stromar {

/// Where the picture of a leaf, or of a twig with many, is not cut out. Without one all of it is there.
class CCutOut {
public:
    static constexpr int kSide = 128;

    CCutOut() = default;
    /// Rows from below.
    CCutOut(const std::vector<bool>& cells, bool manyLeaves);

    bool covers(const glm::vec2& texCoord) const { return m_means[0].empty() || m_means[0][cellAt(texCoord, 0)] > 127; }
    /// The mean over so many cells each way, 2^level.
    double meanAt(const glm::vec2& texCoord, int level) const {
        return m_means[0].empty() ? 1.0 : m_means[static_cast<std::size_t>(level)][cellAt(texCoord, level)] / 255.0;
    }
    /// The level that a pixel shows which spans this part of the picture's side.
    static int levelOf(double footprint) { return static_cast<int>(std::lround(std::clamp(std::log2(footprint * kSide), 0.0, kLevels - 1.0))); }
    const Softening& softening() const { return m_softening; }

private:
    static constexpr int kLevels = 8;

    static std::size_t cellAt(const glm::vec2& texCoord, int level) {
        const int side = kSide >> level;
        const auto cell = [side](float v) { return static_cast<std::size_t>(std::clamp(static_cast<int>((v - std::floor(v)) * float(side)), 0, side - 1)); };
        return cell(texCoord.y) * static_cast<std::size_t>(side) + cell(texCoord.x);
    }

    std::array<std::vector<std::uint8_t>, kLevels> m_means; ///< by level, 255: all is there
    Softening m_softening = softeningOf(false);
};

} // namespace stromar
