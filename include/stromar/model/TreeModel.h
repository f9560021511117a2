#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/mesh/JoinedStems.h"
#include "stromar/mesh/MeshBuilder.h"
#include "stromar/mesh/OrganMesh.h"
#include "stromar/mesh/StemChoice.h"
#include "stromar/mesh/twig/Twig.h"
#include "stromar/params/Params.h"
#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace stromar {

/// What joined wood was made of.
struct UnjoinedStems {
    Meshes stems;                                   ///< by generation: each stem closed by itself
    std::vector<std::vector<VertexSource>> sources; ///< by generation, of the joined meshes' vertices: in these
};

/// A tree with its meshes: triangles of stems and of cards, instances of leaves. Immutable, safe to share between
/// threads.
struct TreeModel {
    CParams params;
    const Detail* detail;
    double age = 1;                    ///< 0..1 of its life
    std::shared_ptr<const CTree> tree; ///< of its organs those are grown that are shown
    std::shared_ptr<const CTree> grown; ///< the same at the end of its life, bare
    Meshes stems;                      ///< by generation
    std::shared_ptr<const StemChoice> choice; ///< which stems those show
    LeafShare leafShare;                      ///< that is drawn of the detail's: see leafShareOf()
    std::shared_ptr<const std::vector<StemMesh>> planned; ///< the stems as they were made, with the plans of their rings; null: not kept
    std::shared_ptr<const UnjoinedStems> unjoined; ///< null: every stem is closed by itself
    OrganMeshes organs;                ///< leaves by kind, blossoms, fruits; some may be empty
    std::shared_ptr<const Twig> twig;   ///< what cards show in place of last stems with leaves; null: there are none
    std::shared_ptr<const CMesh> cards; ///< of it; null without it
    struct {
        double structure = 0, smooth = 0, mesh = 0, total = 0;
    } milliseconds;

    /// Of a kind.
    const std::shared_ptr<const COrganMesh>& leaves(std::size_t kind = 0) const { return organs[kind]; }
    std::size_t leafCount() const; ///< that are drawn, of all kinds

    static constexpr int kLeaves = -1; ///< then −2 the blossoms, −3 the fruits
    using MeshVisitor = std::function<void(const std::shared_ptr<const CMesh>& mesh, int generation)>;
    using OrganVisitor = std::function<void(const std::shared_ptr<const COrganMesh>& mesh, int generation)>;

    /// Visits the meshes that have vertices: stems by generation, then the organs (kLeaves …), then the cards as leaves.
    void visitMeshes(const MeshVisitor& visit, const OrganVisitor& visitOrgans) const;
    /// All of them with vertices of their own, as files want them. Throws CCancelled.
    Meshes meshes(const CProgress& progress = CProgress()) const;
    std::size_t vertexCount() const;
    std::size_t triangleCount() const;
    /// Of all vertices; nothing where there are none.
    std::optional<Bounds> bounds() const;
    std::size_t bytes() const; ///< of all vertices and triangles, as files want them
};

} // namespace stromar
