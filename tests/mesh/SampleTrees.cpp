#include "Checkout.h"
#include "mesh/SampleTrees.h"
#include "stromar/app/Methods.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/params/TreeFile.h"
#include <algorithm>
#include <filesystem>
#include <random>
#include <stdexcept>

namespace stromar::test {

namespace {
std::vector<Sample> readPresets() {
    std::vector<Sample> all;
    for (const auto& entry : std::filesystem::directory_iterator(inSource("presets")))
        if (entry.path().extension() == ".tree")
            all.push_back({entry.path().stem().string(), CTreeFile::read(entry.path()).params()});
    std::ranges::sort(all, {}, &Sample::name);
    if (all.size() < 4) throw std::runtime_error("presets are missing");
    return all;
}

/// std::uniform_real_distribution differs between libraries; this does not.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

double drawn(const ParamRef& ref, std::mt19937_64& random) {
    const Range& range = ref.info->useful;
    const double kind = uniform(random), place = uniform(random);
    if (kind < 0.1) return range.min;
    if (kind < 0.2) return range.max;
    if (kind < 0.45) return ref.info->defaults[static_cast<std::size_t>(ref.info->perLevel() ? ref.level : 0)];
    return range.min + place * (range.max - range.min);
}

void cap(CParams& params, const Caps& caps) {
    for (std::size_t i = 0; i < weberPenn(params).level.size(); ++i) {
        LevelParams& level = weberPenn(params).level[i];
        level.branches = std::min(level.branches, caps.branches[i]);
        level.segSplits = std::min(level.segSplits, caps.segSplits);
        level.curveRes = std::min(level.curveRes, caps.curveRes);
    }
    weberPenn(params).leaves = std::clamp(weberPenn(params).leaves, -caps.leaves, caps.leaves);
    weberPenn(params).levels = std::min(weberPenn(params).levels, caps.levels);
    params.common.blossoms = std::min(params.common.blossoms, caps.leaves);
    params.common.fruits = std::min(params.common.fruits, caps.leaves);
    weberPenn(params).trunks = std::min(weberPenn(params).trunks, 3);
}

/// What the useful ranges leave out or seldom hit.
void makeExtreme(CParams& params, std::uint64_t number) {
    WeberPennParams& g = weberPenn(params);
    if (number % 6 == 1) g.scale = 0.01;
    if (number % 6 == 2) g.scale = 1000;
    if (number % 5 == 1) params.common.minRadius = 0;
    if (number % 7 == 1) params.common.minRadius = 1;
    if (number % 4 == 1) params.common.lobeDepth = 1;
    if (number % 4 == 1) params.common.lobes = std::max(params.common.lobes, 1);
    if (number % 8 == 3) params.common.flare = -1;
    weberPenn(params).level[number % 4].taper = 0.25 * static_cast<double>(number % 13);
    if (number % 3 == 0) weberPenn(params).level[number / 3 % 4].curveV = -40;
}
/// Values that nothing of the shape hangs on stay as they are.
void drawShape(CParams& params, std::mt19937_64& random) {
    for (const ParamRef& ref : numberParams())
        if (ref.info->invalidates.stage != Stage::Material) ref.set(params, drawn(ref, random));
}
} // namespace

const std::vector<Sample>& presets() {
    static const std::vector<Sample> all = readPresets();
    return all;
}

std::vector<std::string> presetsWithout(const std::vector<std::string>& names) {
    std::vector<std::string> others;
    for (const Sample& own : presets())
        if (std::ranges::find(names, own.name) == names.end()) others.push_back(own.name);
    return others;
}

const std::vector<Sample>& weberPennPresets() {
    static const std::vector<Sample> some = [] {
        std::vector<Sample> found = presets();
        std::erase_if(found, [](const Sample& sample) { return &sample.params.block() != &weberPennBlock(); });
        return found;
    }();
    return some;
}

CParams preset(const std::string& name) {
    const auto found = std::ranges::find(presets(), name, &Sample::name);
    if (found == presets().end()) throw std::runtime_error("no preset " + name);
    return found->params;
}

CParams randomParams(std::uint64_t number, const Caps& caps) {
    std::mt19937_64 random(number);
    CParams params;
    drawShape(params, random);
    makeExtreme(params, number);
    cap(params, caps);
    return params;
}

CParams gentleParams(std::uint64_t number, const Caps& caps) {
    std::mt19937_64 random(1000 + number);
    CParams params;
    drawShape(params, random);
    cap(params, caps);
    WeberPennParams& g = weberPenn(params);
    g.scale = std::max(g.scale, 2.0);
    g.ratio = std::min(g.ratio, 0.04);
    params.common.minRadius = std::min(params.common.minRadius, 0.001);
    g.ratioPower = std::max(g.ratioPower, 0.8);
    g.attractionUp = std::clamp(g.attractionUp, -2.0, 2.0);
    g.trunkScale = std::min(g.trunkScale, 1.2);
    for (LevelParams& level : weberPenn(params).level) {
        level.curve = std::clamp(level.curve.value, -90.0, 90.0);
        level.curveBack = std::clamp(level.curveBack.value, -60.0, 60.0);
        level.curveV = std::min(level.curveV.value, 60.0);
        level.splitAngle = std::min(level.splitAngle.value, 35.0);
        level.splitAngleV = std::min(level.splitAngleV.value, 10.0);
        level.taper = std::min(level.taper, 2.0);
        level.curveRes = std::max(level.curveRes, 3);
        level.length = std::max(level.length, 0.2);
    }
    return params;
}

CParams plainTrunk() {
    CParams params;
    weberPenn(params).levels = 1;
    params.common.flare = 0;
    params.common.lobes = 0;
    params.common.minRadius = 0;
    weberPenn(params).level[0].taper = 0;
    return params;
}

std::shared_ptr<const CTree> grow(const CParams& params, int threads) {
    return growTree(*methodOf(params).makeBuilder(true), params, CProgress(threads));
}

std::shared_ptr<const CMesh> organsOf(const CTree& tree, const CParams& params, Organ organ,
                                      const std::vector<StemMesh>& stems, const Detail& detail) {
    const CProgress progress(2);
    OrganArrays organs;
    organs.fill(std::make_shared<const COrgans>());
    organs[static_cast<std::size_t>(organ)] =
        methodOf(params).makeBuilder(true)->growOrgans(params, tree, organ, demandOf(detail, plansOf(stems)), progress);
    return meshOfOrgans(tree.withOrgans(organs), organ, plansOf(stems), meshParamsOf(params), detail, progress)[0]
        ->expanded(progress);
}

std::vector<std::shared_ptr<const CMesh>> meshesOf(const CTree& tree, const CParams& params, const Detail& detail,
                                                   int threads) {
    const CProgress progress(threads);
    std::vector<std::shared_ptr<const CMesh>> meshes;
    const std::vector<StemMesh> all = meshAllStems(tree, meshParamsOf(params), detail, progress);
    for (const StemMesh& stems : all) meshes.push_back(stems.mesh);
    meshes.push_back(organsOf(tree, params, Organ::Leaf, all, detail));
    return meshes;
}

} // namespace stromar::test
