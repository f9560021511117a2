#include "stromar/app/TreeCreator.h"
#include "stromar/app/Pictures.h"
#include "stromar/app/Prediction.h"
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
    const Obsolete obsolete = firstObsolete(made, wanted);
    return obsolete.stage <= Stage::Mesh && obsolete.generation <= generation;
}

/// The mesh that was made before, if it still shows `source` with these values, else a new one.
template <typename Made, typename Shown, typename Make>
std::shared_ptr<const CMesh> keptOr(Made& made, int generation, const std::shared_ptr<const void>& source,
                                    const CParams& params, Shown shown, Make&& make) {
    if (!made.stems.mesh || made.source != source || made.shown != shown ||
        meshIsStale(made.params, params, generation)) {
        made = {}; // first the memory of the old mesh
        made = {source, make(), params, shown};
    }
    return made.stems.mesh;
}

/// "950", "1.3 million": rounded up.
std::string countText(double count) {
    if (count < 1e6) return numberText(std::ceil(count));
    if (count < 1e12) return numberText(std::ceil(count / 1e5) / 10) + " million";
    return "more than a million million";
}
} // namespace

void TreeModel::visitMeshes(const MeshVisitor& visit) const {
    for (std::size_t g = 0; g < stems.size(); ++g)
        if (stems[g]->vertexCount() > 0) visit(stems[g], static_cast<int>(g));
    for (const Organ organ : kOrgans)
        if (const auto& mesh = organs[static_cast<std::size_t>(organ)]; mesh->vertexCount() > 0)
            visit(mesh, kLeaves - static_cast<int>(organ));
}

std::vector<std::shared_ptr<const CMesh>> TreeModel::meshes() const {
    std::vector<std::shared_ptr<const CMesh>> all;
    visitMeshes([&](const auto& mesh, int) { all.push_back(mesh); });
    return all;
}

std::size_t TreeModel::vertexCount() const {
    std::size_t count = 0;
    for (const auto& mesh : meshes()) count += mesh->vertexCount();
    return count;
}

std::size_t TreeModel::triangleCount() const {
    std::size_t count = 0;
    for (const auto& mesh : meshes()) count += mesh->triangleCount();
    return count;
}

CTreeCreator::CTreeCreator(bool varied, double mostVertices)
    : m_varied(varied), m_mostVertices(mostVertices), m_builder(std::make_unique<CWeberPennBuilder>(varied)),
      m_made(detailTable().size()) {}

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

    if (detail.twigPlanes > 0 && isBakeable(params)) model->twig = typicalTwig(*m_tree, params, progress);
    MadeMeshes& made = m_made[static_cast<std::size_t>(&detail - detailTable().data())];
    const int generations = static_cast<int>(m_tree->generationCount());
    made.resize(m_tree->generationCount() + kOrgans.size());
    for (int g = 0; g < generations; ++g) {
        const auto slot = static_cast<std::size_t>(g);
        const bool onCards = model->twig && g + 1 == generations;
        const Shown shown = onCards ? Shown::AsCards : isSparse(*m_tree, g, detail) ? Shown::Part : Shown::All;
        model->stems.push_back(keptOr(made[slot], g, m_tree->generations()[slot], params, shown, [&] {
            if (onCards) return noStems(*m_tree, g);
            const StemMesh* parents = g > 0 ? &made[slot - 1].stems : nullptr;
            StemMesh stems{planRings(*m_tree, g, params, detail, parents, progress), nullptr};
            model->milliseconds.smooth += watch.lap();
            stems.mesh = meshOfStems(*m_tree, g, stems.plan, params, progress);
            return stems;
        }));
        model->milliseconds.mesh += watch.lap();
        progress.report(0.5 + 0.4 * (g + 1) / generations);
    }
    const MeshPlan& last = made[m_tree->generationCount() - 1].stems.plan;
    for (const Organ organ : kOrgans) {
        const auto i = static_cast<std::size_t>(organ);
        const bool onCards = model->twig && organ == Organ::Leaf;
        model->organs[i] =
            keptOr(made[m_tree->generationCount() + i], Obsolete::kLeaves, m_tree->shared(organ), params,
                   onCards ? Shown::AsCards : Shown::All, [&] {
                       return StemMesh{{},
                                       onCards ? meshOfTwigs(*m_tree, *model->twig, params, detail, progress)
                                               : meshOfOrgans(*m_tree, organ, last, params, detail, progress)};
                   });
    }
    model->milliseconds.mesh += watch.lap();
    model->milliseconds.total = model->milliseconds.structure + model->milliseconds.smooth + model->milliseconds.mesh;
    progress.report(1);
    return model;
}

void CTreeCreator::refuseTooLarge(const CParams& params, const Detail& detail) const {
    const Prediction size = predictSize(params, detail);
    if (size.vertices <= m_mostVertices) return;
    throw CError("this tree would have up to " + countText(size.stems) + " stems, " + countText(size.leaves) +
                 " leaves and " + countText(size.vertices) + " vertices; the limit is " + countText(m_mostVertices) +
                 " vertices");
}

void CTreeCreator::updateTree(const CParams& params, const CProgress& progress) {
    const Obsolete obsolete = m_tree ? firstObsolete(m_treeParams, params) : Obsolete{Stage::Structure, 0};
    if (obsolete.stage > Stage::Structure) return;
    m_tree = m_builder->build(params, m_tree.get(), obsolete.generation, progress);
    m_treeParams = params;
    dropStaleMeshes();
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
