#include "foliage/LeafBlade.h"
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <span>

namespace stromar {

namespace {
/// Half of an outline: the distance from the midrib at rising places along it, both in parts of the length.
struct Row {
    double along, across;
};
/// A blade or a leaflet: where it starts, how it is turned and how large it is.
struct Leaflet {
    std::span<const Row> rows;
    glm::dvec2 foot{0, 0};
    double turn = 0; ///< radians, to the left
    double size = 1, width = 1;
};

constexpr Row kOval[] = {{0, 0}, {0.05, 0.2}, {0.16, 0.38}, {0.36, 0.5}, {0.58, 0.46}, {0.8, 0.27}, {1, 0}};
constexpr Row kTriangle[] = {{0, 0}, {0.08, 0.42}, {0.2, 0.5}, {0.6, 0.24}, {1, 0}};
constexpr Row kOak[] = {{0, 0}, {0.12, 0.16}, {0.3, 0.34}, {0.4, 0.2}, {0.58, 0.5}, {0.7, 0.26}, {0.88, 0.3}, {1, 0}};
constexpr Row kMaple3[] = {{0, 0}, {0.1, 0.3}, {0.42, 0.5}, {0.46, 0.24}, {0.7, 0.22}, {1, 0}};
constexpr Row kMaple5[] = {{0, 0},      {0.06, 0.36}, {0.14, 0.42}, {0.2, 0.26}, {0.5, 0.5},
                           {0.52, 0.2}, {0.74, 0.24}, {0.78, 0.1},  {1, 0}};
constexpr Row kLance[] = {{0, 0}, {0.1, 0.26}, {0.3, 0.5}, {0.55, 0.44}, {0.8, 0.22}, {1, 0}};
constexpr Row kHeart[] = {{0, 0.3}, {0.06, 0.45}, {0.2, 0.5}, {0.45, 0.42}, {0.75, 0.18}, {1, 0}};
constexpr Row kCard[] = {{0, 0.5}, {1, 0.5}};
constexpr Row kNeedle[] = {{0, 0.5}, {0.8, 0.5}, {1, 0}};

constexpr Leaflet kOvals[] = {{kOval}}, kTriangles[] = {{kTriangle}}, kOaks[] = {{kOak}}, kMaples3[] = {{kMaple3}},
                  kMaples5[] = {{kMaple5}}, kCards[] = {{kCard}};
constexpr Leaflet kThree[] = {
    {kOval, {0, 0.4}, 0, 0.6, 0.75}, {kOval, {0, 0.38}, 1.1, 0.5, 0.75}, {kOval, {0, 0.38}, -1.1, 0.5, 0.75}};
constexpr Leaflet kNeedles[] = {{kNeedle, {0, 0}, 0, 1, 0.06},
                                {kNeedle, {0, 0}, 0.22, 0.96, 0.06},
                                {kNeedle, {0, 0}, -0.22, 0.96, 0.06},
                                {kNeedle, {0, 0}, 0.45, 0.88, 0.06},
                                {kNeedle, {0, 0}, -0.45, 0.88, 0.06}};
constexpr Leaflet kLances[] = {{kLance}}, kHearts[] = {{kHeart}};
constexpr Leaflet kPinnate[] = {{kLance, {0, 0.22}, 1.1, 0.34, 0.32},  {kLance, {0, 0.22}, -1.1, 0.34, 0.32},
                                {kLance, {0, 0.42}, 1.05, 0.38, 0.32}, {kLance, {0, 0.42}, -1.05, 0.38, 0.32},
                                {kLance, {0, 0.6}, 0.95, 0.36, 0.32},  {kLance, {0, 0.6}, -0.95, 0.36, 0.32},
                                {kLance, {0, 0.7}, 0, 0.3, 0.34}};
constexpr Leaflet kPalmate[] = {{kLance, {0, 0.25}, 0, 0.75, 0.3},    {kLance, {0, 0.25}, 0.6, 0.68, 0.3},
                                {kLance, {0, 0.25}, -0.6, 0.68, 0.3}, {kLance, {0, 0.25}, 1.2, 0.54, 0.3},
                                {kLance, {0, 0.25}, -1.2, 0.54, 0.3}, {kLance, {0, 0.25}, 1.85, 0.36, 0.3},
                                {kLance, {0, 0.25}, -1.85, 0.36, 0.3}};
constexpr Leaflet kFan[] = {
    {kLance, {0, 0.2}, 0, 0.8, 0.16},      {kLance, {0, 0.2}, 0.38, 0.78, 0.16},  {kLance, {0, 0.2}, -0.38, 0.78, 0.16},
    {kLance, {0, 0.2}, 0.76, 0.74, 0.16},  {kLance, {0, 0.2}, -0.76, 0.74, 0.16}, {kLance, {0, 0.2}, 1.14, 0.68, 0.16},
    {kLance, {0, 0.2}, -1.14, 0.68, 0.16}, {kLance, {0, 0.2}, 1.52, 0.6, 0.16},   {kLance, {0, 0.2}, -1.52, 0.6, 0.16}};
/// By the word of LeafShape.
constexpr std::span<const Leaflet> kShapes[] = {kOvals,   kTriangles, kOaks,   kMaples3, kMaples5, kThree, kCards,
                                                kNeedles, kLances,    kHearts, kPinnate, kPalmate, kFan};

constexpr double kHalfTurn = std::numbers::pi;
constexpr double kStalkWidth = 0.04; // parts of the length
constexpr double kPictureAcross = 0.4,
                 kPictureAlong = 0.6; // of a picture that an outline shows: the inside of its leaf

class CBladeMaker {
public:
    CBladeMaker(double fold, double stalk, bool card) : m_fold(fold), m_stalk(stalk), m_card(card) {}

    void add(const Leaflet& leaflet) {
        const bool midrib = !m_card || m_fold != 0;
        std::vector<std::uint32_t> last;
        for (const Row& row : leaflet.rows) {
            std::vector<std::uint32_t> here;
            for (const int side : {-1, 0, 1})
                if (side == 0 ? midrib || row.across == 0 : row.across > 0)
                    here.push_back(addPoint(leaflet, row, side));
            if (!last.empty()) join(last, here);
            last = std::move(here);
        }
    }

    void addStalk() {
        if (m_stalk <= 0) return;
        const auto first = static_cast<std::uint32_t>(m_blade.points.size());
        for (const double along : {0.0, m_stalk})
            for (const double x : {-kStalkWidth / 2, kStalkWidth / 2})
                m_blade.points.push_back(
                    {{x, along, 0}, {0, 0, 1}, {0.5 + x / 4, 0.3 + 0.05 * along / m_stalk}}); // along the midrib
        for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) m_blade.indices.push_back(first + corner);
    }

    void add(const LeafBlade& mesh) {
        m_blade = mesh;
        for (LeafBlade::Point& point : m_blade.points) point.place.y += m_stalk;
    }

    /// The card once more, turned about its length, so that all stand at equal angles.
    void addPlanes(int planes) {
        const LeafBlade one = m_blade;
        for (int k = 1; k < planes; ++k) {
            const double turn = kHalfTurn * k / planes, c = std::cos(turn), s = std::sin(turn);
            const auto first = static_cast<std::uint32_t>(m_blade.points.size());
            const auto turned = [&](const glm::dvec3& v) {
                return glm::dvec3(c * v.x - s * v.z, v.y, s * v.x + c * v.z);
            };
            for (const LeafBlade::Point& p : one.points)
                m_blade.points.push_back({turned(p.place), turned(p.normal), p.texCoord});
            for (const std::uint32_t corner : one.indices) m_blade.indices.push_back(first + corner);
        }
    }

    LeafBlade take() { return std::move(m_blade); }

private:
    /// `side` −1 left, 0 midrib, 1 right. The halves are folded up about the midrib.
    std::uint32_t addPoint(const Leaflet& leaflet, const Row& row, int side) {
        const double half = side * row.across * leaflet.width * leaflet.size, along = row.along * leaflet.size;
        const double c = std::cos(leaflet.turn), s = std::sin(leaflet.turn);
        const double flat = half * std::cos(m_fold);
        const glm::dvec3 normal(-side * std::sin(m_fold) * c, -side * std::sin(m_fold) * s, std::cos(m_fold));
        const glm::dvec2 place(leaflet.foot.x + flat * c - along * s, leaflet.foot.y + flat * s + along * c);
        const glm::dvec2 picture(leaflet.foot.x + half * c - along * s, leaflet.foot.y + half * s + along * c);
        m_blade.points.push_back({{place.x, m_stalk + place.y, std::abs(half) * std::sin(m_fold)},
                                  side == 0 ? glm::dvec3(0, 0, 1) : normal,
                                  m_card ? glm::vec2(0.5 + picture.x, picture.y)
                                         : glm::vec2(0.5 + kPictureAcross * picture.x,
                                                     (1 - kPictureAlong) / 2 + kPictureAlong * picture.y)});
        return static_cast<std::uint32_t>(m_blade.points.size()) - 1;
    }

    /// Two rows, each from left to right.
    void join(const std::vector<std::uint32_t>& low, const std::vector<std::uint32_t>& high) {
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            for (const std::uint32_t corner : {a, b, c}) m_blade.indices.push_back(corner);
        };
        for (std::size_t i = 0; i + 1 < std::max(low.size(), high.size()); ++i) {
            if (low.size() == 1)
                add(low[0], high[i + 1], high[i]);
            else if (high.size() == 1)
                add(low[i], low[i + 1], high[0]);
            else {
                add(low[i], low[i + 1], high[i + 1]);
                add(low[i], high[i + 1], high[i]);
            }
        }
    }

    double m_fold, m_stalk;
    bool m_card;
    LeafBlade m_blade;
};

/// Whether more than plain cards is seen of it.
bool isClose(const Detail& detail) { return detail.model == Model::Full && detail.lod <= 1; }

LeafBlade onStalk(const LeafBlade& mesh, double stalk) {
    CBladeMaker maker(0, stalk, true);
    maker.add(mesh);
    maker.addStalk();
    return maker.take();
}
} // namespace

LeafBlade makeBlade(const LeafForm& form, const Detail& detail) {
    const bool last = detail.model == Model::Full && detail.lod == kMaxLod;
    if (form.mesh) return onStalk(last && form.mesh->far ? *form.mesh->far : *form.mesh, form.stalk);
    const bool close = isClose(detail);
    const bool card = !form.outline || !close;
    CBladeMaker maker(close ? form.fold : 0, form.stalk, card);
    for (const Leaflet& leaflet : card ? std::span<const Leaflet>(kCards) : kShapes[form.shape]) maker.add(leaflet);
    if (card) maker.addPlanes(last ? std::min(2, form.planes) : form.planes);
    if (close) maker.addStalk();
    return maker.take();
}

LeafBlade bladeOf(const MeshParams& params, Organ organ, const Detail& detail, std::size_t kind) {
    switch (organ) {
    case Organ::Blossom: return makeBlossom(params.blossomPlanes, params.blossomDome, detail);
    case Organ::Fruit: return makeFruit(params.fruitStalk, detail);
    default: return makeBlade(params.formOf(kind), detail);
    }
}

LeafBlade makeBlossom(int planes, double dome, const Detail& detail) {
    CBladeMaker maker(0, 0, true);
    if (dome > 0 && isClose(detail))
        maker.add(bentCard([&](double x, double y) { return -2 * dome * (x * x + (y - 0.5) * (y - 0.5)); }));
    else
        maker.add(kCards[0]);
    maker.addPlanes(planes);
    return maker.take();
}

LeafBlade makeFruit(double stalk, const Detail& detail) {
    const bool close = isClose(detail);
    const int around = close ? 10 - 4 * detail.lod : 4, rings = close ? 6 - 2 * detail.lod : 2;
    LeafBlade fruit;
    // A pole has a vertex for each side, the rings between one more: the picture's edge.
    const auto index = [&](int ring, int i) {
        return static_cast<std::uint32_t>(ring * (around + 1) + i - (ring > 0));
    };
    for (int ring = 0; ring <= rings; ++ring)
        for (int i = 0; i < around + (ring > 0 && ring < rings ? 1 : 0); ++i) {
            const double down = kHalfTurn * ring / rings, turn = 2 * kHalfTurn * i / around;
            const glm::dvec3 out(std::sin(down) * std::cos(turn), -std::cos(down), std::sin(down) * std::sin(turn));
            fruit.points.push_back({{0.5 * out.x, stalk + 0.5 + 0.5 * out.y, 0.5 * out.z},
                                    out,
                                    {double(i) / around, 1 - double(ring) / rings}});
            if (ring == rings || i == around) continue;
            if (ring > 0)
                for (const std::uint32_t corner : {index(ring, i), index(ring + 1, i), index(ring, i + 1)})
                    fruit.indices.push_back(corner);
            if (ring + 1 < rings)
                for (const std::uint32_t corner :
                     {index(ring, ring > 0 ? i + 1 : i), index(ring + 1, i), index(ring + 1, i + 1)})
                    fruit.indices.push_back(corner);
        }
    return fruit;
}

} // namespace stromar
