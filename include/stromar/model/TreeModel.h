#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/twig/Twig.h"
#include "stromar/params/Params.h"
#include <array>
#include <functional>
#include <memory>

namespace stromar {

/// A tree with its meshes. Immutable, safe to share between threads.
struct TreeModel {
    CParams params;
    const Detail* detail;
    std::shared_ptr<const CTree> tree;
    Meshes stems;                                                    ///< by generation
    std::array<std::shared_ptr<const CMesh>, kOrgans.size()> organs; ///< by Organ
    std::shared_ptr<const Twig> twig;   ///< what cards show in place of last stems with leaves; null: there are none
    std::shared_ptr<const CMesh> cards; ///< of it; null without it
    struct {
        double structure = 0, smooth = 0, mesh = 0, total = 0;
    } milliseconds;

    const std::shared_ptr<const CMesh>& leaves() const { return organs[static_cast<std::size_t>(Organ::Leaf)]; }

    static constexpr int kLeaves = -1; ///< then −2 the blossoms, −3 the fruits
    using MeshVisitor = std::function<void(const std::shared_ptr<const CMesh>& mesh, int generation)>;

    /// Visits the meshes that have vertices: stems by generation, then the organs (kLeaves …), then the cards as leaves.
    void visitMeshes(const MeshVisitor& visit) const;
    Meshes meshes() const;
    std::size_t vertexCount() const;
    std::size_t triangleCount() const;
};

} // namespace stromar
