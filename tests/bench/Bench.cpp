// How fast trees grow, are meshed, change under an edit and are written. Real time: the work runs on several threads.
#include "stromar/tree/weberpenn/WeberPennBuilder.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/app/Export.h"
#include "stromar/app/Formats.h"
#include "stromar/model/MeshValues.h"
#include "stromar/params/TreeFile.h"
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
    for (const auto& entry : fs::directory_iterator(STROMAR_SOURCE "/presets"))
        all.push_back({entry.path().stem().string(), CTreeFile::read(entry.path()).params()});
    std::ranges::sort(all, {}, &Preset::name);
    return all;
}

Counter perSecond(double count) { return Counter(count, Counter::kIsIterationInvariantRate); }

void growStructure(State& state, const CParams& params) {
    std::size_t stems = 0;
    for (auto _ : state) stems = growTree(CWeberPennBuilder(), params, CProgress())->stemCount();
    state.counters["stems/s"] = perSecond(double(stems));
}

/// Structure is made before; what is timed is rings, points and triangles.
void buildMeshes(State& state, const CParams& params, const Detail& detail) {
    const CProgress progress;
    const CWeberPennBuilder builder;
    const auto tree = builder.build(params, nullptr, 0, progress);
    const MeshParams mesh = meshParamsOf(params);
    const auto plans = meshAllStems(*tree, mesh, detail, progress);
    const auto none = std::make_shared<const COrgans>();
    const CTree leafy = tree->withOrgans(
        {builder.growOrgans(params, *tree, Organ::Leaf, demandOf(detail, plansOf(plans)), progress), none, none});
    std::size_t vertices = 0;
    for (auto _ : state) {
        vertices = 0;
        const std::vector<StemMesh> all = meshAllStems(*tree, mesh, detail, progress);
        for (const StemMesh& stems : all) vertices += stems.mesh->vertexCount();
        vertices += meshOfOrgans(leafy, Organ::Leaf, plansOf(all), mesh, detail, progress)->vertexCount();
    }
    state.counters["vertices/s"] = perSecond(double(vertices));
}

/// What one step of a slider costs: the level's own generation and all deeper ones are made again.
void editLevel(State& state, const CParams& params, std::size_t level) {
    CTreeCreator creator;
    CParams edited = params;
    // The trunk has no down angle; its curve stands for an edit of everything.
    Degrees& angle = level == 0 ? weberPenn(edited).level[0].curve : weberPenn(edited).level[level].downAngle;
    const Degrees before = angle;
    creator.create(edited, detailOf(Model::Simple), CProgress());
    std::size_t vertices = 0;
    for (auto _ : state) {
        angle = angle == before ? Degrees(before.value + 1) : before;
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
    for (std::size_t level = 0; level < std::min<std::size_t>(4, static_cast<std::size_t>(weberPenn(params).levels) + 1);
         ++level)
        add("Edit/" + preset.name + "/level" + std::to_string(level),
            [=](State& state) { editLevel(state, params, level); });
}

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
    if (!presets.empty()) addExports(presets.front().params);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
