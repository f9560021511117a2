#pragma once
#include "stem/StemSurface.h"
#include <span>
#include <vector>

namespace stromar {

/// How far along its picture the bark of a stem is. The picture is wrapped around the stem as often at its tip as at its
/// base: where the wood is thinner it is as much smaller, and as much shorter along it, so that it keeps its shape.
class CBarkScale {
public:
    explicit CBarkScale(const CStemSurface& surface) : m_surface(surface) {}

    /// Along a path of the stem; below where it parts from another it has that one's bark. Linear in their segments.
    void start(const CGeneration& generation, const CStem& stem, const CPath& path);
    /// Times around.
    double around() const { return m_bark.around; }
    /// Repeats from the stem's base to a place, metres along it.
    double at(double along) const;
    /// Repeats per metre where the wood is as thick as at the stem's base.
    double perMetre() const { return m_bark.perMetre; }

private:
    static constexpr double kFinest = 0.15; ///< of the scale at the base: a tip has no bark without end

    struct Piece {
        double start, length, repeats; ///< metres along, and what lies below
        double low, high;              ///< radii in those of the base
    };
    /// Metres of the base's scale in a part of a piece.
    double within(const Piece& piece, double part) const;

    void add(const CStem& stem, std::span<const CSegment> segments, double until);

    const CStemSurface& m_surface;
    CStemSurface::Bark m_bark{1, 1};
    double m_finest = kFinest;
    std::vector<Piece> m_pieces;
};

} // namespace stromar
