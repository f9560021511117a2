#pragma once
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/mesh/Twig.h"
#include "stromar/tree/TreeBuilder.h"
#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace stromar {

/// A tree with its meshes. Immutable, safe to share between threads.
struct TreeModel {
    CParams params;
    const Detail* detail;
    std::shared_ptr<const CTree> tree;
    std::vector<std::shared_ptr<const CMesh>> stems;                 ///< by generation
    std::array<std::shared_ptr<const CMesh>, kOrgans.size()> organs; ///< by Organ
    std::shared_ptr<const Twig> twig; ///< what cards show in place of leaves and last stems; null: there are none
    struct {
        double structure = 0, smooth = 0, mesh = 0, total = 0;
    } milliseconds;

    const std::shared_ptr<const CMesh>& leaves() const { return organs[static_cast<std::size_t>(Organ::Leaf)]; }

    static constexpr int kLeaves = -1; ///< then −2 the blossoms, −3 the fruits
    using MeshVisitor = std::function<void(const std::shared_ptr<const CMesh>& mesh, int generation)>;

    /// Visits the meshes that have vertices: stems by generation, then the organs (kLeaves …).
    void visitMeshes(const MeshVisitor& visit) const;
    std::vector<std::shared_ptr<const CMesh>> meshes() const;
    std::size_t vertexCount() const;
    std::size_t triangleCount() const;
};

/// The pipeline from parameters to meshes. Keeps what it made, compares with what was asked for, redoes the least:
/// equal parts of two results are shared. Not thread-safe: one thread at a time.
class CTreeCreator {
public:
    static constexpr double kMostVertices = 20e6; ///< default limit

    explicit CTreeCreator(bool varied = true, double mostVertices = kMostVertices);

    /// Throws CCancelled, and CError when the tree would be too large. What was made before stays valid.
    std::shared_ptr<const TreeModel> create(const CParams& params, const Detail& detail, const CProgress& progress);
    void setMostVertices(double most) { m_mostVertices = most; }
    /// The next create() starts from nothing.
    void forget();

private:
    enum class Shown { All, Part, AsCards }; ///< of a generation, of the leaves
    struct MadeMesh {
        std::shared_ptr<const void> source; ///< the generation or the organs it shows
        StemMesh stems;                     ///< of organs only the mesh
        CParams params;
        Shown shown = Shown::All;
    };
    using MadeMeshes = std::vector<MadeMesh>; ///< by generation, the organs last

    void refuseTooLarge(const CParams& params, const Detail& detail) const;
    void updateTree(const CParams& params, const CProgress& progress);
    void dropStaleMeshes();

    bool m_varied;
    double m_mostVertices;
    std::unique_ptr<ITreeBuilder> m_builder;
    std::shared_ptr<const CTree> m_tree;
    CParams m_treeParams;
    std::vector<MadeMeshes> m_made; ///< by row of the table of details
};

} // namespace stromar
