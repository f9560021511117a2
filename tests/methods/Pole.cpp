// All there is to a way to grow: a class, a table and a row.
#include "Pole.h"
#include "stromar/util/Random.h"
#include <cmath>

namespace stromar::test {

namespace {
constexpr std::string_view kTops[] = {"pointed", "blunt"};
constexpr std::string_view kSwitch[] = {"off", "on"};
constexpr Group kPole{"Pole"};
constexpr Group kGroups[] = {Group::Tree, kPole, Group::Trunk, Group::Leaves, Group::Blossom, Group::Textures};
constexpr Invalidation kAll{Stage::Structure, 0};

constexpr ParamInfo kRows[] = {
    {.key = "PoleHeight", .label = "Height", .group = kPole, .section = "Size", .unit = Unit::Metre,
     .field = field<&PoleParams::height>, .range = {0.1, 100}, .useful = {1, 20}, .step = 0.5, .decimals = 2,
     .defaults = {6}, .invalidates = kAll, .help = "How tall the pole is.", .demo = {.values = {2, 4, 8}}},
    {.key = "PoleLean", .label = "Lean", .group = kPole, .section = "Size", .unit = Unit::Degree,
     .field = field<&PoleParams::lean>, .range = {0, 90}, .useful = {0, 45}, .step = 1, .decimals = 1, .defaults = {5},
     .invalidates = kAll, .help = "How far it leans."},
    {.key = "PolePieces", .label = "Pieces", .group = kPole, .section = "Size", .field = field<&PoleParams::pieces>,
     .range = {1, 50}, .useful = {1, 12}, .step = 1, .defaults = {5}, .invalidates = kAll, .help = "Of how many pieces."},
    {.key = "PoleTop", .label = "Top", .group = kPole, .section = "Size", .field = field<&PoleParams::top>,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {0}, .invalidates = kAll, .help = "Its end.", .words = kTops},
    {.key = "PoleBent", .label = "Bent", .group = kPole, .section = "Size", .field = field<&PoleParams::bent>,
     .range = {0, 1}, .useful = {0, 1}, .step = 1, .defaults = {1}, .invalidates = kAll, .help = "Whether it bends.",
     .words = kSwitch},
    {.key = "PoleThickness", .label = "Thickness", .group = kPole, .section = "Form", .unit = Unit::Metre,
     .field = field<&PoleParams::thickness>, .range = {0, 1}, .useful = {0, 0.5}, .step = 0.01, .decimals = 3,
     .defaultText = "0:0.3, 5:0.05", .invalidates = kAll, .help = "Its radius by the piece.", .over = {0, 50},
     .shownOver = {0, 6}, .overStep = 1, .overLabel = "piece"},
    {.key = "PolePlan", .label = "Plan", .group = kPole, .section = "Form", .field = field<&PoleParams::plan>,
     .defaultText = "plain", .invalidates = kAll, .help = "A leaf for each letter L.", .block = true},
};

constexpr CommonDefault kDefaults[] = {{"Flare", 0}};

constexpr ParamBlock kBlock{
    .method = "pole",
    .label = "Pole",
    .help = "A pole with leaves.",
    .rows = kRows,
    .groups = kGroups,
    .make = &makeBlock<PoleParams>,
    .equal = &equalBlocks<PoleParams>,
    .commonDefaults = kDefaults,
};

const PoleParams& pole(const CParams& params) { return params.as<PoleParams>(); }

SizeBound poleBound(const CParams& params, const CProgress&) {
    GenerationBound trunk;
    trunk.stems = 1;
    trunk.segments = trunk.along = pole(params).pieces;
    trunk.turn = pole(params).bent ? 10 : 0;
    SizeBound bound;
    bound.generations = {trunk};
    bound.organs = {double(pole(params).plan.size()), 0, 0};
    bound.twigs = {1, bound.organs[0], pole(params).height, params.common.leafScale, {}, 0};
    return bound;
}
} // namespace

std::shared_ptr<const CTree> CPoleBuilder::build(const CParams& params, const CTree*, int, const CProgress& progress) const {
    progress.poll();
    const PoleParams& values = pole(params);
    auto trunk = std::make_shared<CGeneration>();
    CStem stem{};
    stem.id = 1;
    stem.length = values.height;
    stem.radius = values.thickness.at(0);
    stem.parent = -1;
    stem.pathCount = 1;
    stem.segmentCount = static_cast<std::uint32_t>(values.pieces);
    trunk->paths.push_back({0, 0, stem.segmentCount, 0, -1});
    Frame frame = rotatedX(Frame(1.0), values.lean.radians());
    glm::dvec3 at(0);
    double start = 0, shares = 0;
    for (int i = 0; i < values.pieces; ++i) shares += i + 1;
    for (int i = 0; i < values.pieces; ++i) { // each longer than the one below
        CSegment segment{};
        segment.position = at;
        segment.frame = frame;
        segment.start = start;
        segment.length = values.height * (i + 1) / shares;
        segment.radiusBase = values.thickness.at(i);
        segment.radiusEnd = values.top == 0 && i + 1 == values.pieces ? 0 : values.thickness.at(i + 1);
        trunk->segments.push_back(segment);
        at = segment.axisPoint(1);
        start = segment.end();
        if (values.bent) frame = rotatedX(frame, 0.1);
    }
    trunk->stems.push_back(stem);
    return std::make_shared<const CTree>(values.height, std::vector<std::shared_ptr<const CGeneration>>{trunk},
                                         BaseForm{.flare = params.common.flare});
}

std::shared_ptr<const COrgans> CPoleBuilder::growOrgans(const CParams& params, const CTree& tree, Organ organ,
                                                        const OrganDemand&, const CProgress& progress) const {
    progress.poll();
    const PoleParams& values = pole(params);
    if (organ != Organ::Leaf) return std::make_shared<const COrgans>();
    LeafArray leaves;
    const std::vector<CSegment>& segments = tree.generation(0).segments;
    for (std::size_t i = 0; i < values.plan.size(); ++i)
        if (values.plan[i] == 'L') {
            const CSegment& segment = segments[i % segments.size()];
            leaves.push_back({glm::vec3(segment.axisPoint(0.5)), glm::vec3(segment.frame[0]), glm::vec3(segment.frame[1]),
                              static_cast<float>(params.common.leafScale),
                              static_cast<float>(params.common.leafScale * params.common.leafScaleX), 0, 0, 0});
        }
    return allOrgans(std::move(leaves), tree.generations());
}

const TreeMethod& poleMethod() {
    static const TreeMethod& row = [] () -> const TreeMethod& {
        registerMethod({.block = &kBlock,
                        .makeBuilder = [](bool) -> std::unique_ptr<ITreeBuilder> { return std::make_unique<CPoleBuilder>(); },
                        .bound = &poleBound});
        return treeMethods().back();
    }();
    return row;
}

} // namespace stromar::test
