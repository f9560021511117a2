#include "stromar/texture/Bark.h"
#include "stromar/util/Turn.h"
#include "Relief.h"
#include "TileNoise.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace stromar {

namespace {

/// One place of a bark.
struct Sample {
    double height; ///< 0..1
    glm::dvec3 colour;
    double roughness;
};

/// All kinds as functions of a place in the tile, 0..1 in both directions, v up the stem.
class CBarkMaker {
public:
    explicit CBarkMaker(const BarkParams& bark)
        : m_bark(bark), m_coarse(seed(), 1), m_fine(seed(), 2), m_cells(seed(), 3), m_spots(seed(), 4),
          m_light(rgb(bark.light)), m_dark(rgb(bark.dark)),
          m_grid(bark.ridges, std::max(1, static_cast<int>(std::lround(bark.ridges / bark.stretch)))) {}

    Sample at(const glm::dvec2& uv) const {
        switch (m_bark.kind) {
        case 1: return plated(uv);
        case 2: return smooth(uv);
        case 3: return birch(uv);
        case 4: return willow(uv);
        case 5: return cherry(uv);
        case 6: return palm(uv);
        default: return furrowed(uv, 0);
        }
    }

private:
    std::uint64_t seed() const { return static_cast<std::uint64_t>(m_bark.seed); }

    double noise(const CTileNoise& source, const glm::dvec2& uv, glm::ivec2 cells, int octaves) const {
        return source.octaves(uv * glm::dvec2(cells), cells, octaves);
    }
    /// The same place after the wood has wandered, in cells of the grid.
    glm::dvec2 wandered(const glm::dvec2& uv, double by) const {
        const glm::ivec2 slow(std::max(1, m_grid.x / 2), std::max(1, m_grid.y));
        const glm::dvec2 shift(noise(m_coarse, uv, slow, 3), noise(m_fine, uv, slow, 2));
        return uv * glm::dvec2(m_grid) + by * shift;
    }
    double grain(const glm::dvec2& uv) const { return m_bark.grain * noise(m_fine, uv, {48, 48}, 4); }

    /// 0 in a crack, 1 on the wood: cracks run where the noise changes its sign.
    double cracks(const CTileNoise& source, const glm::dvec2& place, glm::ivec2 cells, double width,
                  double ragged) const {
        const double signed_ = source.octaves(place, cells, 2) + ragged;
        return smoothStep(0, 1, std::abs(signed_) / std::max(0.01, width));
    }

    /// Ridges between cracks that join and part again; `braid` crosses them as in willows.
    Sample furrowed(const glm::dvec2& uv, double braid) const {
        const double fine = noise(m_fine, uv, m_grid * 8, 4),
                     fibre = noise(m_spots, uv, {m_grid.x * 10, m_grid.y * 3}, 3);
        glm::dvec2 place = wandered(uv, 0.45 * m_bark.warp);
        place.x += braid * std::sin(2 * kTurn * uv.y + 2 * std::sin(kTurn * uv.x));
        const double ragged = 0.07 * fine + 0.03 * fibre;
        const double wide = cracks(m_cells, place, m_grid, 0.3 * m_bark.crack, ragged);
        const double split = cracks(m_coarse, 2.0 * place, 2 * m_grid, 0.16 * m_bark.crack, 1.2 * ragged);
        // Ridges break across.
        const glm::ivec2 across(m_grid.x, m_grid.y * 6);
        const double broken = cracks(m_spots, uv * glm::dvec2(across), across, 0.05, 0.1 * fine);
        const double ridge = std::pow(wide, 0.8) * (0.5 + 0.3 * split + 0.2 * broken);
        const double rough = m_bark.grain * fine;
        const double height = ridge * 0.85 + 0.25 * rough + 0.06 * fibre;
        const double tone = 0.8 * ridge * (0.75 + 0.25 * broken) + 0.7 * rough + 0.25 * fibre + 0.05;
        const glm::dvec3 tint =
            mixed(m_light, {0.9 * m_light.x + 18, 0.95 * m_light.y + 10, m_light.z}, noise(m_coarse, uv, {2, 2}, 3));
        return {height, mixed(m_dark, tint, tone), 0.92};
    }

    Sample willow(const glm::dvec2& uv) const { return furrowed(uv, 0.3); }

    /// Plates of thin scales that flake off one above the other.
    Sample plated(const glm::dvec2& uv) const {
        const double fine = noise(m_fine, uv, m_grid * 8, 4);
        const glm::dvec2 place = wandered(uv, 0.55 * m_bark.warp);
        const CTileNoise::Cell cell = m_cells.cell(place + 0.09 * fine, m_grid, 0.85);
        const double edge = cell.second - cell.nearest + 0.16 * fine;
        const double plate = smoothStep(0, std::max(0.05, m_bark.crack), edge);
        const double scales =
            2.2 * noise(m_coarse, uv, {m_grid.x * 2, m_grid.y * 3}, 3) + m_cells.uniform(cell.id, 3) + 0.3 * fine;
        const double level = std::floor(scales * 2.5), in = scales * 2.5 - level; // each scale lies flat
        const double rim = smoothStep(0, 0.22, in), rough = m_bark.grain * fine;
        const double height = plate * (0.6 + 0.09 * level + 0.06 * rim) + 0.12 * rough;
        const std::uint64_t scale = hashCombine(cell.id, static_cast<std::uint64_t>(static_cast<int>(level) + 64));
        const glm::dvec3 grey(0.55 * m_light.x + 52, 0.66 * m_light.y + 46, 0.75 * m_light.z + 42);
        const glm::dvec3 own =
            mixed(m_light, grey, m_cells.uniform(scale, 4)) * (0.85 + 0.2 * m_cells.uniform(scale, 5));
        return {height, mixed(m_dark, own, plate * (0.62 + 0.38 * rim) + 0.45 * rough), 0.9};
    }

    /// Skin with pores, and with eyes where branches fell off.
    Sample smooth(const glm::dvec2& uv) const {
        const double cloud = noise(m_coarse, uv, {3, 4}, 4), rough = grain(uv);
        const double stripes = noise(m_fine, uv, {4, 40}, 2);
        double height = 0.5 + 0.1 * cloud + 0.05 * rough + 0.03 * stripes;
        glm::dvec3 colour = mixed(m_light, m_dark, 0.14 + 0.45 * cloud + 0.45 * rough + 0.14 * stripes);
        const double pore = spot(uv, {0.34, 0.1}, 0.8);
        height += 0.18 * pore;
        colour = mixed(colour, m_dark, 0.75 * pore);
        const glm::ivec2 few(2, 2);
        const CTileNoise::Cell eye = m_cells.cell(uv * glm::dvec2(few), few, 0.8);
        const double reach = glm::length(eye.offset * glm::dvec2(5.5, 9)) + 0.25 * noise(m_fine, uv, {12, 12}, 3);
        if (m_bark.spots > 0 && m_cells.uniform(eye.id, 5) < 0.7) {
            const double inside = 1 - smoothStep(0.55, 0.75, reach),
                         brow = std::exp(-8 * (reach - 0.9) * (reach - 0.9));
            height += 0.3 * brow - 0.25 * inside;
            colour = mixed(colour, m_dark * 0.75, 0.85 * inside + 0.35 * brow);
        }
        return {height, colour, 0.75};
    }

    /// How much a place belongs to a pore; `half` its half axes in cells, `often` how many cells have one.
    double spot(const glm::dvec2& uv, const glm::dvec2& half, double often) const {
        if (m_bark.spots == 0) return 0;
        const int across = std::max(1, static_cast<int>(std::lround(std::sqrt(m_bark.spots / 2.0))));
        const glm::ivec2 cells(across, 2 * across);
        const CTileNoise::Cell cell = m_spots.cell(uv * glm::dvec2(cells), cells, 0.75);
        if (m_spots.uniform(cell.id, 6) > often) return 0;
        const double size = 0.35 + 0.5 * m_spots.uniform(cell.id, 7); // inside its cell
        const double ragged = 0.25 * noise(m_fine, uv, cells * 8, 2);
        return 1 - smoothStep(0.6, 1, glm::length(cell.offset / (half * size)) + ragged);
    }

    /// White skin that peels in bands, dashes of pores, black scars.
    Sample birch(const glm::dvec2& uv) const {
        const double cloud = noise(m_coarse, uv, {3, 3}, 4), rough = grain(uv);
        const double run =
            uv.y * m_bark.rings + 0.5 * m_bark.warp * noise(m_coarse, uv, {3, std::max(1, m_bark.rings)}, 3);
        const double sheet = run - std::floor(run);
        const double torn = smoothStep(0.1, 0.5, noise(m_fine, uv, {6, std::max(1, m_bark.rings)}, 3));
        const double lip = torn * std::exp(-60 * sheet * sheet), below = torn * smoothStep(0.75, 1, sheet);
        double height = 0.55 + 0.06 * cloud + 0.04 * rough + 0.3 * lip - 0.08 * below;
        glm::dvec3 colour = mixed(m_light, mixed(m_light, m_dark, 0.25), 0.35 + 0.8 * cloud + 0.6 * rough);
        colour = mixed(colour, {204, 160, 122}, 0.5 * below + 0.15 * lip);
        const double dash = spot(uv, {0.56, 0.06}, 0.85);
        height += 0.08 * dash;
        colour = mixed(colour, m_dark, 0.8 * dash);
        const glm::ivec2 few(2, 3);
        const CTileNoise::Cell scar = m_cells.cell(uv * glm::dvec2(few), few, 0.7);
        const double wild = noise(m_fine, uv, {14, 20}, 4);
        const double diamond = std::abs(scar.offset.x) * 3.2 + std::abs(scar.offset.y) * 6.5 + 0.45 * wild;
        if (m_cells.uniform(scar.id, 5) < 0.45) {
            const double black = 1 - smoothStep(0.7, 0.95, diamond);
            height += black * (0.25 * wild - 0.1);
            colour = mixed(colour, m_dark * (0.7 + 0.5 * wild), black);
        }
        return {height, colour, 0.7};
    }

    /// Glossy bands with rows of pores.
    Sample cherry(const glm::dvec2& uv) const {
        const double cloud = noise(m_coarse, uv, {2, 5}, 4), rough = grain(uv);
        const double run =
            uv.y * m_bark.rings + 0.3 * m_bark.warp * noise(m_coarse, uv, {2, std::max(1, m_bark.rings)}, 3);
        const double band = 0.5 + 0.5 * std::sin(kTurn * run);
        const double streak = noise(m_fine, uv, {3, 60}, 3);
        double height = 0.45 + 0.12 * band + 0.05 * cloud + 0.05 * rough + 0.04 * streak;
        glm::dvec3 colour = mixed(m_dark, m_light, 0.35 + 0.3 * band + 0.5 * cloud + 0.35 * streak + 0.4 * rough);
        const double pore = spot(uv, {0.56, 0.09}, 0.8);
        height += 0.3 * pore;
        colour = mixed(colour, mixed(m_light, {206, 170, 134}, 0.7), 0.85 * pore);
        return {height, colour, 0.45 + 0.35 * pore + 0.2 * band};
    }

    /// Scars of fallen fronds above each other, and fibres.
    Sample palm(const glm::dvec2& uv) const {
        const int rings = std::max(1, m_bark.rings);
        const double run = uv.y * rings + 0.35 * m_bark.warp * noise(m_coarse, uv, {4, rings}, 3);
        const double rise = run - std::floor(run);
        const double scar = 1 - smoothStep(0, 0.12 + 0.2 * m_bark.crack, std::min(rise, 1 - rise));
        const double fibre = noise(m_fine, uv, {m_bark.ridges * 3, rings * 2}, 4);
        const glm::ivec2 splits(m_bark.ridges, rings);
        const double split = cracks(m_cells, uv * glm::dvec2(splits), splits, 0.2, 0.1 * fibre);
        const double rough = grain(uv);
        const double height = 0.3 + 0.4 * rise - 0.3 * scar + 0.14 * split + 0.12 * rough + 0.2 * fibre;
        return {height,
                mixed(m_dark, m_light, 0.35 + 0.2 * rise - 0.7 * scar + 0.3 * split + 0.6 * fibre + 0.3 * rough), 0.9};
    }

    BarkParams m_bark;
    CTileNoise m_coarse, m_fine, m_cells, m_spots;
    glm::dvec3 m_light, m_dark;
    glm::ivec2 m_grid;
};

} // namespace

TextureMaps makeBark(const BarkParams& bark, int size, const CProgress& progress) {
    const CBarkMaker maker(bark);
    TextureMaps maps = squareMaps(size);
    std::vector<double> heights(maps.albedo.size());
    forEachPixel(size, progress, [&](int x, int y) {
        const Sample here = maker.at({(x + 0.5) / size, (size - 1 - y + 0.5) / size});
        const std::size_t i = maps.at(x, y);
        heights[i] = here.height;
        maps.albedo[i] = {toByte(here.colour.x), toByte(here.colour.y), toByte(here.colour.z), 255};
        maps.roughness[i] = toByte(255 * here.roughness);
        maps.height01[i] = toByte(255 * here.height);
    });
    addNormals(maps, heights, reliefOf(bark), progress);
    return maps;
}

} // namespace stromar
