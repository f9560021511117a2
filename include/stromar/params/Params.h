#pragma once
#include "stromar/params/Degrees.h"
#include <any>
#include <cassert>
#include <filesystem>
#include <string>
#include <utility>

namespace stromar {

struct ParamBlock;

/// Values that every tree has, however it grows. Lengths in metres. What each means stands in the table of parameters.
struct CommonParams {
    double minRadius, textureWrapX, textureWrapY;
    double flare, lobeDepth, lobeFade, rootReach, rootHeight;
    double season, flexibility;
    double leafScale, leafScaleX, leafBend, leafQuality, leafStalk, leafRounding, leafSunShade, leafColourV;
    Degrees leafFold;
    double leafShare2, leafShare3, leafShare4;
    double blossomScale, blossomUp, blossomDome, blossomMonth, fruitScale, fruitScaleX, fruitStalk, fruitMonth;
    int seed, evergreen, lobes, roots;
    int leafShape, leafForm, leafWhorl, leafPlanes, blossoms, blossomPlanes, fruits;

    bool operator==(const CommonParams&) const = default;
};

/// Parts of the leaves that are of the second, third and fourth kind; the first has the rest.
inline constexpr double CommonParams::*kLeafShares[] = {&CommonParams::leafShare2, &CommonParams::leafShare3, &CommonParams::leafShare4};

/// What a file says in words. Paths are relative to the file; empty = the built-in picture.
struct TextParams {
    std::string species, author, description, likedSeeds, barkTexture, leafTexture, blossomTexture, fruitTexture;
    std::string bark1Texture, bark2Texture, bark3Texture; ///< of a generation; empty: as the one before
    std::string leafMesh; ///< a file, or a built-in one; empty: as LeafForm says
    std::string leaf2Texture, leaf3Texture, leaf4Texture, leaf2Mesh, leaf3Mesh, leaf4Mesh; ///< empty: as the first kind's

    bool operator==(const TextParams&) const = default;
};
/// Of the kinds of leaves.
inline constexpr std::string TextParams::*kLeafMeshes[] = {&TextParams::leafMesh, &TextParams::leaf2Mesh, &TextParams::leaf3Mesh,
                                                           &TextParams::leaf4Mesh};

/// Everything a user can set for one tree: what all trees have, and the block of its way to grow. A plain value, to be
/// copied, compared and handed to other threads.
class CParams {
public:
    CommonParams common{};
    TextParams text;
    std::filesystem::path folder; ///< where paths in texts start: that of the file they were read from. Not compared

    /// The defaults of Weber and Penn's method, which files without a method have.
    CParams();
    /// The defaults of a method.
    explicit CParams(const ParamBlock& block);

    const ParamBlock& block() const { return *m_block; }
    /// The values of the method, whose struct this has to be.
    template <typename Block>
    const Block& as() const {
        const Block* own = std::any_cast<Block>(&m_values);
        assert(own);
        return *own;
    }
    template <typename Block>
    Block& as() {
        return const_cast<Block&>(std::as_const(*this).template as<Block>());
    }
    bool operator==(const CParams& other) const;

private:
    const ParamBlock* m_block;
    std::any m_values;
};

} // namespace stromar
