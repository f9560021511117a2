#pragma once
#include "stromar/app/Prediction.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/model/TreeModel.h"
#include "stromar/tree/TreeBuilder.h"
#include <memory>
#include <vector>

namespace stromar {

/// The pipeline from parameters to meshes. Keeps what it made, compares with what was asked for, redoes the least:
/// equal parts of two results are shared. Not thread-safe: one thread at a time.
class CTreeCreator {
public:
    explicit CTreeCreator(bool varied = true, const SizeLimits& limits = {});

    /// Throws CCancelled, and CError when the tree would be too large. What was made before stays valid.
    std::shared_ptr<const TreeModel> create(const CParams& params, const Detail& detail, const CProgress& progress);
    void setLimits(const SizeLimits& limits) { m_limits = limits; }
    /// The next create() starts from nothing.
    void forget();

private:
    enum class Drawn { All, Part, AsCards }; ///< of a generation, of the leaves
    struct MadeMesh {
        std::shared_ptr<const void> source; ///< the generation or the organs it shows
        StemMesh stems;                     ///< of organs only the mesh
        CParams params;
        Drawn drawn = Drawn::All;
    };
    using MadeMeshes = std::vector<MadeMesh>; ///< by generation, then by organ, then the cards

    void refuseTooLarge(const CParams& params, const Detail& detail) const;
    void chooseBuilder(const CParams& params);
    void updateTree(const CParams& params, const CProgress& progress);
    void dropStaleMeshes();

    bool m_varied;
    SizeLimits m_limits;
    std::unique_ptr<ITreeBuilder> m_builder;
    std::shared_ptr<const CTree> m_tree;
    CParams m_treeParams;
    std::vector<MadeMeshes> m_made; ///< by row of the table of details
};

} // namespace stromar
