#include "stromar/app/TreeCreator.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Prediction.h"
#include "stromar/model/MeshValues.h"
#include "stromar/params/ParamTable.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <chrono>
#include <cmath>

namespace stromar {

namespace {
class CStopwatch {
public:
    /// Since the last call or the start.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - m_last).count();
        m_last = now;
        return ms;
    }

private:
    std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

bool meshIsStale(const CParams& made, const CParams& wanted, int generation) {
    const Invalidation invalid = invalidationOf(made, wanted);
    return invalid.stage <= Stage::Mesh && invalid.generation <= generation;
}

/// The mesh that was made before, if it still shows `source` with these values, else a new one.
template <typename Made, typename Drawn, typename Make>
std::shared_ptr<const CMesh> reuseOrMake(Made& made, int generation, const std::shared_ptr<const void>& source,
                                         const CParams& params, Drawn drawn, Make&& make) {
    if (!made.stems.mesh || made.source != source || made.drawn != drawn ||
        meshIsStale(made.params, params, generation)) {
        made = {}; // first the memory of the old mesh
        made = {source, make(), params, drawn};
    }
    return made.stems.mesh;
}
} // namespace

CTreeCreator::CTreeCreator(bool varied, const SizeLimits& limits)
    : m_varied(varied), m_limits(limits), m_made(detailTable().size()) {}

void CTreeCreator::forget() {
    m_tree.reset();
    m_made.assign(detailTable().size(), {});
}

std::shared_ptr<const TreeModel> CTreeCreator::create(const CParams& params, const Detail& detail,
                                                      const CProgress& progress) {
    refuseTooLarge(params, detail);
    auto model = std::make_shared<TreeModel>();
    CStopwatch watch;
    updateTree(params, progress);
    model->params = params;
    model->detail = &detail;
    model->tree = m_tree;
    model->milliseconds.structure = watch.lap();
    progress.report(0.5);

    const MeshParams mesh = meshParamsOf(params);
    if (mayShowCards(params, detail)) model->twig = typicalTwig(*m_tree, mesh, progress);
    MadeMeshes& made = m_made[static_cast<std::size_t>(&detail - detailTable().data())];
    const int generations = static_cast<int>(m_tree->generationCount());
    made.resize(m_tree->generationCount() + kOrgans.size() + 1);
    std::vector<const MeshPlan*> plans;
    for (int g = 0; g < generations; ++g) {
        const auto slot = static_cast<std::size_t>(g);
        const bool onCards = model->twig && slot == cardGeneration(*m_tree);
        const Drawn drawn = onCards ? Drawn::AsCards : isSparse(*m_tree, g, detail) ? Drawn::Part : Drawn::All;
        model->stems.push_back(reuseOrMake(made[slot], g, m_tree->generations()[slot], params, drawn, [&] {
            if (onCards) return emptyStemMesh(*m_tree, g);
            const StemMesh* parents = g > 0 ? &made[slot - 1].stems : nullptr;
            StemMesh stems{planRings(*m_tree, g, mesh, detail, parents, progress), nullptr};
            model->milliseconds.smooth += watch.lap();
            stems.mesh = meshOfStems(*m_tree, g, stems.plan, mesh, progress);
            return stems;
        }));
        plans.push_back(&made[slot].stems.plan);
        model->milliseconds.mesh += watch.lap();
        progress.report(0.5 + 0.4 * (g + 1) / generations);
    }
    for (const Organ organ : kOrgans) {
        const auto i = static_cast<std::size_t>(organ);
        const bool onCards = model->twig && organ == Organ::Leaf;
        model->organs[i] =
            reuseOrMake(made[m_tree->generationCount() + i], Invalidation::kLeaves, m_tree->shared(organ), params,
                        onCards ? Drawn::AsCards : Drawn::All, [&] {
                            return StemMesh{{}, meshOfOrgans(*m_tree, organ, plans, mesh, detail, progress,
                                                             onCards ? cardGeneration(*m_tree) : kNoGeneration)};
                        });
    }
    if (model->twig)
        model->cards = reuseOrMake(made.back(), Invalidation::kLeaves, m_tree->shared(Organ::Leaf), params,
                                   Drawn::AsCards, [&] {
                                       return StemMesh{{}, meshOfTwigs(*m_tree, *model->twig, mesh, detail, progress)};
                                   });
    else
        made.back() = {};
    model->milliseconds.mesh += watch.lap();
    model->milliseconds.total = model->milliseconds.structure + model->milliseconds.smooth + model->milliseconds.mesh;
    progress.report(1);
    return model;
}

void CTreeCreator::refuseTooLarge(const CParams& params, const Detail& detail) const {
    const Prediction size = predictSize(params, detail);
    if (!m_limits.allow(size)) throw CError(refusalText(size, m_limits));
}

void CTreeCreator::updateTree(const CParams& params, const CProgress& progress) {
    const Invalidation invalid = m_tree ? invalidationOf(m_treeParams, params) : Invalidation{Stage::Structure, 0};
    if (invalid.stage > Stage::Mesh) return;
    chooseBuilder(params);
    // The form of the trunks' bases is part of the tree, though no generation has to grow for it.
    const int first = invalid.stage == Stage::Structure ? invalid.generation : Invalidation::kNone;
    const auto tree = m_builder->build(params, m_tree.get(), first, progress);
    const bool same = m_tree && invalid.stage > Stage::Structure && tree->base() == m_tree->base();
    if (!same) m_tree = tree;
    m_treeParams = params;
    dropStaleMeshes();
}

/// Another method grows from nothing.
void CTreeCreator::chooseBuilder(const CParams& params) {
    if (m_builder && &m_treeParams.block() == &params.block()) return;
    m_builder = methodOf(params).makeBuilder(m_varied);
    m_tree.reset();
}

/// Frees the meshes of generations that are gone, so that no level of detail keeps an old tree in memory.
void CTreeCreator::dropStaleMeshes() {
    for (MadeMeshes& made : m_made)
        for (MadeMesh& mesh : made) {
            const auto& generations = m_tree->generations();
            const auto shown = [&](const auto& part) { return part == mesh.source; };
            const bool alive = std::ranges::any_of(generations, shown) ||
                               std::ranges::any_of(kOrgans, [&](Organ organ) { return shown(m_tree->shared(organ)); });
            if (!alive) mesh = {};
        }
}

} // namespace stromar
