#pragma once
#include "stem/StemSurface.h"
#include "stromar/mesh/MeshBuilder.h"
#include <glm/vec2.hpp>
#include <limits>
#include <span>
#include <vector>

namespace stromar {

/// How far along its picture the bark of a stem is. The picture is wrapped around the stem as often at its tip as at its
/// base: where the wood is thinner it is as much smaller, and as much shorter along it, so that it keeps its shape.
class CBarkScale {
public:
    explicit CBarkScale(const CStemSurface& surface) : m_surface(surface) {}

    /// Along a path of the stem, as far as `until`, metres; below where it parts from another it has that one's bark. With a joint it runs on
    /// from the parent's. Linear in their segments.
    void start(const CGeneration& generation, const CStem& stem, const CPath& path, const BarkJoint* joint = nullptr,
               double until = std::numeric_limits<double>::infinity());
    /// Times around.
    double around() const { return m_bark.around; }
    /// Repeats at so many turns about the stem.
    double around(double turns) const { return m_bark.around * turns + m_offset.x; }
    /// Repeats from the stem's base to a place, metres along it.
    double at(double along) const { return m_offset.y + ownAt(along); }
    /// Both below the first ring of its own, at a fork of its parent's.
    glm::dvec2 onLimb(double turns, double along) const;
    /// Repeats per metre where the wood is as thick as at the stem's base.
    double perMetre() const { return m_bark.perMetre; }
    double perMetreAt(double along) const;

private:
    static constexpr double kFinest = 0.15; ///< of the scale at the base: a tip has no bark without end

    struct Piece {
        double start, length, repeats; ///< metres along, and what lies below
        double low, high;              ///< radii in those of the base
    };
    /// Metres of the base's scale in a part of a piece.
    double within(const Piece& piece, double part) const;

    double ownAt(double along) const;
    double alongLimb(double along) const;
    void add(const CStem& stem, std::span<const CSegment> segments, double until);
    struct Part {
        double from, to;  ///< of a segment
        double low, high; ///< radii in those of the base
    };
    /// In pieces along which the radius runs evenly.
    template <class Scale> void addEven(const Part& part, const CSegment& segment, const Scale& scaleAt, int halvings);

    const CStemSurface& m_surface;
    CStemSurface::Bark m_bark{1, 1};
    double m_finest = kFinest;
    std::vector<Piece> m_pieces;
    BarkJoint m_joint{};
    glm::dvec2 m_offset{0}; ///< repeats that the parent's bark is ahead
    double m_perMetre = 0;  ///< its own at the end of the joint
};

} // namespace stromar
