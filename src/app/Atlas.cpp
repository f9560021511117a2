#include "Atlas.h"
#include "ContentHash.h"
#include "stromar/app/Pictures.h"
#include "stromar/texture/PictureSize.h"
#include "stromar/texture/TextureMaps.h"
#include "stromar/util/Error.h"
#include "stromar/util/FileSet.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>

namespace stromar {

namespace fs = std::filesystem;

namespace {
constexpr int kAtlasVersion = 1;        // rises when the same is drawn differently
constexpr int kMarginsOfCell = 64; // a margin is one of so many parts of a cell
constexpr float kBeyond = 1e-3f;   // rounding of texture coordinates

std::string stateOf(const fs::path& file) {
    std::error_code problem; // reading says it better
    const auto written = fs::last_write_time(file, problem).time_since_epoch().count();
    return fs::absolute(file).string() + ' ' + std::to_string(written) + ' ' + std::to_string(fs::file_size(file, problem));
}

/// A map that files show, and what a picture without it has.
struct Neutral {
    std::string_view suffix;
    std::array<std::uint8_t, 3> value;
};
constexpr Neutral kNeutral[] = {{"_normal", {128, 128, 255}}, {"_roughness", {179}}}; // 0.7, as materials of leaves have

const MapFile* mapFileOf(std::string_view suffix) {
    return &*std::ranges::find_if(mapFiles(), [&](const MapFile& one) { return one.suffix == suffix; });
}

/// The mean of what a pixel of a cell covers. Beyond its edge a picture runs on.
class CCellSampler {
public:
    CCellSampler(const TextureMaps& maps, int cell) : m_maps(maps), m_margin(cell / kMarginsOfCell) {
        const int inner = cell - 2 * m_margin;
        m_step = {double(maps.width) / inner, double(maps.height) / inner};
        m_samples = {std::max(1, int(std::ceil(m_step.x))), std::max(1, int(std::ceil(m_step.y)))};
    }

    double at(const std::uint8_t* pixels, std::size_t channels, std::size_t channel, int x, int y) const {
        double sum = 0;
        for (int j = 0; j < m_samples.y; ++j)
            for (int i = 0; i < m_samples.x; ++i)
                sum += between(pixels, channels, channel, (x - m_margin + (i + 0.5) / m_samples.x) * m_step.x - 0.5, (y - m_margin + (j + 0.5) / m_samples.y) * m_step.y - 0.5);
        return sum / (m_samples.x * m_samples.y);
    }

private:
    double between(const std::uint8_t* pixels, std::size_t channels, std::size_t channel, double x, double y) const {
        const int left = int(std::floor(x)), top = int(std::floor(y));
        const auto pixel = [&](int px, int py) {
            return double(pixels[m_maps.at(std::clamp(px, 0, m_maps.width - 1), std::clamp(py, 0, m_maps.height - 1)) * channels + channel]);
        };
        const double right = x - left, below = y - top;
        return (1 - below) * ((1 - right) * pixel(left, top) + right * pixel(left + 1, top)) +
               below * ((1 - right) * pixel(left, top + 1) + right * pixel(left + 1, top + 1));
    }

    const TextureMaps& m_maps;
    int m_margin;
    glm::dvec2 m_step;
    glm::ivec2 m_samples;
};

/// Draws cells of pictures, one picture after the other: each may be as large as pictures may be.
class CAtlasPainter {
public:
    CAtlasPainter(const glm::ivec2& cells, int cell, const std::vector<SurfacePicture>& pictures, const CProgress& progress)
        : m_cells(cells), m_cell(cell), m_progress(progress) {
        m_atlas.width = m_cells.x * m_cell;
        m_atlas.height = m_cells.y * m_cell;
        m_atlas.albedo.resize(static_cast<std::size_t>(m_atlas.width) * static_cast<std::size_t>(m_atlas.height));
        for (const Neutral& neutral : kNeutral) {
            if (std::ranges::none_of(pictures, [&](const SurfacePicture& one) { return fs::exists(mapBeside(one.file, neutral.suffix)); })) continue;
            const MapFile& map = *mapFileOf(neutral.suffix);
            m_maps.push_back(&map);
            std::uint8_t* values = map.room(m_atlas);
            for (std::size_t i = 0; i < m_atlas.albedo.size(); ++i)
                for (std::size_t c = 0; c < static_cast<std::size_t>(map.channels); ++c) *values++ = neutral.value[c];
        }
    }

    void draw(std::size_t i, const TextureMaps& source) {
        const CCellSampler sampler(source, m_cell);
        drawLayer(i, sampler, 4, reinterpret_cast<const std::uint8_t*>(source.albedo.data()), reinterpret_cast<std::uint8_t*>(m_atlas.albedo.data()));
        for (const MapFile* map : m_maps)
            if (const std::uint8_t* pixels = map->pixels(source)) drawLayer(i, sampler, static_cast<std::size_t>(map->channels), pixels, map->room(m_atlas));
    }

    const TextureMaps& atlas() const { return m_atlas; }

private:
    void drawLayer(std::size_t i, const CCellSampler& sampler, std::size_t channels, const std::uint8_t* pixels, std::uint8_t* out) const {
        const int left = static_cast<int>(i) % m_cells.x * m_cell, top = static_cast<int>(i) / m_cells.x * m_cell;
        for (int y = 0; y < m_cell; ++y) {
            m_progress.poll();
            for (int x = 0; x < m_cell; ++x)
                for (std::size_t c = 0; c < channels; ++c)
                    out[m_atlas.at(left + x, top + y) * channels + c] = static_cast<std::uint8_t>(std::lround(sampler.at(pixels, channels, c, x, y)));
        }
    }

    glm::ivec2 m_cells;
    int m_cell;
    const CProgress& m_progress;
    TextureMaps m_atlas;
    std::vector<const MapFile*> m_maps; ///< that some of the pictures have
};
} // namespace

CAtlas::CAtlas(std::vector<SurfacePicture> pictures, const CProgress& progress) : m_pictures(std::move(pictures)) {
    std::string state = std::to_string(kAtlasVersion);
    for (const SurfacePicture& one : m_pictures) {
        if (!isPng(one.file)) throw CError(translated(NC_("stromar", "only PNG textures can go into an atlas, not %1"), one.file.string()));
        state += '\n' + stateOf(one.file);
    }
    m_file = pictureCache() / "atlases" / (nameOfHash(hashOfText(state)) + ".png");
    if (!isKept(m_file)) draw(progress);
}

void CAtlas::draw(const CProgress& progress) const {
    int cell = 1;
    for (const SurfacePicture& one : m_pictures) cell = std::max(cell, longerSideOf(one.file));
    CAtlasPainter painter(cells(), std::min(cell, kMaxCell), m_pictures, progress);
    for (std::size_t i = 0; i < m_pictures.size(); ++i) painter.draw(i, readPngs(m_pictures[i].file));
    std::error_code problem; // writing says it better
    fs::create_directories(m_file.parent_path(), problem);
    CFileSet files(progress);
    writePngs(painter.atlas(), m_file, files);
    files.commit();
}

glm::ivec2 CAtlas::cells() const {
    const auto count = static_cast<unsigned>(m_pictures.size());
    const int across = count <= 4 ? 2 : 4; // widths and heights that graphics cards like
    return {across, static_cast<int>(std::bit_ceil((count + static_cast<unsigned>(across) - 1) / static_cast<unsigned>(across)))};
}

glm::vec2 CAtlas::placeOf(std::size_t cell, const glm::vec2& texCoord) const {
    const glm::ivec2 all = cells();
    const glm::vec2 column(static_cast<float>(cell % static_cast<std::size_t>(all.x)), static_cast<float>(cell / static_cast<std::size_t>(all.x)));
    constexpr float kMargin = 1.0f / kMarginsOfCell;
    const glm::vec2 inside = kMargin + (1 - 2 * kMargin) * glm::clamp(texCoord, 0.0f, 1.0f);
    return {(column.x + inside.x) / float(all.x), 1 - (column.y + 1 - inside.y) / float(all.y)};
}

std::shared_ptr<const CMesh> CAtlas::moved(const CMesh& mesh, std::size_t cell) const {
    auto copy = std::make_shared<CMesh>(mesh);
    copy->surface = Surface::Leaf;
    for (glm::vec2& t : copy->texCoords) {
        if (glm::clamp(t, -kBeyond, 1 + kBeyond) != t)
            throw CError(translated(NC_("stromar", "%1 repeats its texture (texture coordinates beyond 0 to 1), which an atlas cannot do"), mesh.name));
        t = placeOf(cell, t);
    }
    return copy;
}

void CAtlas::replaceIn(ExportModel& model, const Material& look) const {
    const auto replaceAll = [&](Meshes& meshes) {
        Meshes all;
        for (const auto& mesh : meshes) {
            const auto own = std::ranges::find(m_pictures, model.materialOf(*mesh).surface, &SurfacePicture::surface);
            all.push_back(own == m_pictures.end() ? mesh : moved(*mesh, static_cast<std::size_t>(own - m_pictures.begin())));
        }
        return all;
    };
    std::vector<Meshes> coarser;
    for (Meshes& meshes : model.coarser) coarser.push_back(replaceAll(meshes));
    model.meshes = replaceAll(model.meshes);
    model.coarser = std::move(coarser);
    std::erase_if(model.materials, [&](const Material& material) { return std::ranges::count(m_pictures, material.surface, &SurfacePicture::surface) > 0; });
    model.materials.push_back(look);
}

} // namespace stromar
