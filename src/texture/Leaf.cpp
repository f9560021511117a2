#include "stromar/texture/Leaf.h"
#include "LeafShape.h"
#include "Relief.h"
#include "TileNoise.h"
#include "stromar/texture/Opacity.h"
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>
#include <vector>

namespace stromar {

namespace {
constexpr int kCells = 24;       // a side of the card has, where blades are looked up
using Tissue = Blade::Tissue;

/// What is known of one pixel while blades are laid upon each other.
struct Layered {
    int layer = -1;
    double inside = -1; ///< from the margin, in lengths of the card
    double opacity = 0, height = 0, roughness = 0.6, translucency = 0;
    glm::dvec3 colour{0}, back{0};
};

/// A place on a blade.
struct Place {
    double along, side; ///< 0..1 from foot to tip; distance from the midrib in lengths of the card
    double half;        ///< of the blade there
    bool left;
};

/// Which blades may show in a cell of the card.
class CBladeGrid {
public:
    CBladeGrid(std::vector<Blade> blades, double width, double margin) : m_blades(std::move(blades)), m_width(width), m_cells(kCells * kCells) {
        for (const Blade& blade : m_blades) add(blade, margin);
    }

    /// From the lowest to the highest.
    std::span<const Blade* const> at(const glm::dvec2& p) const { return m_cells[static_cast<std::size_t>(row(p.y) * kCells + column(p.x))]; }

private:
    static int cell(double part) { return static_cast<int>(std::clamp(part * kCells, 0.0, kCells - 1.0)); }
    int column(double x) const { return cell(x / m_width + 0.5); }
    static int row(double y) { return cell(y); }

    void add(const Blade& blade, double margin) {
        const glm::dvec2 axis(std::sin(blade.turn), std::cos(blade.turn)), low = blade.foot - 0.05 * blade.length * axis,
                         high = blade.foot + 1.05 * blade.length * axis;
        const double aside = blade.half + margin + 1.1025 * std::abs(blade.bend) * blade.length;
        const glm::dvec2 min = glm::min(low, high) - aside, max = glm::max(low, high) + aside;
        for (int y = row(min.y); y <= row(max.y); ++y)
            for (int x = column(min.x); x <= column(max.x); ++x) m_cells[static_cast<std::size_t>(y * kCells + x)].push_back(&blade);
    }

    std::vector<Blade> m_blades;
    double m_width;
    std::vector<std::vector<const Blade*>> m_cells;
};

class CLeafPainter {
public:
    CLeafPainter(const LeafParams& leaf, int size)
        : m_leaf(leaf), m_size(size), m_cloud(seed(), 11), m_fine(seed(), 12), m_cells(seed(), 13),
          m_blades(bladesOf(leaf), leaf.width, pixel()) {}

    Layered at(int x, int y) const {
        const glm::dvec2 uv((x + 0.5) / m_size, (m_size - 1 - y + 0.5) / m_size);
        const glm::dvec2 p((uv.x - 0.5) * m_leaf.width, uv.y);
        Layered here;
        for (const Blade* blade : m_blades.at(p)) lay(*blade, p, here);
        return here;
    }

private:
    std::uint64_t seed() const { return static_cast<std::uint64_t>(m_leaf.seed); }
    double pixel() const { return std::max(1.0, m_leaf.width) / m_size; }

    /// The blade's half width; lobes and teeth lean forwards.
    static double halfWidth(const Blade& blade, double t, bool left) {
        if (t <= 0 || t >= 1) return 0;
        const double quarter = std::numbers::pi / 2;
        double half = t < blade.peak ? std::pow(std::sin(quarter * t / blade.peak), blade.base)
                                     : std::pow(std::cos(quarter * (t - blade.peak) / (1 - blade.peak)), blade.tip);
        if (blade.lobes > 0) {
            const double phase = blade.lobes * t + (left ? 0.0 : 0.22);
            const double bay = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * phase);
            half *= 1 - blade.lobe * (1 - std::pow(bay, 0.6)) * smoothStep(0, 0.12, t);
        }
        if (blade.teeth > 0) {
            const double run = blade.teeth * t + (left ? 0.0 : 0.4), saw = run - std::floor(run);
            half *= 1 - blade.tooth * (1 - saw) * (1 - 0.6 * saw);
        }
        return blade.half * half;
    }

    void lay(const Blade& blade, const glm::dvec2& p, Layered& here) const {
        const glm::dvec2 axis(std::sin(blade.turn), std::cos(blade.turn)), way = p - blade.foot;
        const double along = glm::dot(way, axis) / blade.length;
        if (along < -0.05 || along > 1.05) return;
        const double across = way.x * axis.y - way.y * axis.x - blade.bend * along * along * blade.length;
        const double reach = blade.half + pixel();
        if (std::abs(across) > reach) return;
        const bool left = across < 0;
        const double lean = blade.slant * std::abs(across) / blade.length;
        const bool cut = blade.lobes > 0 || blade.teeth > 0;
        const double t = cut ? along - lean * (1 - along * along) : along;
        const double half = halfWidth(blade, t, left), next = halfWidth(blade, t + 0.004, left);
        const double steep = (next - half) / (0.004 * blade.length);
        const double inside = (half - std::abs(across)) / std::sqrt(1 + std::min(9.0, steep * steep));
        const double cover = std::clamp(inside / pixel() + 0.5, 0.0, 1.0);
        if (cover <= 0) return;
        const bool above = blade.layer > here.layer;
        if (!above && inside <= here.inside) return;
        put(blade, {along, std::min(std::abs(across), half), std::max(half, 1e-6), left}, p, cover, inside, above,
            here);
    }

    void put(const Blade& blade, const Place& place, const glm::dvec2& p, double cover, double inside, bool above,
             Layered& here) const {
        Layered own;
        switch (blade.tissue) {
        case Tissue::Lamina: own = lamina(blade, place, p, inside); break;
        case Tissue::Stalk: own = stalk(blade, place); break;
        case Tissue::Petal: own = petal(blade, place, p); break;
        case Tissue::Anther: own = anther(); break;
        }
        const double share = here.opacity <= 0 ? 1 : above ? cover : 1;
        const double tone = 1 + (blade.tissue == Tissue::Petal ? 0.1 : 0.3) * blade.tone;
        here.colour = mixed(here.colour, tone * own.colour, share);
        here.back = mixed(here.back, tone * own.back, share);
        here.height += share * (own.height + 0.12 * blade.layer - here.height);
        here.roughness += share * (own.roughness - here.roughness);
        here.translucency += share * (own.translucency - here.translucency);
        here.opacity = std::max(here.opacity, cover);
        if (cover > 0.5 || here.layer < 0) {
            here.layer = blade.layer;
            here.inside = inside;
        }
    }

    /// 0 on the blade, 1 on a side vein; they leave the midrib in turns and bend up to the margin.
    double sideVein(const Blade& blade, const Place& place) const {
        if (blade.veins == 0) return 0;
        const double out = place.side / blade.length;
        const double run = blade.veins * (place.along - 0.75 * out - 0.6 * out * out) + (place.left ? 0 : 0.4);
        const double off = std::abs(run - std::floor(run) - 0.5) / blade.veins * blade.length;
        const double thick = std::max(0.0045 * blade.length * (1.2 - 0.7 * place.side / place.half), 0.6 * pixel());
        return std::exp(-off * off / (thick * thick)) * smoothStep(1.0, 0.85, place.side / place.half);
    }

    double midrib(const Blade& blade, const Place& place) const {
        const double thick = std::max(0.011 * blade.length * (1.15 - place.along), 0.5 * pixel());
        return blade.veins == 0 ? 0 : std::exp(-place.side * place.side / (thick * thick));
    }

    /// Of the green, 1 in summer; gone first far from the veins and at the margin.
    double greenLeft(const Place& place, double veins, double cloud) const {
        const double autumn = (m_leaf.season - kGreenUntil) / 1.7;
        if (autumn <= 0) return 1;
        const double late = 0.35 * cloud + 0.3 * veins - 0.2 * place.side / place.half;
        return 1 - smoothStep(-0.15, 0.25, autumn - 0.5 - late);
    }

    Layered lamina(const Blade& blade, const Place& place, const glm::dvec2& p, double inside) const {
        const double cloud = m_cloud.octaves(p * 7.0 + 40.0, {64, 64}, 3);
        const double fine = m_fine.octaves(p * 60.0 + 200.0, {1024, 1024}, 2);
        const double side = sideVein(blade, place), middle = midrib(blade, place);
        const double vein = std::max(0.75 * side, middle);
        const double net = blade.veins > 0 ? netOf(blade, p) : 0;
        const double green = greenLeft(place, vein, cloud);
        const glm::dvec3 summer = rgb(m_leaf.green), young(1.18 * summer.x + 22, 1.12 * summer.y + 26, 0.9 * summer.z);
        const glm::dvec3 full = mixed(summer, young, smoothStep(kGreenFrom, 4.3, m_leaf.season));
        const glm::dvec3 turned =
            mixed(rgb(m_leaf.autumn), rgb(m_leaf.autumn) * glm::dvec3(0.86, 0.7, 0.7), 0.5 + 1.6 * cloud);
        glm::dvec3 colour = mixed(turned, full, green);
        colour *= 1 + 0.3 * cloud + 0.16 * fine + 0.05 * (place.left ? 1 : -1);
        colour = mixed(colour, rgb(m_leaf.vein), (0.42 * side + 0.8 * middle + 0.08 * net) * (0.45 + 0.55 * green));
        const double worn = blemish(p, inside);
        colour = mixed(colour, {104, 78, 44}, 0.85 * worn);
        if (m_leaf.season > 10)
            colour = mixed(colour, {122, 84, 48}, 0.7 * smoothStep(0.03, 0, inside) * (m_leaf.season - 10));
        Layered own;
        own.colour = colour;
        const double mean = (colour.x + colour.y + colour.z) / 3;
        own.back = mixed(mixed(colour, glm::dvec3(mean), 0.35) * 1.12 + 14.0, rgb(m_leaf.vein), 0.5 * vein);
        const double across = place.side / place.half;
        own.height = 0.55 - 0.2 * across * across - 0.2 * middle - 0.12 * side - 0.03 * net + 0.05 * fine;
        own.roughness = std::clamp(0.78 - 0.45 * m_leaf.gloss + 0.1 * vein + 0.2 * worn + 0.08 * fine, 0.1, 1.0);
        own.translucency = std::clamp(0.78 - 0.45 * middle - 0.25 * side - 0.5 * worn + 0.12 * (1 - green), 0.0, 1.0);
        return own;
    }

    /// The finest veins, between cells.
    double netOf(const Blade& blade, const glm::dvec2& p) const {
        const double cells = 26 / std::max(0.2, blade.length);
        const CTileNoise::Cell cell = m_cells.cell(p * cells + 300.0, {4096, 4096}, 0.9);
        return 1 - smoothStep(0.02, 0.2, cell.second - cell.nearest);
    }

    double blemish(const glm::dvec2& p, double inside) const {
        if (m_leaf.spots <= 0) return 0;
        const CTileNoise::Cell cell = m_cells.cell(p * 9.0 + 77.0, {4096, 4096}, 0.9);
        double worn = 0;
        if (m_cells.uniform(cell.id, 2) < 0.5 * m_leaf.spots) {
            const double size = 0.05 + 0.16 * m_cells.uniform(cell.id, 3);
            worn = smoothStep(size, 0.6 * size, cell.nearest + 0.04 * m_fine.octaves(p * 50.0 + 90.0, {1024, 1024}, 2));
        }
        const double edge = m_cloud.octaves(p * 5.0 + 17.0, {64, 64}, 2) - 0.55 + 0.5 * m_leaf.spots;
        return std::max(worn, 0.8 * smoothStep(0.0, 0.15, edge) * smoothStep(0.03, 0.005, inside));
    }

    Layered stalk(const Blade&, const Place& place) const {
        Layered own;
        own.colour = own.back = rgb(m_leaf.vein) * (0.95 - 0.25 * place.side / place.half);
        own.height = 0.5 + 0.3 * std::sqrt(std::max(0.0, 1 - place.side * place.side / (place.half * place.half)));
        own.roughness = 0.6;
        own.translucency = 0.15;
        return own;
    }

    Layered petal(const Blade& blade, const Place& place, const glm::dvec2& p) const {
        const double fine = m_fine.octaves(p * 40.0 + 200.0, {1024, 1024}, 2);
        const double streak = sideVein(blade, place);
        Layered own;
        own.colour = mixed(rgb(m_leaf.green), rgb(m_leaf.vein), smoothStep(0.5, 0.0, place.along) + 0.25 * streak);
        own.colour *= 0.97 + 0.05 * fine - 0.05 * place.side / place.half;
        own.back = own.colour * 0.96;
        own.height = 0.4 + 0.2 * place.along - 0.1 * streak;
        own.roughness = 0.75;
        own.translucency = 0.8;
        return own;
    }

    static Layered anther() {
        Layered own;
        own.colour = own.back = {222, 186, 70};
        own.height = 0.8;
        own.roughness = 0.8;
        own.translucency = 0.2;
        return own;
    }

    LeafParams m_leaf;
    int m_size;
    CTileNoise m_cloud, m_fine, m_cells;
    CBladeGrid m_blades;
};

std::array<std::uint8_t, 4> bytes(const glm::dvec3& colour, double opacity) {
    return {toByte(colour.x), toByte(colour.y), toByte(colour.z), toByte(255 * opacity)};
}
} // namespace

TextureMaps makeLeaf(const LeafParams& leaf, int size, const CProgress& progress) {
    const CLeafPainter painter(leaf, size);
    TextureMaps maps = squareMaps(size);
    maps.translucency.resize(maps.albedo.size());
    maps.back.resize(maps.albedo.size());
    std::vector<double> heights(maps.albedo.size());
    forEachPixel(size, progress, [&](int x, int y) {
        const Layered here = painter.at(x, y);
        const std::size_t i = maps.at(x, y);
        heights[i] = here.opacity > 0 ? here.height : 0.5;
        maps.albedo[i] = bytes(here.colour, here.opacity);
        maps.back[i] = bytes(here.back, here.opacity);
        maps.roughness[i] = toByte(255 * here.roughness);
        maps.translucency[i] = toByte(255 * here.translucency);
        maps.height01[i] = toByte(255 * heights[i]);
    });
    addNormals(maps, heights, kLeafRelief, progress);
    spreadMaps(maps);
    return maps;
}

} // namespace stromar
