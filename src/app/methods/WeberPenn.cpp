#include "WeberPenn.h"
#include "stromar/params/ParamText.h"
#include "stromar/params/methods/weberpenn/Calculations.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace stromar {

namespace {
enum class Outline { Crown, Envelope };

constexpr int kProfilePoints = 64;
constexpr int kEnvelopeShape = 8;

void set(CParams& params, const char* key, double value) {
    const ParamRef ref = *findParam(key);
    const double digits = std::pow(10, ref.info->decimals);
    ref.set(params, std::round(value * digits) / digits);
}

double crownBase(const CParams& params, double height) { return weberPenn(params).baseSize * height; }

/// Height of a share of the crown, 0 its bottom, 1 its top.
double crownHeight(const CParams& params, double height, double share) {
    return crownBase(params, height) + share * (1 - weberPenn(params).baseSize) * height;
}

double crownShare(const CParams& params, double height, double z) {
    const double high = (1 - weberPenn(params).baseSize) * height;
    return high > 0 ? std::clamp((z - crownBase(params, height)) / high, 0.0, 1.0) : 0;
}

double radiusAt(Outline outline, const CParams& params, double height, double share) {
    if (outline == Outline::Envelope)
        return weberPenn(params).pruneWidth * height * shapeRatio(kEnvelopeShape, 1 - share, weberPenn(params));
    const double longest = weberPenn(params).level[0].length * weberPenn(params).level[1].length * height;
    return longest * shapeRatio(weberPenn(params).shape, 1 - share, weberPenn(params));
}

glm::dvec2 placeAt(Outline outline, const CParams& params, double height, double share) {
    return {radiusAt(outline, params, height, share), crownHeight(params, height, share)};
}

/// The power that makes the envelope as wide as this half-way between its end and its widest place.
double powerFor(const CParams& params, double height, double radius) {
    const double widest = weberPenn(params).pruneWidth * height;
    const double share = widest > 0 ? std::clamp(radius / widest, 0.001, 0.999) : 0.5;
    return std::log(share) / std::log(0.5);
}

template <Outline outline>
std::vector<glm::dvec2> profileOf(const CParams& params, double height) {
    std::vector<glm::dvec2> profile;
    for (int i = 0; i <= kProfilePoints; ++i) {
        const double share = double(i) / kProfilePoints;
        profile.push_back(placeAt(outline, params, height, share * share * (3 - 2 * share))); // dense at both ends
    }
    return profile;
}

bool isOfCrown(const ParamRef& ref) {
    return std::ranges::any_of(std::array{"Shape", "BaseSize", "1Length"}, [&](const char* key) { return *findParam(key) == ref; });
}

/// A handle of the envelope is dragged: it shall count.
void usePruning(CParams& params) {
    if (weberPenn(params).pruneRatio == 0 && weberPenn(params).shape != kEnvelopeShape) set(params, "PruneRatio", 1);
}

constexpr GuideHandle kEnvelopeHandles[] = {
    {N_("Width and widest place"),
     [](const CParams& p, double scale) { return placeAt(Outline::Envelope, p, scale, weberPenn(p).pruneWidthPeak); },
     [](CParams& p, double scale, const glm::dvec2& to) {
         usePruning(p);
         if (weberPenn(p).pruneRatio > 0) set(p, "PruneWidth", to.x / scale); // a crown of the envelope's shape has its own width
         set(p, "PruneWidthPeak", std::clamp(crownShare(p, scale, to.y), 0.01, 0.99));
     }},
    {N_("Curve above"),
     [](const CParams& p, double scale) {
         return placeAt(Outline::Envelope, p, scale, (1 + weberPenn(p).pruneWidthPeak) / 2);
     },
     [](CParams& p, double scale, const glm::dvec2& to) {
         set(p, "PrunePowerHigh", powerFor(p, scale, to.x));
         usePruning(p);
     }},
    {N_("Curve below"),
     [](const CParams& p, double scale) { return placeAt(Outline::Envelope, p, scale, weberPenn(p).pruneWidthPeak / 2); },
     [](CParams& p, double scale, const glm::dvec2& to) {
         set(p, "PrunePowerLow", powerFor(p, scale, to.x));
         usePruning(p);
     }},
    {N_("Bare trunk"),
     [](const CParams& p, double scale) { return glm::dvec2(0, crownBase(p, scale)); },
     [](CParams& p, double scale, const glm::dvec2& to) { set(p, "BaseSize", std::min(to.y / scale, 0.99)); }},
};

constexpr GuideHandle kCrownHandles[] = {
    {N_("Bare trunk"), [](const CParams& p, double scale) { return glm::dvec2(0, crownBase(p, scale)); },
     [](CParams& p, double scale, const glm::dvec2& to) { set(p, "BaseSize", std::min(to.y / scale, 0.99)); }},
    {N_("Length of the branches"),
     [](const CParams& p, double scale) { return placeAt(Outline::Crown, p, scale, 0.35); },
     [](CParams& p, double scale, const glm::dvec2& to) {
         const double relative = shapeRatio(weberPenn(p).shape, 0.65, weberPenn(p)) * weberPenn(p).level[0].length * scale;
         if (relative > 0) set(p, "1Length", to.x / relative);
     }},
};

constexpr Guide kGuides[] = {
    {&profileOf<Outline::Envelope>, kEnvelopeHandles, [](const ParamRef& ref) { return ref.group() == Group::Pruning; }, Group::Pruning},
    {&profileOf<Outline::Crown>, kCrownHandles, &isOfCrown},
};

constexpr std::string_view kPlant = "Levels=2 Scale=8 Shape=1 BaseSize=0.2 Ratio=0.025 RatioPower=1.2 Flare=0.3 "
                                    "0CurveRes=6 1Branches=14 1Length=0.32 1DownAngle=55 1Rotate=140 1CurveRes=5 "
                                    "2Branches=8 2Length=0.35 2DownAngle=45 MinRadius=0.008";

/// What the pictures of a group of parameters have in common, on top of kPlant.
std::string_view settingsOf(const ParamRef& ref) {
    if (ref.info->perLevel() && ref.level == 0) return "Levels=1 0CurveRes=8 Ratio=0.035";
    if (ref.group() == Group::Tree) return "Levels=3 1Branches=18";
    if (ref.group() == Group::Leaves)
        return "Scale=1.6 BaseSize=0 Levels=2 1Branches=3 1Length=0.7 1DownAngle=35 Leaves=12 LeafScale=0.2 LeafForm=1 "
               "2DownAngle=50 2Rotate=140 LeafStalk=0.15 MinRadius=0.002 LeafScaleX=0.6";
    if (ref.group() == Group::Pruning)
        return "Shape=3 1Branches=60 1Length=0.6 1DownAngle=70 BaseSize=0.15 PruneRatio=1 PruneWidth=0.3 "
               "PruneWidthPeak=0.4 MinRadius=0.02";
    return "";
}
} // namespace

std::span<const Guide> weberPennGuides() { return kGuides; }

DemoPlant weberPennDemonstration() { return {kPlant, &settingsOf}; }

int weberPennGenerationOf(const ParamRef& ref, const CParams& params) {
    if (ref.group() == Group::Leaves) return TreeMethod::kLeaves;
    if (ref.group() == Group::Trunk) return 0;
    if (ref.group() != Group::Branches) return TreeMethod::kNone;
    if (ref.level < weberPenn(params).levels) return ref.level;
    return ref.info->placesLeaves && ref.level == weberPenn(params).levels ? TreeMethod::kLeaves : TreeMethod::kNone;
}

} // namespace stromar
