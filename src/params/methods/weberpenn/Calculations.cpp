#include "stromar/params/methods/weberpenn/Calculations.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
using std::numbers::pi;

double flame(double r) { return r <= 0.7 ? r / 0.7 : (1 - r) / 0.3; }

double envelopeRatio(double r, const WeberPennParams& g) {
    if (r < 0 || r > 1) return 0;
    const double peak = g.pruneWidthPeak;
    if (r < 1 - peak) return std::pow(r / (1 - peak), g.prunePowerHigh);
    return peak == 0 ? 1 : std::pow((1 - r) / peak, g.prunePowerLow);
}
} // namespace

double shapeRatio(int shape, double ratio, const WeberPennParams& global) {
    if (shape == 8) return envelopeRatio(ratio, global);
    const double r = std::clamp(ratio, 0.0, 1.0);
    switch (shape) {
    case 0: return 0.2 + 0.8 * r;
    case 1: return 0.2 + 0.8 * std::sin(pi * r);
    case 2: return 0.2 + 0.8 * std::sin(0.5 * pi * r);
    case 3: return 1;
    case 4: return 0.5 + 0.5 * r;
    case 5: return flame(r);
    case 6: return 1 - 0.8 * r;
    default: return 0.5 + 0.5 * flame(r);
    }
}

double CCalculations::gradedDownAngle(double downAngle, double downAngleV, const StemMeasures& stem,
                                      double offset) const {
    const double ratio = (stem.length - offset) / (stem.length - bareLength());
    return downAngle + downAngleV * (1 - 2 * shapeRatio(0, ratio, m_params));
}

double CCalculations::childRadius(const StemMeasures& parent, double childLength, double woodThere) const {
    return std::min(parent.radius * std::pow(childLength / parent.length, m_params.ratioPower), woodThere);
}

double CTrunkCalc::length(double lengthMax, const StemMeasures&, double) const { return lengthMax * m_scaleTree; }

double CTrunkCalc::childCount(double branches, const StemMeasures&) const { return branches; }

double C0BranchCalc::length(double lengthMax, const StemMeasures& parent, double offset) const {
    const double ratio = (parent.length - offset) / (parent.length - lengthBase());
    return parent.length * lengthMax * shapeRatio(m_params.shape, ratio, m_params);
}

double C0BranchCalc::childCount(double branches, const StemMeasures& stem) const {
    return branches * (0.2 + 0.8 * (stem.length / stem.parentLength) / stem.lengthMax);
}

double C1BranchCalc::length(double lengthMax, const StemMeasures& parent, double offset) const {
    return lengthMax * (parent.length - 0.6 * offset);
}

double C1BranchCalc::childCount(double branches, const StemMeasures& stem) const {
    return branches * (1 - 0.5 * stem.offset / stem.parentLength);
}

bool insideEnvelope(double x, double y, double z, const WeberPennParams& global, double scaleTree) {
    const double ratio = (scaleTree - z) / (scaleTree * (1 - global.baseSize));
    return std::hypot(x, y) / scaleTree < global.pruneWidth * shapeRatio(8, ratio, global);
}

} // namespace stromar
