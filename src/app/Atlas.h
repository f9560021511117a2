#pragma once
#include "stromar/model/ExportModel.h"
#include "stromar/util/Progress.h"
#include <filesystem>
#include <glm/vec2.hpp>
#include <vector>

namespace stromar {

/// A picture and whose it is.
struct SurfacePicture {
    Surface surface;
    std::filesystem::path file;
};

/// One picture, with maps, in which several surfaces have a cell each. Around a cell's picture its edge runs on, so that smaller
/// mip-maps mix in nothing of its neighbours.
class CAtlas {
public:
    static constexpr const char* kName = "foliage"; ///< of its material
    static constexpr int kMaxCell = 1024;           ///< pixels on a side

    /// Draws it where the user's cache has none of these pictures. Throws CError where one is no PNG.
    CAtlas(std::vector<SurfacePicture> pictures, const CProgress& progress);

    const std::filesystem::path& file() const { return m_file; }
    /// The meshes that show one of the pictures show the atlas instead; `look` replaces their materials. Throws CError where a mesh has
    /// texture coordinates beyond its picture.
    void replaceIn(ExportModel& model, const Material& look) const;

private:
    glm::ivec2 cells() const; ///< across and down
    glm::vec2 placeOf(std::size_t cell, const glm::vec2& texCoord) const;
    std::shared_ptr<const CMesh> moved(const CMesh& mesh, std::size_t cell) const;
    void draw(const CProgress& progress) const;

    std::vector<SurfacePicture> m_pictures;
    std::filesystem::path m_file;
};

} // namespace stromar
