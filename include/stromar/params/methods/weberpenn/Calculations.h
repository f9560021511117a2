#pragma once
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include <memory>

namespace stromar {

/// Relative branch length by crown shape 0..8 (Weber & Penn §4.3). `ratio` is 1 at the bottom of the crown, 0 at its
/// top; shape 8 is the pruning envelope and takes its profile from `global`.
double shapeRatio(int shape, double ratio, const WeberPennParams& global);

/// The measures of one stem that formulas use. Metres.
struct StemMeasures {
    double length = 0;
    double lengthMax = 0; ///< nLength + var(nLengthV) it was made with
    double radius = 0;    ///< at its base; without flare, lobes and the least radius
    double offset = 0;    ///< of its base from its parent's base
    double parentLength = 0;
};

/// The formulas of one kind of stem. Pure: everything that varies is an argument. Lengths in metres, angles in radians.
class CCalculations {
public:
    CCalculations(const WeberPennParams& params, double scaleTree) : m_params(params), m_scaleTree(scaleTree) {}
    virtual ~CCalculations() = default;

    /// The length of a stem of this kind that sits at `offset` on `parent` (Weber & Penn §4.3).
    virtual double length(double lengthMax, const StemMeasures& parent, double offset) const = 0;
    /// How many children a stem of this kind bears when the child level's most is `branches`; not rounded.
    virtual double childCount(double branches, const StemMeasures& stem) const = 0;
    /// The part of a stem of this kind, from its base, that bears nothing. Metres.
    virtual double bareLength() const { return 0; }

    /// The down angle of a child at `offset` on a stem of this kind when its variation is negative: graded, not random.
    double gradedDownAngle(double downAngle, double downAngleV, const StemMeasures& stem, double offset) const;
    /// The radius of a child's base (Weber & Penn §4.4); `woodThere` is the parent's at the child's offset.
    double childRadius(const StemMeasures& parent, double childLength, double woodThere) const;

    double scaleTree() const { return m_scaleTree; }

protected:
    double lengthBase() const { return m_params.baseSize * m_scaleTree; }

    const WeberPennParams m_params;
    double m_scaleTree;
};

/// The trunk.
class CTrunkCalc : public CCalculations {
public:
    using CCalculations::CCalculations;
    double length(double lengthMax, const StemMeasures& parent, double offset) const override;
    double childCount(double branches, const StemMeasures& stem) const override;
    double bareLength() const override { return lengthBase(); }
};

/// Branches on the trunk.
class C0BranchCalc : public CCalculations {
public:
    using CCalculations::CCalculations;
    double length(double lengthMax, const StemMeasures& parent, double offset) const override;
    double childCount(double branches, const StemMeasures& stem) const override;
};

/// Branches on branches.
class C1BranchCalc : public CCalculations {
public:
    using CCalculations::CCalculations;
    double length(double lengthMax, const StemMeasures& parent, double offset) const override;
    double childCount(double branches, const StemMeasures& stem) const override;
};

/// Whether a point lies inside the pruning envelope (Weber & Penn §4.6). Metres, the trunk's base at the origin.
bool insideEnvelope(double x, double y, double z, const WeberPennParams& global, double scaleTree);

} // namespace stromar
