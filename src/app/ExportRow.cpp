#include "stromar/app/ExportRow.h"
#include "BarkParts.h"
#include "ExportParts.h"
#include "Merge.h"
#include "SecondUvs.h"
#include "VertexColours.h"
#include "stromar/app/Formats.h"
#include "stromar/app/Pictures.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/mesh/Detail.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <optional>

namespace stromar {

namespace fs = std::filesystem;

namespace {
/// Puts trees into one model.
class CRowMaker {
public:
    CRowMaker(const ExportOptions& options, const Format& format, const fs::path& treeFolder, const fs::path& path,
              CFileSet& files)
        : m_options(options), m_format(format), m_treeFolder(treeFolder), m_path(path),
          m_files(files), m_row{plainName(path), {}, {}, {}} {
        m_row.compression = static_cast<ExportedCompression>(options.compression);
        m_row.leafLight = options.leafLight == static_cast<int>(ExportedLeafLight::Transmission);
    }

    void add(const RowTree& tree, const std::shared_ptr<const TreeModel>& model, const CProgress& progress) {
        makePictures(*model, m_treeFolder, progress);
        std::optional<CAtlas> atlas;
        ExportModel own = ownModel(tree, model, atlas, progress);
        std::vector<std::optional<std::size_t>> materials(kSurfaces.size());
        for (std::size_t i = 0; i < own.meshes.size(); ++i) {
            const Material& look = own.materialOf(*own.meshes[i]);
            auto& material = materials[static_cast<std::size_t>(look.surface)];
            const bool shared = atlas && look.name == CAtlas::kName;
            if (!material) material = materialFor(tree, {look.surface, shared ? atlas->file() : textureOf(*model, look.surface, m_treeFolder)}, look.name);
            m_row.meshes.push_back(renamed(*own.meshes[i], tree.name));
            m_row.meshMaterials.push_back(*material);
            if (!own.channels.empty()) m_row.channels.push_back(std::move(own.channels[i]));
            if (!own.instances.empty()) m_row.instances.push_back(std::move(own.instances[i]));
        }
    }

    const ExportModel& row() const { return m_row; }

private:
    /// With materials that say no more than which surface they are of.
    ExportModel ownModel(const RowTree& tree, const std::shared_ptr<const TreeModel>& model, std::optional<CAtlas>& atlas,
                         const CProgress& progress) const {
        const Arrangement arrangement = arrangementFor(m_options, m_format);
        const Meshes meshes = meshesFor(*model, m_options, progress);
        ExportModel own{tree.name, arranged(moved(meshes, glm::vec3(tree.place, 0, 0)), arrangement), {}, {}};
        const std::vector<Surface> shown = shownSurfaces(*model, {meshes}, false);
        for (const Surface surface : shown) own.materials.push_back(plainMaterial(surface));
        const std::span<const std::shared_ptr<const TreeModel>> coloured(&model, isSolid(m_options) ? 0 : 1);
        if (m_format.channels != Channels::None) addColours(own, coloured, m_options);
        if (isTwoSided(m_options, m_format)) addBacks(own, arrangement.scale);
        if (m_options.instances != static_cast<int>(ExportedInstances::None) && !isSolid(m_options))
            addInstances(own, *model, arrangement, static_cast<float>(tree.place));
        partByBark(own, coloured);
        atlas = atlasFor(*model, shown, m_options, m_treeFolder, progress);
        if (atlas) {
            Material foliage = plainMaterial(Surface::Leaf);
            foliage.name = CAtlas::kName;
            atlas->replaceIn(own, foliage);
        }
        if (m_options.secondUv == static_cast<int>(ExportedSecondUv::LightMap)) addSecondUvs(own, progress);
        if (m_options.objects == static_cast<int>(ExportedObjects::Materials)) mergeByMaterial(own);
        return own;
    }

    static Meshes moved(const Meshes& meshes, const glm::vec3& by) {
        Meshes all;
        for (const auto& mesh : meshes) {
            auto copy = std::make_shared<CMesh>(*mesh);
            for (glm::vec3& p : copy->positions) p += by;
            all.push_back(std::move(copy));
        }
        return all;
    }

    static std::shared_ptr<const CMesh> renamed(const CMesh& mesh, const std::string& tree) {
        auto copy = std::make_shared<CMesh>(mesh);
        copy->name = tree + "_" + mesh.name;
        return copy;
    }

    /// That of an earlier tree where the picture is the same.
    std::size_t materialFor(const RowTree& tree, const SurfacePicture& shown, const std::string& name) {
        const auto isSame = [&](const Known& known) { return known.name == name && known.picture == shown.file; };
        if (const auto known = std::ranges::find_if(m_known, isSame); known != m_known.end()) return known->material;
        const bool isFirst = std::ranges::find(m_known, name, &Known::name) == m_known.end();
        const Output to{m_path, isFirst ? m_path : withSuffix(m_path, "_" + tree.name)};
        m_known.push_back({name, shown.file, m_row.materials.size()});
        Material& material = m_row.materials.emplace_back(materialOf(shown, name, m_options, m_format, to, m_files));
        if (!isFirst) material.name += "_" + tree.name;
        return m_row.materials.size() - 1;
    }

    struct Known {
        std::string name;
        fs::path picture;
        std::size_t material;
    };
    const ExportOptions& m_options;
    const Format& m_format;
    const fs::path &m_treeFolder, m_path;
    CFileSet& m_files;
    ExportModel m_row;
    std::vector<Known> m_known;
};

/// Before anything grows: all together.
void refuseTooLarge(std::span<const RowTree> trees, const Detail& detail, const SizeLimits& limits,
                    const CProgress& progress) {
    Prediction all{};
    for (const RowTree& tree : trees) {
        const Prediction one = predictSize(tree.params, tree.detail ? *tree.detail : detail, progress);
        all.stems += one.stems;
        all.vertices += one.vertices;
        all.bytes += one.bytes;
    }
    if (!limits.allow(all)) throw CTooLarge(all, limits);
}

void writeRow(std::span<const RowTree> trees, const Detail& detail, const ExportOptions& options,
              const SizeLimits& limits, const fs::path& treeFolder, const fs::path& path, CFileSet& files,
              const CProgress& progress) {
    const Format& format = *formatOf(path);
    CRowMaker maker(options, format, treeFolder, path, files);
    const double count = double(std::max<std::size_t>(1, trees.size()));
    const SizeLimits each{limits.vertices / count, limits.bytes / count}; // of what displacement adds
    for (const RowTree& tree : trees) {
        CTreeCreator creator(true, limits);
        creator.setAge(tree.age);
        auto model = creator.create(tree.params, tree.detail ? *tree.detail : detail, progress, CTreeCreator::Plans::Keep);
        model = finishedModel(model, options, treeFolder, each, progress);
        maker.add(tree, model, progress);
    }
    if (maker.row().meshes.empty())
        throw CError(translated(NC_("stromar", "the tree is empty, there is nothing to export")));
    format.write(maker.row(), path, files);
}
} // namespace

std::string_view rowConflictOf(const ExportOptions& options, const Format& format) {
    if (const std::string_view conflict = conflictOf(options, format); !conflict.empty()) return conflict;
    if (options.lods == static_cast<int>(ExportedLods::InOneFile))
        return NC_("stromar", "a row of trees has a file for each level of detail; choose that or one level");
    if (options.wind != static_cast<int>(ExportedWind::None))
        return NC_("stromar", "a row of trees stands still; choose one tree or no wind");
    if (options.collision != static_cast<int>(ExportedCollision::None))
        return NC_("stromar", "a row of trees has no collision; choose one tree or none");
    if (options.impostor != static_cast<int>(ExportedImpostor::None))
        return NC_("stromar", "a row of trees has no impostor; choose one tree or none");
    return {};
}

void exportRow(std::span<const RowTree> trees, const ExportOptions& options, const SizeLimits& limits,
               const fs::path& treeFolder, const fs::path& path, const CProgress& progress) {
    refuseUnless(options, formatOf(path), path);
    if (const std::string_view conflict = rowConflictOf(options, *formatOf(path)); !conflict.empty())
        throw CError(translated(conflict, formatOf(path)->ending));
    const std::vector<const Detail*> details = detailsOf(options);
    const bool ownDetails = std::ranges::any_of(trees, [](const RowTree& tree) { return tree.detail != nullptr; });
    CFileSet files(progress);
    for (std::size_t i = 0; i < (ownDetails ? 1 : details.size()); ++i) {
        refuseTooLarge(trees, *details[i], limits, progress);
        const std::string suffix = details.size() > 1 && !ownDetails ? "_LOD" + std::to_string(i) : std::string();
        writeRow(trees, *details[i], options, limits, treeFolder, withSuffix(path, suffix), files, progress);
    }
    files.commit();
}

} // namespace stromar
