#include "stromar/app/TreeCreator.h"
#include "stromar/app/LeafMesh.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Pictures.h"
#include "stromar/app/Prediction.h"
#include "stromar/model/MeshValues.h"
#include "stromar/params/ParamTable.h"
#include "stromar/util/Text.h"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

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

bool meshIsStale(const std::optional<CParams>& made, const CParams& wanted, int generation) {
    if (!made) return true;
    const Invalidation invalid = invalidationOf(*made, wanted);
    return invalid.stage <= Stage::Mesh && invalid.generation <= generation;
}

/// Whether two trees have the same stems and bases; their organs may be others.
bool haveSameStems(const CTree& a, const CTree& b) { return a.generations() == b.generations() && a.base() == b.base(); }

/// Whether organs show the same pictures, blossoms among leaves that do: they are fitted by what those cover.
bool haveSamePictures(const CParams& a, const CParams& b, Organ organ) {
    const auto isSame = [&](Surface surface) { return textureOf(a, shownSurface(a, surface), a.folder) == textureOf(b, shownSurface(b, surface), b.folder); };
    return organ == Organ::Fruit || (std::ranges::all_of(kLeafSurfaces, isSame) && (organ == Organ::Leaf || isSame(Surface::Blossom)));
}

/// With its memory.
template <typename Vector>
void release(Vector& values) {
    values = Vector();
}
} // namespace

/// Makes one model of the creator's tree, out of what was made before where it is still true.
class CTreeCreator::CModelMaker {
public:
    CModelMaker(CTreeCreator& creator, const CParams& params, const Detail& detail, const CProgress& progress, Plans plans)
        : m_tree(*creator.m_tree), m_builder(*creator.m_builder), m_growth(creator.m_growth),
          m_madeTwig(creator.m_madeTwig), m_made(creator.m_made[rowOf(detail)]), m_params(params),
          m_mesh(meshParamsWithLeaf(params)), m_detail(detail), m_keepsPlans(plans == Plans::Keep), m_progress(progress),
          m_model(std::make_shared<TreeModel>()) {
        m_model->params = params;
        m_model->age = creator.m_treeAge;
        m_model->grown = creator.m_grown;
        m_model->detail = &detail;
    }

    std::shared_ptr<const TreeModel> make(CStopwatch& watch) {
        m_model->milliseconds.structure = watch.lap();
        m_progress.report(0.5);
        chooseStemsOf(chooseTwig());
        m_model->milliseconds.structure += watch.lap();
        m_made.stems.resize(m_tree.generationCount());
        for (std::size_t g = 0; g < m_tree.generationCount(); ++g) {
            makeStems(g, watch);
            m_progress.report(0.5 + 0.4 * double(g + 1) / double(m_tree.generationCount()));
        }
        if (m_keepsPlans) m_model->planned = std::make_shared<const std::vector<StemMesh>>(std::move(m_planned));
        m_leafDetail = withLeaves(m_detail, m_model->leafShare = leafShare());
        OrganArrays organs;
        for (const Organ organ : kOrgans) organs[static_cast<std::size_t>(organ)] = growOrgans(organ);
        keepTree(organs);
        m_model->milliseconds.structure += watch.lap();
        for (const Organ organ : kOrgans) std::ranges::copy(meshOrgans(organ), std::back_inserter(m_model->organs));
        if (m_model->twig)
            m_model->cards = meshOfTwigs(m_model->choice->asCards, m_tree, *m_madeTwig.leafCounts, *m_model->twig, m_mesh, m_leafDetail, m_progress,
                                         meshOrgans(Organ::Leaf));
        auto& ms = m_model->milliseconds;
        ms.mesh += watch.lap();
        ms.total = ms.structure + ms.smooth + ms.mesh;
        return m_model;
    }

private:
    /// Which stems cards show.
    StemSet chooseTwig() {
        if (!mayShowCards(m_params, m_detail, m_progress)) return {};
        if (m_madeTwig.growth != m_growth || m_madeTwig.params != m_params) m_madeTwig = makeTwig();
        m_model->twig = m_madeTwig.typical;
        return m_model->twig ? m_madeTwig.twigs : StemSet();
    }

    MadeTwig makeTwig() const {
        const auto counts = countLeaves();
        MadeTwig made{m_growth, m_params, counts, twigsOf(m_tree, *counts), nullptr};
        const auto place = typicalOf(made.twigs, m_tree, *counts, m_mesh);
        if (!place) return made;
        OrganDemand itsLeaves{.stems = StemSet{}};
        itsLeaves.stems->stems.resize(place->generation + 1);
        itsLeaves.stems->stems.back().resize(place->stem + 1);
        itsLeaves.stems->stems.back().back() = true;
        const auto leaves = m_builder.growOrgans(m_params, m_tree, Organ::Leaf, itsLeaves, m_progress);
        const auto some = [&](Organ organ) { return m_builder.growOrgans(m_params, m_tree, organ, {.max = kMeasuredLeaves}, m_progress); };
        CrownOrgans crown{some(Organ::Leaf), {}, {}};
        if (m_mesh.seasonOf(Organ::Blossom).share > 0) {
            crown.blossoms = some(Organ::Blossom);
            crown.blossomMask = maskOf(m_params, Surface::Blossom, m_progress);
        }
        made.typical = twigAt(*place, made.twigs, m_tree, *leaves, crown, leafMasksOf(m_params, m_progress), m_mesh, m_progress);
        return made;
    }

    std::shared_ptr<const COrgans> countLeaves() const {
        return m_builder.growOrgans(m_params, m_tree, Organ::Leaf, OrganDemand::none(), m_progress);
    }

    void chooseStemsOf(StemSet asCards) {
        MadeChoice& made = m_made.choice;
        const int last = static_cast<int>(m_tree.generationCount()) - 1;
        if (!made.stems || made.sources != m_tree.generations() || made.stems->asCards != asCards || meshIsStale(made.params, m_params, last))
            made = {m_tree.generations(), m_params, std::make_shared<const StemChoice>(chooseStems(m_tree, m_mesh, m_detail, std::move(asCards), m_progress))};
        m_model->choice = made.stems;
    }

    GenerationChoice choiceOf(std::size_t g) const {
        const StemChoice& choice = *m_model->choice;
        const std::size_t stems = m_tree.generation(g).stems.size();
        GenerationChoice own{choice.drawn(g, stems), {}, choice.thickening(g), nullptr, {}, {}};
        for (std::size_t s = 0; s < stems; ++s) own.bears.push_back(choice.bears(g, s));
        if (!m_tree.branchesAtNodes(g)) return own;
        own.branches = m_tree.generations()[g + 1];
        own.branchesDrawn = choice.drawn(g + 1, own.branches->stems.size());
        own.branchThickening = choice.thickening(g + 1);
        return own;
    }

    void makeStems(std::size_t g, CStopwatch& watch) {
        MadeStems& made = m_made.stems[g];
        const int generation = static_cast<int>(g);
        const auto& source = m_tree.generations()[g];
        // The simple model changes with every step of a hand: new memory would cost it more than it saves.
        const bool last = m_detail.model == Model::Full && g + 1 == m_tree.generationCount();
        GenerationChoice choice = choiceOf(g);
        if (!made.stems.mesh || made.source != source || made.choice != choice || meshIsStale(made.params, m_params, generation)) {
            made = {}; // first the memory of the old mesh
            made = {source, meshStems(g, watch), m_params, std::move(choice)};
        } else if (m_keepsPlans || (made.last && !last))
            made.stems.plan = planStems(g);
        if (m_keepsPlans) m_planned.push_back(made.stems);
        made.last = last;
        release(made.stems.plan.collarPoints); // only the mesh needed them
        release(made.stems.plan.forkPoints);
        if (last) {
            release(made.stems.plan.rings);
            release(made.stems.plan.tubes);
        }
        m_model->stems.push_back(made.stems.mesh);
        m_plans.push_back(&made.stems.plan);
        m_model->milliseconds.mesh += watch.lap();
    }

    StemMesh meshStems(std::size_t g, CStopwatch& watch) {
        StemMesh stems{planStems(g), nullptr};
        m_model->milliseconds.smooth += watch.lap();
        stems.mesh = meshOfStems(m_tree, static_cast<int>(g), stems.plan, m_mesh, m_progress);
        return stems;
    }

    MeshPlan planStems(std::size_t g) const {
        std::vector<const StemMesh*> below;
        for (std::size_t b = 0; b < g; ++b) below.push_back(&m_made.stems[b].stems);
        return planRings(m_tree, static_cast<int>(g), m_mesh, m_detail, below, m_progress, *m_model->choice);
    }

    /// The last level of detail has fewer leaves where wood takes much of its triangles.
    LeafShare leafShare() const {
        const StemChoice& choice = *m_model->choice;
        if (m_detail.lod < kMaxLod || choice.fullTriangles == 0) return {};
        const double wood = std::accumulate(m_plans.begin(), m_plans.end(), 0.0, [](double sum, const MeshPlan* plan) { return sum + double(plan->indexCount) / 3; });
        const auto counts = m_model->twig ? m_madeTwig.leafCounts : countLeaves();
        const double present = m_mesh.seasonOf(Organ::Leaf).share, onTwigs = double(counts->countOn(choice.asCards));
        return leafShareOf(m_mesh, m_detail, choice.fullTriangles, wood, {present * (double(counts->total) - onTwigs), present * onTwigs});
    }

    const Detail& detailOf(Organ organ) const { return organ == Organ::Leaf ? m_leafDetail : m_detail; }

    std::shared_ptr<const COrgans> growOrgans(Organ organ) {
        MadeOrgans& made = m_made.organs[static_cast<std::size_t>(organ)];
        const OrganDemand demand = demandOf(detailOf(organ), m_plans, asCards(organ));
        const Meshes bearers = demand.stems ? m_model->stems : Meshes();
        if (!made.organs || made.growth != m_growth || made.bearers != bearers || made.leafShare != m_model->leafShare) {
            made = {}; // first the memory of the old ones
            made.organs = m_builder.growOrgans(m_params, m_tree, organ, demand, m_progress);
            made.growth = m_growth;
            made.bearers = bearers;
            made.leafShare = m_model->leafShare;
        }
        return made.organs;
    }

    /// Whose organs of a kind cards show.
    StemSet asCards(Organ organ) const { return organ == Organ::Leaf ? m_model->choice->asCards : StemSet(); }

    /// The tree with what is grown on it: the same object as long as nothing of it changes.
    void keepTree(const OrganArrays& organs) {
        const auto same = [&](Organ organ) { return m_made.tree->organs(organ) == organs[static_cast<std::size_t>(organ)]; };
        if (!m_made.tree || !haveSameStems(*m_made.tree, m_tree) || !std::ranges::all_of(kOrgans, same))
            m_made.tree = std::make_shared<const CTree>(m_tree.withOrgans(organs));
        m_model->tree = m_made.tree;
    }

    const OrganMeshes& meshOrgans(Organ organ) {
        MadeOrgans& made = m_made.organs[static_cast<std::size_t>(organ)];
        const bool isFitted = m_detail.lod > 0;
        if (made.meshes.empty() || meshIsStale(made.params, m_params, Invalidation::kLeaves) || (isFitted && !haveSamePictures(*made.params, m_params, organ))) {
            made.meshes = meshOfOrgans(*m_model->tree, organ, m_plans, m_mesh, detailOf(organ), m_progress, asCards(organ));
            if (organ == Organ::Leaf && isFitted) fitLeaves(made.meshes);
            if (organ == Organ::Blossom && isFitted) fitBlossoms(made.meshes);
            made.params = m_params;
        }
        return made.meshes;
    }

    /// Those beside the cards.
    void fitLeaves(OrganMeshes& meshes) const {
        const StemSet& asCards = m_model->choice->asCards;
        const COrgans& leaves = *m_model->tree->organs(Organ::Leaf);
        if (double(leaves.total - leaves.countOn(asCards)) > kMeasuredLeaves) return;
        OrganDemand beside;
        if (!asCards.empty()) beside.stems = demandOf(m_detail, m_plans, asCards).stems;
        const auto all = m_builder.growOrgans(m_params, m_tree, Organ::Leaf, beside, m_progress);
        meshes = fittingLeaves(meshes, all, m_tree, leafMasksOf(m_params, m_progress), m_mesh, m_detail, m_progress);
    }

    void fitBlossoms(OrganMeshes& meshes) const {
        if (m_mesh.seasonOf(Organ::Blossom).share <= 0 || double(m_model->tree->organs(Organ::Blossom)->total) > kMeasuredLeaves) return;
        OrganArrays organs;
        organs.fill(std::make_shared<const COrgans>());
        organs[static_cast<std::size_t>(Organ::Blossom)] = m_builder.growOrgans(m_params, m_tree, Organ::Blossom, {}, m_progress);
        const auto whole = meshOfOrgans(m_tree.withOrgans(organs), Organ::Blossom, m_plans, m_mesh, stromar::detailOf(Model::Full), m_progress);
        CrownOrgans crown{{}, {}, maskOf(m_params, Surface::Blossom, m_progress)};
        if (m_detail.lod > 1) crown.leaves = m_builder.growOrgans(m_params, m_tree, Organ::Leaf, {.max = kMeasuredLeaves}, m_progress);
        meshes = fittingBlossoms(meshes, whole, crown, m_tree, leafMasksOf(m_params, m_progress), m_mesh, m_detail, m_progress);
    }

    const CTree& m_tree;
    const ITreeBuilder& m_builder;
    std::uint64_t m_growth;
    MadeTwig& m_madeTwig;
    MadeModel& m_made;
    const CParams& m_params;
    MeshParams m_mesh;
    const Detail& m_detail;
    bool m_keepsPlans;
    Detail m_leafDetail = m_detail; ///< for leaves and cards
    const CProgress& m_progress;
    std::shared_ptr<TreeModel> m_model;
    std::vector<const MeshPlan*> m_plans;
    std::vector<StemMesh> m_planned; ///< for the model, where it keeps them
};

CTreeCreator::CTreeCreator(bool varied, const SizeLimits& limits)
    : m_varied(varied), m_limits(limits), m_made(detailTable().size()) {}

void CTreeCreator::forget() {
    m_grown.reset();
    m_tree.reset();
    m_madeTwig = {};
    m_made.assign(detailTable().size(), {});
}

std::size_t CTreeCreator::rowOf(const Detail& detail) { return static_cast<std::size_t>(&detail - detailTable().data()); }

void CTreeCreator::forgetOthers(const Detail& detail) {
    for (std::size_t i = 0; i < m_made.size(); ++i)
        if (i != rowOf(detail)) m_made[i] = {};
}

std::shared_ptr<const TreeModel> CTreeCreator::create(const CParams& params, const Detail& detail,
                                                      const CProgress& progress, Plans plans) {
    refuseTooLarge(params, detail, m_limits, progress);
    CStopwatch watch;
    updateTree(params, progress);
    auto model = CModelMaker(*this, params, detail, progress, plans).make(watch);
    progress.report(1);
    return model;
}

void CTreeCreator::updateTree(const CParams& params, const CProgress& progress) {
    const Invalidation invalid = m_grown ? invalidationOf(m_treeParams, params) : Invalidation{Stage::Structure, 0};
    if (invalid.stage > Stage::Mesh && m_age == m_treeAge) return;
    chooseBuilder(params);
    // The form of the trunks' bases is part of the tree, though no generation has to grow for it.
    const int first = invalid.stage == Stage::Structure ? invalid.generation : Invalidation::kNone;
    const auto grown = m_builder->build(params, m_grown.get(), first, progress);
    const bool same = m_grown && invalid.stage > Stage::Structure && grown->base() == m_grown->base();
    const auto tree = same && m_age == m_treeAge ? m_tree : m_builder->atAge(params, same ? m_grown : grown, m_age, progress);
    if (invalid.stage == Stage::Structure || m_age != m_treeAge) ++m_growth;
    if (!same) m_grown = grown;
    m_tree = tree;
    m_treeAge = m_age;
    m_treeParams = params;
    dropStaleMeshes();
}

/// Another method grows from nothing.
void CTreeCreator::chooseBuilder(const CParams& params) {
    if (m_builder && &m_treeParams.block() == &params.block()) return;
    m_builder = methodOf(params).makeBuilder(m_varied);
    m_grown.reset();
    m_tree.reset();
}

/// Frees what shows generations and organs that are gone, so that no level of detail keeps an old tree in memory.
void CTreeCreator::dropStaleMeshes() {
    const auto& generations = m_tree->generations();
    if (m_madeTwig.growth != m_growth) m_madeTwig = {};
    for (MadeModel& made : m_made) {
        for (MadeStems& stems : made.stems)
            if (std::ranges::find(generations, stems.source) == generations.end()) stems = {};
        for (MadeOrgans& organs : made.organs)
            if (organs.growth != m_growth) organs = {};
        if (made.choice.sources != generations) made.choice = {};
        if (made.tree && !haveSameStems(*made.tree, *m_tree)) made.tree.reset();
    }
}

} // namespace stromar
