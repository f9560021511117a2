#pragma once
#include "stromar/mesh/Mesh.h"
#include "stromar/model/TreeModel.h"
#include "stromar/texture/Opacity.h"
#include "stromar/util/Progress.h"
#include <array>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

namespace stromar {

/// From where an orthographic camera looks: unit vectors at right angles, z of the tree up.
struct ImpostorView {
    glm::dvec3 right, up, towards; ///< `towards` the viewer

    /// The tree's own z stands upright in the picture; seen from above or below, x points to the right.
    static ImpostorView from(const glm::dvec3& towards);
};

/// What of a view goes into a picture.
struct ImpostorFrame {
    ImpostorView view;
    glm::dvec3 centre;   ///< in the picture's middle; depth is 0 there
    glm::dvec2 half;     ///< metres from the middle to the edges
    double depth;        ///< metres: that before and behind the middle are 1 and 0
};

/// Rows from the top; colours run on beyond the edges of what is seen.
struct ImpostorPicture {
    int width = 0, height = 0;
    Pixels albedo;      ///< sRGB without light, and opacity: cut at kAlphaCut, it covers what the tree covers
    /// The mean normal of the sides that are seen, in the tree's axes (128 is 0): the shorter, the more they differ. And their depth.
    Pixels normalDepth;
};

/// across × across views on an octahedron that is unfolded onto a square: its upper half (Brucks 2018), or all of it (Cigolle et al. 2014).
class CImpostorGrid {
public:
    CImpostorGrid(int across, bool whole) : m_across(across), m_whole(whole) {}

    int across() const { return m_across; }
    ImpostorView view(int column, int row) const;

    /// Three neighbours between which a direction lies, and what each counts; together 1. Below the upper half it is as seen from the horizon.
    struct Share {
        int column, row;
        double weight;
    };
    std::array<Share, 3> around(const glm::dvec3& towards) const;

private:
    glm::dvec2 placeOf(const glm::dvec3& towards) const;

    int m_across;
    bool m_whole;
};

/// Draws what is seen of a model, on the processor.
class CImpostorCamera {
public:
    /// The model's recipes must have been drawn (makePictures). Reads its pictures; throws CError where one is no PNG, and CCancelled.
    CImpostorCamera(const TreeModel& model, const Meshes& meshes, const std::filesystem::path& treeFolder, const CProgress& progress);
    ~CImpostorCamera();
    CImpostorCamera(CImpostorCamera&&) noexcept;

    /// Of the meshes; there are some.
    Bounds bounds() const;
    struct Ball {
        glm::dvec3 centre;
        double radius; ///< metres
    };
    /// That holds all vertices; a few hundredths larger than the smallest.
    Ball ball() const;
    /// Linear in the triangles; any thread, several at once.
    ImpostorPicture draw(const ImpostorFrame& frame, int width, int height) const;
    void poll() const;

private:
    class CTexture;
    struct Part;
    std::vector<Part> m_parts;
    std::vector<std::shared_ptr<const CTexture>> m_textures;
    CProgress m_progress;
};

/// All frames of a grid in one picture, row by row, in the ball around the tree.
struct ImpostorAtlas {
    static constexpr int kAcross = 8, kSide = 2048; ///< views each way; pixels

    CImpostorGrid grid;
    glm::dvec3 centre; ///< metres
    double radius;
    int frame; ///< pixels
    ImpostorPicture picture;
    double alphaCut = kAlphaCut; ///< of mixed views, so that they cover what the tree covers

    ImpostorFrame frameAt(int column, int row) const { return {grid.view(column, row), centre, glm::dvec2(radius), radius}; }
};

/// `side`: pixels, a power of two of 64 at least. On a big tree some seconds for each processor.
ImpostorAtlas drawImpostorAtlas(const CImpostorCamera& camera, bool whole, int side, const CProgress& progress);

/// What a picture shows at a place, without light.
struct ImpostorSample {
    double cover = 0;                  ///< 0..1
    glm::dvec3 colour{0}, normal{0};   ///< linear; 0..1 long
};
/// As graphics cards read a picture: between pixels, colours as light; `pixel` from its left upper corner.
ImpostorSample sampleOf(const ImpostorPicture& picture, const glm::dvec2& pixel);
/// What three views show along a ray where its depths say that it meets the tree; in the tree's axes, lengths in radii from the ball's
/// middle, `ray` of length 1. What integrations/three does on the graphics card.
ImpostorSample sampleAlong(const ImpostorAtlas& atlas, const glm::dvec3& origin, const glm::dvec3& ray);

/// Two billboards that cross at the trunk.
struct ImpostorCross {
    std::shared_ptr<const CMesh> mesh; ///< of Surface::Impostor
    std::filesystem::path picture;     ///< in the user's cache, with its maps
};
/// `side`: pixels of each billboard.
ImpostorCross drawImpostorCross(const CImpostorCamera& camera, int side, const CProgress& progress);

} // namespace stromar
