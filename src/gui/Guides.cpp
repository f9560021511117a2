#include "Guides.h"
#include "stromar/params/Calculations.h"
#include "stromar/params/ParamText.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr int kProfilePoints = 64;
constexpr int kEnvelopeShape = 8;

void set(CParams& params, const char* key, double value) {
    const ParamRef ref = std::get<ParamRef>(*findParam(key));
    const double digits = std::pow(10, ref.info->decimals);
    ref.set(params, std::round(value * digits) / digits);
}

double crownBase(const CParams& params, double scaleTree) { return params.global.baseSize * scaleTree; }

/// Height of a share of the crown, 0 its bottom, 1 its top.
double crownHeight(const CParams& params, double scaleTree, double share) {
    return crownBase(params, scaleTree) + share * (1 - params.global.baseSize) * scaleTree;
}

double crownShare(const CParams& params, double scaleTree, double height) {
    const double high = (1 - params.global.baseSize) * scaleTree;
    return high > 0 ? std::clamp((height - crownBase(params, scaleTree)) / high, 0.0, 1.0) : 0;
}

double radiusAt(Guide guide, const CParams& params, double scaleTree, double share) {
    if (guide == Guide::Envelope)
        return params.global.pruneWidth * scaleTree * shapeRatio(kEnvelopeShape, 1 - share, params.global);
    const double longest = params.level[0].length * params.level[1].length * scaleTree;
    return longest * shapeRatio(params.global.shape, 1 - share, params.global);
}

osg::Vec2d placeAt(Guide guide, const CParams& params, double scaleTree, double share) {
    return {radiusAt(guide, params, scaleTree, share), crownHeight(params, scaleTree, share)};
}

/// The power that makes the envelope as wide as this half-way between its end and its widest place.
double powerFor(const CParams& params, double scaleTree, double radius) {
    const double widest = params.global.pruneWidth * scaleTree;
    const double share = widest > 0 ? std::clamp(radius / widest, 0.001, 0.999) : 0.5;
    return std::log(share) / std::log(0.5);
}

constexpr GuideHandle kHandles[] = {
    {Guide::Envelope, N_("Width and widest place"),
     [](const CParams& p, double scale) { return placeAt(Guide::Envelope, p, scale, p.global.pruneWidthPeak); },
     [](CParams& p, double scale, const osg::Vec2d& to) {
         set(p, "PruneWidth", to.x() / scale);
         set(p, "PruneWidthPeak", std::clamp(crownShare(p, scale, to.y()), 0.01, 0.99));
     }},
    {Guide::Envelope, N_("Curve above"),
     [](const CParams& p, double scale) {
         return placeAt(Guide::Envelope, p, scale, (1 + p.global.pruneWidthPeak) / 2);
     },
     [](CParams& p, double scale, const osg::Vec2d& to) { set(p, "PrunePowerHigh", powerFor(p, scale, to.x())); }},
    {Guide::Envelope, N_("Curve below"),
     [](const CParams& p, double scale) { return placeAt(Guide::Envelope, p, scale, p.global.pruneWidthPeak / 2); },
     [](CParams& p, double scale, const osg::Vec2d& to) { set(p, "PrunePowerLow", powerFor(p, scale, to.x())); }},
    {Guide::Envelope, N_("Bare trunk"),
     [](const CParams& p, double scale) { return osg::Vec2d(0, crownBase(p, scale)); },
     [](CParams& p, double scale, const osg::Vec2d& to) { set(p, "BaseSize", std::min(to.y() / scale, 0.99)); }},
    {Guide::Crown, N_("Bare trunk"), [](const CParams& p, double scale) { return osg::Vec2d(0, crownBase(p, scale)); },
     [](CParams& p, double scale, const osg::Vec2d& to) { set(p, "BaseSize", std::min(to.y() / scale, 0.99)); }},
    {Guide::Crown, N_("Length of the branches"),
     [](const CParams& p, double scale) { return placeAt(Guide::Crown, p, scale, 0.35); },
     [](CParams& p, double scale, const osg::Vec2d& to) {
         const double relative = shapeRatio(p.global.shape, 0.65, p.global) * p.level[0].length * scale;
         if (relative > 0) set(p, "1Length", to.x() / relative);
     }},
};
} // namespace

Guide guideOf(const ParamRef& ref) {
    if (ref.group() == Group::Pruning) return Guide::Envelope;
    for (const char* key : {"Shape", "BaseSize", "1Length"})
        if (std::get<ParamRef>(*findParam(key)) == ref) return Guide::Crown;
    return Guide::None;
}

std::vector<osg::Vec2d> guideProfile(Guide guide, const CParams& params, double scaleTree) {
    std::vector<osg::Vec2d> profile;
    for (int i = 0; guide != Guide::None && i <= kProfilePoints; ++i) {
        const double share = double(i) / kProfilePoints;
        profile.push_back(placeAt(guide, params, scaleTree, share * share * (3 - 2 * share))); // dense at both ends
    }
    return profile;
}

std::span<const GuideHandle> guideHandles() { return kHandles; }

} // namespace stromar
