#pragma once

namespace stromar {

/// A picture that is seen large has hard edges; one of a few pixels covers a part of each. In between it becomes softer by steps of the same
/// ratio: where a pixel shows this part of the picture's side, from `from` to `to`.
struct Softening {
    double from, to;
    /// 0 hard … 1 soft.
    double at(double footprint) const;
};
/// Of a picture of one leaf, or of many, which are small in it.
constexpr Softening softeningOf(bool manyLeaves) { return manyLeaves ? Softening{1.0 / 64, 1.0 / 8} : Softening{0.12, 0.37}; }
/// How much of a pixel an opacity covers, 0..1: hard by the cut, soft as much as it says.
double coverOf(double opacity, double cut, double soft);

} // namespace stromar
