#pragma once
#include "stromar/app/Guides.h"
#include "stromar/app/TextLanguage.h"
#include "stromar/params/ParamTable.h"
#include "stromar/tree/SizeBound.h"
#include "stromar/tree/TreeBuilder.h"
#include <memory>
#include <span>
#include <vector>

namespace stromar {

/// The tree that help pictures change one value of, as `Key=value …`; `n` in a key stands for the level.
struct DemoPlant {
    std::string_view settings{};
    /// What the pictures of one value have besides.
    std::string_view (*settingsOf)(const ParamRef& ref) = nullptr;
};

/// A segment of a tree.
struct SegmentPlace {
    std::size_t generation, segment;
};

/// What a method knows of every segment besides its geometry.
struct SegmentQuantity {
    std::string_view name; ///< as `structure` writes it
    double (*of)(const CTree& tree, const SegmentPlace& place);
    std::string_view label{}; ///< in the window, marked for translation; empty: not there
    bool ofStem = false; ///< said of stems too: at their base
    bool count = false;  ///< a whole number as a rule
};

using CurvePlaces = std::vector<std::vector<double>>;

/// The x of a curve.
struct CurveAxis {
    std::string_view label; ///< marked for translation
    double step;            ///< to which its editor snaps; whole numbers are counted one by one
};

/// A way to grow trees: one row of the table of methods. Files, command line, window, prediction and manual take all
/// they need to know from here.
struct TreeMethod {
    const ParamBlock* block; ///< its word, label, help, table and groups
    /// `varied` false replaces every random number by its middle value.
    std::unique_ptr<ITreeBuilder> (*makeBuilder)(bool varied);
    /// Throws CCancelled where it takes long.
    SizeBound (*bound)(const CParams& params, const CProgress& progress);
    bool boundIsQuick = true; ///< false: not for the window's thread
    std::span<const Guide> guides{}; ///< drawn around the tree, with handles
    DemoPlant demonstration{};
    /// The generation of stems that a value is about, for the picture: kLeaves, kNoGeneration. Null: none.
    int (*generationOf)(const ParamRef& ref, const CParams& params) = nullptr;
    const TextLanguage* language = nullptr; ///< of its block text
    std::span<const SegmentQuantity> quantities{};
    /// Where every segment stands on a curve of the block: its x, by generation. Null: curves say nothing of segments.
    CurvePlaces (*curvePlaces)(const ParamInfo& curve, const CParams& params, const CTree& tree) = nullptr;
    /// What x of a curve is, where values decide it. Null: as its row says.
    CurveAxis (*curveAxis)(const ParamInfo& curve, const CParams& params) = nullptr;

    static constexpr int kLeaves = -1, kNone = -100;
};

/// All that are known, in the order of File ▸ New.
std::span<const TreeMethod> treeMethods();
const TreeMethod& methodOf(const CParams& params);
CurveAxis axisOf(const ParamInfo& curve, const CParams& params);
/// Adds one more; once, before threads start.
void registerMethod(const TreeMethod& method);

} // namespace stromar
