#include "ModelMaker.h"
#include "BarkParts.h"
#include "Merge.h"
#include "SecondUvs.h"
#include "VertexColours.h"
#include "wind/WindExport.h"
#include "stromar/app/Formats.h"
#include "stromar/app/Pictures.h"
#include <algorithm>
#include <iterator>

namespace stromar {

namespace fs = std::filesystem;

std::string suffixOfLevel(std::size_t lod) { return "_LOD" + std::to_string(lod); }

CModelMaker::CModelMaker(const ExportOptions& options, const Format& format, const Motion& motion, const CProgress& progress)
    : m_options(options), m_format(format), m_motion(motion), m_progress(progress), m_arrangement(arrangementFor(options, format)) {}

void CModelMaker::findMaterials(const TreeModel& coarsest, const std::vector<Surface>& shown, const fs::path& treeFolder, const Output& to,
                                CFileSet& files) {
    m_atlas = atlasFor(coarsest, shown, m_options, treeFolder, m_progress);
    for (const Surface surface : shown)
        m_materials.push_back(m_atlas && surfaceOf(surface).cutOut
                                  ? plainMaterial(surface)
                                  : materialOf({surface, textureOf(coarsest, surface, treeFolder)}, surfaceOf(surface).name, m_options, m_format, to, files));
    if (m_atlas) m_foliage = materialOf({Surface::Leaf, m_atlas->file()}, CAtlas::kName, m_options, m_format, to, files);
}

ExportModel CModelMaker::modelOf(const Pose& pose, const std::string& name, std::size_t first, std::size_t count) const {
    ExportModel model{name, arranged(pose.meshes[first], m_arrangement), {}, {}};
    const std::vector<Meshes> own(pose.meshes.begin() + std::ptrdiff_t(first), pose.meshes.begin() + std::ptrdiff_t(first + count));
    std::ranges::copy_if(m_materials, std::back_inserter(model.materials),
                         [&](const Material& material) { return needsMaterial(pose.coarsest(), own, material.surface); });
    for (std::size_t i = first + 1; i < first + count; ++i) model.coarser.push_back(arranged(pose.meshes[i], m_arrangement));
    const std::span lods(pose.lods);
    if (!pose.sways.empty()) addWind(model, std::span(pose.sways).subspan(first, count), m_options, m_motion, m_arrangement);
    if (m_format.channels != Channels::None) addColours(model, isSolid(m_options) ? lods.first(0) : lods.subspan(first, count), m_options);
    if (isTwoSided(m_options, m_format)) addBacks(model, m_arrangement.scale);
    if (m_options.instances != static_cast<int>(ExportedInstances::None) && !isSolid(m_options)) addInstances(model, *pose.lods[first], m_arrangement);
    if (!isSolid(m_options)) partByBark(model, lods.subspan(first, count));
    if (m_atlas) m_atlas->replaceIn(model, *m_foliage);
    if (m_options.secondUv == static_cast<int>(ExportedSecondUv::LightMap)) addSecondUvs(model, m_progress);
    if (m_options.objects == static_cast<int>(ExportedObjects::Materials)) mergeByMaterial(model);
    model.compression = static_cast<ExportedCompression>(m_options.compression);
    model.leafLight = m_options.leafLight == static_cast<int>(ExportedLeafLight::Transmission);
    return model;
}

} // namespace stromar
