#pragma once
#include "Poses.h"

namespace stromar {

/// "_LOD1"
std::string suffixOfLevel(std::size_t lod);

/// Makes of poses of a tree what a writer gets. They share their materials.
class CModelMaker {
public:
    /// The references live as long as it does.
    CModelMaker(const ExportOptions& options, const Format& format, const Motion& motion, const CProgress& progress);

    /// Puts the pictures of what is shown where the options want them. Throws CError and CCancelled.
    void findMaterials(const TreeModel& coarsest, const std::vector<Surface>& shown, const std::filesystem::path& treeFolder, const Output& to,
                       CFileSet& files);

    /// So many levels of detail of a pose. Throws CCancelled.
    ExportModel modelOf(const Pose& pose, const std::string& name, std::size_t first, std::size_t count) const;
    const Arrangement& arrangement() const { return m_arrangement; }

private:
    const ExportOptions& m_options;
    const Format& m_format;
    const Motion& m_motion;
    const CProgress& m_progress;
    Arrangement m_arrangement;
    std::vector<Material> m_materials;
    std::optional<CAtlas> m_atlas;
    std::optional<Material> m_foliage;
};

} // namespace stromar
