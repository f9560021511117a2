#include "stromar/mesh/LeafMeshes.h"
#include "foliage/LeafBlade.h"
#include "stromar/params/BuiltInMesh.h"
#include "stromar/util/Error.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <numbers>
#include <string>

namespace stromar {

namespace {
double curved(double, double y) { return 0.9 * y * (0.45 - y); }
double cupped(double x, double y) { return 1.1 * x * x + 0.25 * (y - 0.5) * (y - 0.5); }
double wavy(double x, double y) { return 0.35 * std::abs(x) * std::sin(3 * std::numbers::pi * y + (x < 0 ? 1.3 : 0)) - 0.3 * y * y; }
double rolled(double x, double y) { return -1.6 * x * x - 0.5 * y * y; }

/// The normal of a relief, by its slopes.
glm::dvec3 normalOf(const LeafRelief& relief, double x, double y) {
    constexpr double d = 1e-4;
    return glm::normalize(glm::dvec3(relief(x - d, y) - relief(x + d, y), relief(x, y - d) - relief(x, y + d), 2 * d));
}

template <double (*relief)(double, double)>
LeafBlade sheet(bool far) {
    return far ? bentCard(relief, {2, 2}) : bentCard(relief);
}

/// As the texture leaf:fan spreads: rays out of the end of a stalk, folded along their middle, whose tips hang.
class CFanMaker {
public:
    CFanMaker(int rays, int rings) : m_rays(rays), m_rings(rings) {}

    LeafBlade make() {
        for (int half = 0; half < 2 * m_rays; ++half) addStrip(half);
        addStrip({point(-kStalkHalf, 0), point(kStalkHalf, 0), point(-kStalkHalf, kPalm), point(kStalkHalf, kPalm)});
        return std::move(m_blade);
    }

private:
    static constexpr double kAspect = 1.4, kPalm = 0.3, kSpread = 131 * std::numbers::pi / 180; // of the texture
    static constexpr double kStalkHalf = 0.018, kFold = 0.55, kDroop = 0.55, kRim = 0.985;

    /// Between a fold and the edge beside it; strips share no vertices, so that folds stay sharp.
    void addStrip(int half) {
        std::vector<glm::dvec3> places;
        for (int ring = 0; ring <= m_rings; ++ring)
            for (const int side : {0, 1}) places.push_back(point(half + side, double(ring) / m_rings));
        addStrip(places);
    }

    /// Of a left and a right place in turn; where both are one, the strip ends in a point.
    void addStrip(const std::vector<glm::dvec3>& places) {
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool isPoint = i % 2 == 1 && places[i] == places[i - 1];
            if (!isPoint) m_blade.points.push_back(pointOf(places, i));
            corners.push_back(static_cast<std::uint32_t>(m_blade.points.size() - 1));
        }
        for (std::size_t row = 0; row + 3 < corners.size(); row += 2)
            for (const auto& [a, b, c] : {std::array{row, row + 1, row + 3}, {row, row + 3, row + 2}})
                if (corners[a] != corners[b]) m_blade.indices.insert(m_blade.indices.end(), {corners[a], corners[b], corners[c]});
    }

    static LeafBlade::Point pointOf(const std::vector<glm::dvec3>& places, std::size_t i) {
        const std::size_t row = i - i % 2, last = places.size() - 2, low = row > 0 ? i - 2 : i, high = row < last ? i + 2 : i;
        const std::size_t wide = std::max(row, std::min(row + 2, last));
        const glm::dvec3 across = places[wide + 1] - places[wide], along = places[high] - places[low];
        return {places[i], glm::normalize(glm::cross(across, along)), {places[i].x + 0.5, places[i].y}};
    }

    static glm::dvec3 point(double x, double y) { return {x / kAspect, y, 0}; }

    /// On the edge of a half ray, some part of the way out to the rim of the card.
    glm::dvec3 point(int edge, double part) const {
        const double at = double(edge) / m_rays - 1, turn = -at * kSpread, c = std::cos(turn), s = -std::sin(turn);
        double reach = kRim * (1 - kPalm);
        if (std::abs(s) > 1e-6) reach = std::min(reach, kRim * kAspect / 2 / std::abs(s));
        if (c < 0) reach = std::min(reach, kRim * kPalm / -c);
        const double out = part * reach, ray = kSpread / m_rays * std::min(out, 0.6 * reach);
        const double rise = (edge % 2 ? -0.5 : 0.5) * kFold * ray, sink = kDroop * std::pow(std::max(0.0, part - 0.45), 2) + 0.12 * at * at * part;
        return {out * s / kAspect, kPalm + out * c, (rise - sink) / kAspect};
    }

    int m_rays, m_rings;
    LeafBlade m_blade;
};
LeafBlade fan(bool far) { return (far ? CFanMaker(8, 2) : CFanMaker(34, 5)).make(); }

constexpr BuiltInLeaf kBuiltIn[] = {{"curved", N_("curved"), &sheet<curved>},
                                    {"cupped", N_("cupped"), &sheet<cupped>},
                                    {"wavy", N_("wavy"), &sheet<wavy>},
                                    {"rolled", N_("rolled"), &sheet<rolled>},
                                    {"fan", N_("fan"), &fan}};

struct Box {
    glm::dvec3 min, max;
    glm::dvec3 size() const { return max - min; }
};

Box boxOf(const LeafBlade& mesh) {
    Box box{mesh.points.front().place, mesh.points.front().place};
    for (const LeafBlade::Point& point : mesh.points) box = {glm::min(box.min, point.place), glm::max(box.max, point.place)};
    return box;
}

int thinnest(const glm::dvec3& size) {
    int axis = 2; // of equal ones the last: leaves that lie in a plane of two axes mostly face the third
    for (const int other : {1, 0})
        if (size[other] < size[axis]) axis = other;
    return axis;
}

/// Columns: across, along, up of a mesh.
glm::dmat3 axesOf(const LeafBlade& mesh, const Box& box) {
    const int up = thinnest(box.size());
    const auto reach = [&](int axis) { return std::max(std::abs(box.min[axis]), std::abs(box.max[axis])); };
    const int one = (up + 1) % 3, two = (up + 2) % 3, along = reach(one) > reach(two) ? one : two;
    glm::dvec3 facing(0), ahead(0);
    double sum = 0;
    for (const LeafBlade::Point& point : mesh.points) sum += point.normal[up];
    facing[up] = sum < 0 ? -1 : 1;
    ahead[along] = std::abs(box.min[along]) > std::abs(box.max[along]) ? -1 : 1;
    return {glm::cross(ahead, facing), ahead, facing};
}
} // namespace

LeafBlade bentCard(const LeafRelief& relief, const glm::ivec2& cells) {
    LeafBlade blade;
    for (int row = 0; row <= cells.y; ++row)
        for (int column = 0; column <= cells.x; ++column) {
            const double u = double(column) / cells.x, v = double(row) / cells.y, x = u - 0.5;
            blade.points.push_back({{x, v, relief(x, v) - relief(0, 0)}, normalOf(relief, x, v), {u, v}});
            if (row == cells.y || column == cells.x) continue;
            const auto low = static_cast<std::uint32_t>(row * (cells.x + 1) + column), high = low + static_cast<std::uint32_t>(cells.x) + 1;
            for (const std::uint32_t corner : {low, low + 1, high + 1, low, high + 1, high}) blade.indices.push_back(corner);
        }
    return blade;
}

std::span<const BuiltInLeaf> builtInLeaves() { return kBuiltIn; }

const BuiltInLeaf* builtInLeaf(std::string_view name) {
    if (!isBuiltInMesh(name)) return nullptr;
    const auto found = std::ranges::find(kBuiltIn, name.substr(kBuiltInMesh.size()), &BuiltInLeaf::name);
    if (found != std::end(kBuiltIn)) return found;
    std::string known;
    for (const BuiltInLeaf& leaf : kBuiltIn) known += (known.empty() ? "" : ", ") + std::string(kBuiltInMesh) + std::string(leaf.name);
    throw CError(translated(NC_("stromar", "there is no %1; there are %2"), name, known));
}

LeafBlade bladeOf(LeafBlade mesh, double aspect) {
    if (mesh.points.empty()) throw CError(translated(NC_("stromar", "has no triangles")));
    const Box box = boxOf(mesh);
    const glm::dmat3 axes = axesOf(mesh, box);
    const glm::dvec3 reach = glm::max(box.max * axes, box.min * axes), size = glm::abs(box.size() * axes);
    if (!(reach.y > 0) || !(size.x > 0) || !std::isfinite(reach.y) || !std::isfinite(size.x))
        throw CError(translated(NC_("stromar", "has no length or no width")));
    const glm::dvec3 scale = glm::dvec3(1 / aspect, 1, 1 / aspect) / reach.y;
    for (LeafBlade::Point& point : mesh.points) {
        point.place = scale * (point.place * axes);
        point.normal = glm::normalize((point.normal * axes) / scale);
    }
    return mesh;
}

} // namespace stromar
