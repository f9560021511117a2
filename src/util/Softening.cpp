#include "stromar/util/Softening.h"
#include <algorithm>
#include <cmath>

namespace stromar {

double Softening::at(double footprint) const { return std::clamp(std::log2(footprint / from) / std::log2(to / from), 0.0, 1.0); }

double coverOf(double opacity, double cut, double soft) {
    if (soft <= 0) return opacity > cut;
    return std::clamp((opacity - std::lerp(cut, 0.5, soft)) / soft + 0.5, 0.0, 1.0);
}

} // namespace stromar
