// How fast trees grow, are meshed, change under an edit and are written. Real time: the work runs on several threads.
#include "Checkout.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "stromar/params/methods/strands/StrandsParams.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/app/Export.h"
#include "stromar/app/Formats.h"
#include "stromar/app/Methods.h"
#include "stromar/tree/lsystem/LSystemBuilder.h"
#include "stromar/params/ParamText.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/model/MeshValues.h"
#include "stromar/model/ModelSway.h"
#include "stromar/params/TreeFile.h"
#ifdef STROMAR_WITH_OSG
#include "stromar/app/Pictures.h"
#include "stromar/scene/Headless.h"
#endif
#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace {
using namespace stromar;
namespace fs = std::filesystem;
using benchmark::Counter;
using benchmark::State;

struct Preset {
    std::string name;
    CParams params;
};

std::vector<Preset> readPresets() {
    std::vector<Preset> all;
    for (const auto& entry : fs::directory_iterator(test::inSource("presets")))
        all.push_back({entry.path().stem().string(), CTreeFile::read(entry.path()).params()});
    std::ranges::sort(all, {}, &Preset::name);
    return all;
}

Counter perSecond(double count) { return Counter(count, Counter::kIsIterationInvariantRate); }

void growStructure(State& state, const CParams& params) {
    std::size_t stems = 0;
    for (auto _ : state) stems = growTree(*methodOf(params).makeBuilder(true), params, CProgress())->stemCount();
    state.counters["stems/s"] = perSecond(double(stems));
}

/// Structure is made before; what is timed is rings, points and triangles.
void buildMeshes(State& state, const CParams& params, const Detail& detail) {
    const CProgress progress;
    const auto builder = methodOf(params).makeBuilder(true);
    const auto tree = builder->build(params, nullptr, 0, progress);
    const MeshParams mesh = meshParamsOf(params);
    const auto plans = meshAllStems(*tree, mesh, detail, progress);
    const auto none = std::make_shared<const COrgans>();
    const CTree leafy = tree->withOrgans(
        {builder->growOrgans(params, *tree, Organ::Leaf, demandOf(detail, plansOf(plans)), progress), none, none});
    std::size_t vertices = 0;
    for (auto _ : state) {
        vertices = 0;
        const std::vector<StemMesh> all = meshAllStems(*tree, mesh, detail, progress);
        for (const StemMesh& stems : all) vertices += stems.mesh->vertexCount();
        vertices += meshOfOrgans(leafy, Organ::Leaf, plansOf(all), mesh, detail, progress)[0]->vertexCount();
    }
    state.counters["vertices/s"] = perSecond(double(vertices));
}

/// The wood of a file in one piece, beside what buildMeshes() takes.
void joinWood(State& state, const CParams& params) {
    const auto model = CTreeCreator().create(params, detailOf(Model::Full), CProgress(), CTreeCreator::Plans::Keep);
    for (auto _ : state) benchmark::DoNotOptimize(joined(model, CProgress()));
    state.counters["stems/s"] = perSecond(double(model->tree->stemCount()));
}

/// What one step of a slider costs: what the value does not touch is kept.
void editValue(State& state, const CParams& params, const ParamRef& ref) {
    CTreeCreator creator;
    CParams edited = params;
    const double before = ref.get(edited);
    creator.create(edited, detailOf(Model::Simple), CProgress());
    std::size_t vertices = 0;
    for (auto _ : state) {
        ref.set(edited, ref.get(edited) == before ? before + ref.info->step : before);
        vertices = creator.create(edited, detailOf(Model::Simple), CProgress())->vertexCount();
    }
    state.counters["vertices/s"] = perSecond(double(vertices));
}

/// Bytes of every array are read and written once: what memory allows.
void copyMeshes(State& state, const TreeModel& model) {
    std::size_t bytes = 0;
    for (const auto& mesh : model.meshes()) bytes += mesh->bytes();
    std::vector<char> source(bytes, 1), target(bytes);
    for (auto _ : state) {
        std::memcpy(target.data(), source.data(), bytes);
        benchmark::DoNotOptimize(target.data());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

void exportTo(State& state, const TreeModel& model, const std::string& ending) {
    std::string pattern = (fs::temp_directory_path() / "stromar-bench-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) return state.SkipWithError("no temporary folder");
    const fs::path folder = pattern, path = folder / ("tree" + ending);
    for (auto _ : state) exportModel(model, {}, path, CProgress());
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(fs::file_size(path)));
    state.counters["vertices/s"] = perSecond(double(model.vertexCount()));
    fs::remove_all(folder);
}

template <typename Function>
void add(const std::string& name, Function&& function) {
    benchmark::RegisterBenchmark(name.c_str(), std::forward<Function>(function))
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
}

void addEdit(const Preset& preset, const std::string& key, const std::string& name) {
    const ParamRef ref = *findParam(key, preset.params.block());
    add("Edit/" + preset.name + "/" + name, [=, params = preset.params](State& state) { editValue(state, params, ref); });
}

void addPreset(const Preset& preset) {
    const CParams params = preset.params;
    add("Structure/" + preset.name, [=](State& state) { growStructure(state, params); });
    for (const Detail& detail : detailTable()) {
        const std::string kind = detail.model == Model::Simple ? "Simple" : "Lod" + std::to_string(detail.lod);
        add("Mesh" + kind + "/" + preset.name, [=, &detail](State& state) { buildMeshes(state, params, detail); });
        if (detail.lod == 0)
            add("MemCopy" + kind + "/" + preset.name,
                [=, &detail](State& state) { copyMeshes(state, *CTreeCreator().create(params, detail, CProgress())); });
    }
    add("Join/" + preset.name, [=](State& state) { joinWood(state, params); });
    if (&params.block() == &strandsBlock()) return addEdit(preset, "TrunkHeight", "curve");
    if (&params.block() == &lsystemBlock()) return addEdit(preset, "LengthUnit", "word");
    const int levels = std::min(kParamLevels, weberPenn(params).levels + 1);
    // The trunk has no down angle; its curve stands for an edit of everything.
    for (int level = 0; level < levels; ++level)
        addEdit(preset, level == 0 ? "0Curve" : std::to_string(level) + "DownAngle", "level" + std::to_string(level));
}

/// Of a grammar that doubles: ten million modules.
void derive(State& state, int threads) {
    const Grammar grammar = parseGrammar("axiom: A(1,1)\nA(l,w) -> !(w)F(l)[+(30)A(l*0.8,w*0.7)]/(137)A(l*0.9,w*0.7)");
    const CRewriter rewriter(grammar, 1);
    std::size_t modules = 0;
    for (auto _ : state) modules = rewriter.derive(20, CProgress(threads)).size();
    state.counters["modules/s"] = perSecond(double(modules));
}

CParams withStrands(CParams params, int number) {
    strands(params).strands = number;
    return params;
}

void addStrands(const CParams& params) {
    add("Structure/20000 strands", [=](State& state) { growStructure(state, withStrands(params, 20000)); });
    addEdit({"2000 strands", withStrands(params, 2000)}, "TrunkHeight", "curve");
}

/// A pose of the wind, one frame's work of the processor; and what a model needs once to sway.
void poseInWind(State& state, const CParams& params) {
    const auto model = CTreeCreator().create(params, detailOf(Model::Simple), CProgress());
    const auto sway = swayOf(model, nullptr, CProgress());
    WindPose pose;
    double seconds = 0;
    for (auto _ : state) sway->table->pose({.strength = 0.8, .loop = 64}, seconds += 0.04, pose, CProgress());
    state.counters["stems"] = double(sway->table->stems().size());
    state.counters["nodes/s"] = perSecond(double(sway->table->nodeCount()));
}

void hangInWind(State& state, const CParams& params) {
    const auto model = CTreeCreator().create(params, detailOf(Model::Full), CProgress());
    for (auto _ : state) benchmark::DoNotOptimize(swayOf(model, nullptr, CProgress()));
}

/// A life in so many files, or one file of the grown tree.
void exportLife(State& state, const CParams& params, int frames) {
    std::string pattern = (fs::temp_directory_path() / "stromar-bench-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) return state.SkipWithError("no temporary folder");
    const fs::path folder = pattern;
    const Motion motion{.wind = {}, .frames = frames};
    for (auto _ : state)
        exportFrames(params, {}, motion, 1, true, {}, {}, folder / "x.glb", [](const fs::path&) {}, CProgress());
    fs::remove_all(folder);
}

void addMotion(const std::vector<Preset>& presets) {
    for (const Preset& preset : presets) {
        if (preset.name != "weeping_willow" && preset.name != "quaking_aspen") continue;
        add("Wind/Pose/" + preset.name, [=, params = preset.params](State& state) { poseInWind(state, params); });
        add("Wind/Hang/" + preset.name, [=, params = preset.params](State& state) { hangInWind(state, params); });
        if (preset.name != "quaking_aspen") continue;
        for (const int frames : {1, 100})
            add("Growth/Export/" + std::to_string(frames), [=, params = preset.params](State& state) { exportLife(state, params, frames); });
    }
}

#ifdef STROMAR_WITH_OSG
/// A view that is turned, without a window: on the graphics card, where there is one. Shadows are kept, as the window keeps them.
void turnView(State& state, const CParams& params, int width, int height) {
    constexpr int kFrames = 30, kSamples = 4;
    const CProgress progress;
    const auto model = CTreeCreator().create(params, detailOf(Model::Full), progress);
    makePictures(*model, {}, progress);
    CViewScene scene;
    const std::vector<ViewPart> parts = viewPartsOf(*model, {}, progress);
    scene.show(parts);
    for (const ViewPart& part : parts) scene.setSurface(part.surface, *readSurface(part.surface, textureOf(*model, part.surface, {}).string()));
    CHeadlessPainter painter(scene, kSamples);
    std::vector<CCamera> cameras(kFrames);
    for (int i = 0; i < kFrames; ++i) {
        cameras[static_cast<std::size_t>(i)].frame(scene.bounds(), double(width) / height);
        cameras[static_cast<std::size_t>(i)].turn(360.0 * i / kFrames, 0);
    }
    painter.drawAll(std::span(cameras).first(1), width, height); // textures and meshes go to the card
    for (auto _ : state) painter.drawAll(cameras, width, height);
    state.counters["frames/s"] = perSecond(kFrames);
}

void addFrames(const std::vector<Preset>& presets) {
    for (const Preset& preset : presets) {
        if (preset.name != "weeping_willow" && preset.name != "quaking_aspen" && preset.name != "english_oak" && preset.name != "norway_spruce") continue;
        for (const auto& [width, height] : {std::pair(800, 700), std::pair(1920, 1080), std::pair(3840, 2160)})
            add("Frames/" + preset.name + "/" + std::to_string(width) + "x" + std::to_string(height),
                [=, params = preset.params](State& state) { turnView(state, params, width, height); });
    }
}
#else
void addFrames(const std::vector<Preset>&) {}
#endif

void addExports(const CParams& params) {
    for (const Format& format : formatTable()) {
        const std::string ending(format.ending);
        add("Export/" + ending.substr(1), [=](State& state) {
            exportTo(state, *CTreeCreator().create(params, detailOf(Model::Full), CProgress()), ending);
        });
    }
}
} // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    const std::vector<Preset> presets = readPresets();
    for (const Preset& preset : presets) addPreset(preset);
    if (const auto apple = std::ranges::find(presets, "apple", &Preset::name); apple != presets.end()) addExports(apple->params);
    addStrands(CParams(strandsBlock()));
    addMotion(presets);
    addFrames(presets);
    for (const int threads : {1, 2}) add("Derive/" + std::to_string(threads), [=](State& state) { derive(state, threads); });
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
