#pragma once
#include "stromar/app/Prediction.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/model/TreeModel.h"
#include "stromar/tree/TreeBuilder.h"
#include <memory>
#include <optional>
#include <vector>

namespace stromar {

/// The pipeline from parameters to meshes. Keeps what it made, compares with what was asked for, redoes the least:
/// equal parts of two results are shared. Not thread-safe: one thread at a time.
class CTreeCreator {
public:
    explicit CTreeCreator(bool varied = true, const SizeLimits& limits = {});

    /// Whether a model keeps the plans of its rings: for wood that is joined then, which plans them once more otherwise.
    enum class Plans { Drop, Keep };

    /// Throws CCancelled, and CError when the tree would be too large. What was made before stays valid.
    std::shared_ptr<const TreeModel> create(const CParams& params, const Detail& detail, const CProgress& progress, Plans plans = Plans::Drop);
    const SizeLimits& limits() const { return m_limits; }
    void setLimits(const SizeLimits& limits) { m_limits = limits; }
    /// How old the trees of the next create() are, 0..1 of their life.
    void setAge(double age) { m_age = age; }
    /// The next create() starts from nothing.
    void forget();
    /// Frees what other levels of detail show; a create() of theirs makes it anew from the same tree.
    void forgetOthers(const Detail& detail);

private:
    /// Of a generation's stems.
    struct GenerationChoice {
        std::vector<bool> drawn, bears;
        Thickening thickening;
        std::shared_ptr<const CGeneration> branches; ///< where these may part from them at forks; with what is drawn of them
        std::vector<bool> branchesDrawn;
        Thickening branchThickening;

        bool operator==(const GenerationChoice&) const = default;
    };
    struct MadeStems {
        std::shared_ptr<const CGeneration> source;
        StemMesh stems;
        std::optional<CParams> params; ///< filling in defaults takes longer than a small step
        GenerationChoice choice;
        bool last = false; ///< no generation follows: the plan is not kept
    };
    struct MadeChoice {
        std::vector<std::shared_ptr<const CGeneration>> sources;
        std::optional<CParams> params;
        std::shared_ptr<const StemChoice> stems;
    };
    struct MadeOrgans {
        std::uint64_t growth = 0; ///< of the tree that bears them
        Meshes bearers;           ///< on which stems they may be, where that matters
        LeafShare leafShare;      ///< TreeModel's
        std::shared_ptr<const COrgans> organs;
        OrganMeshes meshes; ///< by kind
        std::optional<CParams> params;
    };
    /// What cards show, at whichever level of detail.
    struct MadeTwig {
        std::uint64_t growth = 0; ///< of the tree
        std::optional<CParams> params;
        std::shared_ptr<const COrgans> leafCounts; ///< where they may stand; no leaf is grown
        StemSet twigs;
        std::shared_ptr<const Twig> typical; ///< none: no twig bears leaves
    };
    /// What a level of detail shows.
    struct MadeModel {
        MadeChoice choice;
        std::vector<MadeStems> stems; ///< by generation
        std::array<MadeOrgans, kOrgans.size()> organs;
        std::shared_ptr<const CTree> tree; ///< with its organs
    };
    class CModelMaker;

    static std::size_t rowOf(const Detail& detail);

    void chooseBuilder(const CParams& params);
    void updateTree(const CParams& params, const CProgress& progress);
    void dropStaleMeshes();

    bool m_varied;
    SizeLimits m_limits;
    std::unique_ptr<ITreeBuilder> m_builder;
    double m_age = 1;
    std::shared_ptr<const CTree> m_grown; ///< without organs
    std::shared_ptr<const CTree> m_tree;  ///< the same at the age that was made last
    double m_treeAge = 1;
    std::uint64_t m_growth = 0;          ///< rises when stems or organs have to be grown anew
    CParams m_treeParams;
    MadeTwig m_madeTwig;
    std::vector<MadeModel> m_made; ///< by row of the table of details
};

} // namespace stromar
