#include "stromar/mesh/twig/CutOut.h"
#include <utility>

namespace stromar {

CCutOut::CCutOut(const std::vector<bool>& cells, bool manyLeaves) : m_softening(softeningOf(manyLeaves)) {
    std::vector<double> finer(cells.begin(), cells.end());
    for (int level = 0; level < kLevels; ++level) {
        for (const double mean : finer) m_means[static_cast<std::size_t>(level)].push_back(static_cast<std::uint8_t>(std::lround(255 * mean)));
        const auto side = static_cast<std::size_t>(kSide) >> level;
        std::vector<double> coarser;
        for (std::size_t y = 0; y + 1 < side; y += 2)
            for (std::size_t x = 0; x + 1 < side; x += 2) {
                const std::size_t i = y * side + x;
                coarser.push_back((finer[i] + finer[i + 1] + finer[i + side] + finer[i + side + 1]) / 4);
            }
        finer = std::move(coarser);
    }
}

} // namespace stromar
