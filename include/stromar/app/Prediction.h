#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/twig/Twig.h"
#include "stromar/params/ParamTable.h"
#include "stromar/util/Error.h"
#include "stromar/util/Progress.h"
#include <optional>
#include <utility>

namespace stromar {

/// How large a tree can become; whole numbers, but possibly beyond any integer.
struct Prediction {
    double stems, segments, organs, leaves, vertices;
    double bytes; ///< of all that is held at once: structure, plans, meshes and what is drawn or written of them
};

/// Upper bounds of what a tree of these parameters may have, over all seeds. Most methods tell in microseconds; that of an
/// L-system derives its word, and throws as its builder does.
/// Throws CCancelled.
Prediction predictSize(const CParams& params, const Detail& detail, const CProgress& progress = CProgress());

/// What a tree may take.
struct SizeLimits {
    static constexpr double kMaxVertices = 20e6;

    double vertices = kMaxVertices;
    double bytes = defaultMemory();

    /// Half of what this machine has free now.
    static double defaultMemory();
    static SizeLimits none();
    bool allow(const Prediction& size) const { return size.vertices <= vertices && size.bytes <= bytes; }
    bool operator==(const SizeLimits&) const = default;
};

/// "this tree would have up to 3 stems, … and take up to 5 MB; the limit is …": with both numbers of what is too large.
std::string refusalText(const Prediction& size, const SizeLimits& limits);

/// A tree is not grown because of its size.
class CTooLarge : public CError {
public:
    CTooLarge(const Prediction& size, const SizeLimits& limits) : CError(refusalText(size, limits)), m_size(size) {}
    const Prediction& size() const { return m_size; }

private:
    Prediction m_size;
};
/// Throws CTooLarge.
void refuseTooLarge(const CParams& params, const Detail& detail, const SizeLimits& limits, const CProgress& progress);

/// Whether cards may stand for the last stems: the level of detail has some, they gain something, and their picture can
/// be made.
bool mayShowCards(const CParams& params, const Detail& detail, const CProgress& progress);

/// The value of `ref` nearest to its own at which the tree is predicted to be within the limits, found between `fits`
/// and its own. Whole for integers. `fits` itself when not even that is small enough.
double nearestThatFits(const CParams& params, const ParamRef& ref, double fits, const Detail& detail,
                       const SizeLimits& limits);

/// The one value of a tree that has to change least, in proportion, for it to be within the limits; nothing where no value alone
/// does. Some hundred predictions. Throws CCancelled.
std::optional<std::pair<ParamRef, double>> leastChangeThatFits(const CParams& params, const Detail& detail, const SizeLimits& limits,
                                                               const CProgress& progress);

} // namespace stromar
