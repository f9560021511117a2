#include "stromar/model/ModelSway.h"
#include "stromar/model/JoinedModel.h"
#include "stromar/model/MeshValues.h"
#include <algorithm>
#include <cassert>

namespace stromar {

namespace {
template <typename Places>
std::shared_ptr<const SwayPlaces> shared(Places&& places) {
    return std::make_shared<const SwayPlaces>(std::forward<Places>(places));
}

/// Makes the places of one model, or takes them from one before.
class CSwayMaker {
public:
    CSwayMaker(const TreeModel& model, const ModelSway* known, ModelSway& sway, const CProgress& progress)
        : m_model(model), m_known(known), m_sway(sway), m_progress(progress), m_mesh(meshParamsOf(model.params)) {
        if (model.twig) m_cards = twigsOf(*model.tree, *model.tree->organs(Organ::Leaf));
    }

    void make() {
        addStems();
        for (std::size_t i = 0; i < m_model.organs.size(); ++i) m_sway.organs.push_back(ofOrgans(i));
        if (m_model.cards)
            m_sway.cards = shared(swayOfCards(*m_sway.table,
                                              twigsOfCards(m_cards, *m_model.tree, *m_model.tree->organs(Organ::Leaf),
                                                           *m_model.twig, m_mesh, withLeaves(*m_model.detail, m_model.leafShare)),
                                              *m_model.cards, m_progress));
    }

private:
    /// Whether the nodes of all generations up to one are those of the model before.
    bool nodesAreKnown(std::size_t generation) const {
        if (!m_known || m_known->model->tree->generationCount() <= generation) return false;
        const auto &own = m_model.tree->generations(), &known = m_known->model->tree->generations();
        return std::equal(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(generation) + 1, known.begin());
    }

    bool isKnown(std::size_t g) const {
        return !m_model.unjoined && nodesAreKnown(g) && g < m_known->stems.size() && m_known->model->stems[g] == m_model.stems[g];
    }

    void addStems() {
        const Meshes& stems = m_model.unjoined ? m_model.unjoined->stems : m_model.stems;
        std::size_t count = stems.size();
        while (count > 0 && isKnown(count - 1)) --count;
        std::vector<StemMesh> below;
        for (std::size_t g = 0; g < stems.size(); ++g) {
            if (g >= count) {
                m_sway.stems.push_back(m_known->stems[g]);
                continue;
            }
            StemMesh own = planned(m_model, g, below, m_progress);
            m_sway.stems.push_back(isKnown(g) ? m_known->stems[g] : shared(swayOfStems(*m_sway.table, g, own.plan, *own.mesh, m_progress)));
            below.push_back(std::move(own));
        }
        if (m_model.unjoined) joinStems();
    }

    /// The vertices of joined wood hang where those do that they come from.
    void joinStems() {
        const auto apart = std::move(m_sway.stems);
        m_sway.stems.clear();
        for (const std::vector<VertexSource>& sources : m_model.unjoined->sources) {
            SwayPlaces places;
            for (const VertexSource& source : sources) places.push_back((*apart[source.generation])[source.vertex]);
            m_sway.stems.push_back(shared(std::move(places)));
        }
    }

    std::shared_ptr<const SwayPlaces> ofOrgans(std::size_t i) const {
        const auto& organs = m_model.organs[i];
        const bool allKnown = m_model.tree->generationCount() > 0 && nodesAreKnown(m_model.tree->generationCount() - 1);
        if (allKnown && m_known->model->organs[i] == organs) return m_known->organs[i];
        return shared(swayOfOrgans(*m_sway.table, *organs, m_progress));
    }

    const TreeModel& m_model;
    const ModelSway* m_known;
    ModelSway& m_sway;
    const CProgress& m_progress;
    MeshParams m_mesh;
    StemSet m_cards; ///< twigs that cards show
};
} // namespace

const std::shared_ptr<const SwayPlaces>& ModelSway::placesOf(const CMesh& mesh) const {
    if (&mesh == model->cards.get()) return cards;
    const auto own = std::ranges::find(model->stems, &mesh, [](const auto& m) { return m.get(); });
    assert(own != model->stems.end());
    return stems[static_cast<std::size_t>(own - model->stems.begin())];
}

const std::shared_ptr<const SwayPlaces>& ModelSway::placesOf(const COrganMesh& mesh) const {
    const auto own = std::ranges::find(model->organs, &mesh, [](const auto& m) { return m.get(); });
    assert(own != model->organs.end());
    return organs[static_cast<std::size_t>(own - model->organs.begin())];
}

std::shared_ptr<const ModelSway> swayOf(const std::shared_ptr<const TreeModel>& model, const ModelSway* known,
                                        const CProgress& progress) {
    const CommonParams& common = model->params.common;
    auto sway = std::make_shared<ModelSway>();
    sway->model = model;
    sway->table = std::make_shared<const CWindTable>(model->tree, *model->grown, common.flexibility, common.seed);
    CSwayMaker(*model, known, *sway, progress).make();
    return sway;
}

std::shared_ptr<const ModelSway> felled(const std::shared_ptr<const ModelSway>& sway, const CFall& fall) {
    if (fall.felling().height <= 0 || !fall.anythingFalls()) return sway;
    auto model = std::make_shared<TreeModel>(*sway->model);
    auto cut = std::make_shared<ModelSway>(*sway);
    CutMesh trunks = cutTrunks(*model->stems[0], *sway->stems[0], *sway->table, fall);
    model->stems[0] = trunks.mesh;
    cut->stems[0] = shared(std::move(trunks.places));
    const auto side = [&](std::shared_ptr<const SwayPlaces>& places) {
        if (places) places = shared(onOneSide(*places, *sway->table, fall));
    };
    for (std::size_t g = 1; g < cut->stems.size(); ++g) side(cut->stems[g]);
    for (auto& organs : cut->organs) side(organs);
    side(cut->cards);
    cut->model = model;
    return cut;
}

Meshes swayedMeshes(const ModelSway& sway, const WindPose& pose, double seconds, double loop,
                    const CProgress& progress) {
    Meshes all;
    sway.model->visitMeshes(
        [&](const auto& mesh, int) {
            all.push_back(swayed(*mesh, *sway.placesOf(*mesh), *sway.table, pose, progress));
        },
        [&](const auto& organs, int) {
            all.push_back(swayed(*organs, *sway.placesOf(*organs), *sway.table, pose, seconds, loop, progress));
        });
    return all;
}

} // namespace stromar
