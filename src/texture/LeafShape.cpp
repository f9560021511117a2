#include "LeafShape.h"
#include "stromar/util/Random.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
constexpr double kDegree = std::numbers::pi / 180;

glm::dvec2 towards(double turn) { return {std::sin(turn), std::cos(turn)}; }

/// Puts the pieces of one leaf together.
class CLeafMaker {
public:
    explicit CLeafMaker(const LeafParams& leaf) : m_leaf(leaf), m_random(static_cast<std::uint64_t>(leaf.seed), true) {}

    std::vector<Blade> take() { return std::move(m_blades); }

    /// One blade; behind its foot the two lobes of a heart.
    void simple() {
        const double foot = m_leaf.stalk + 0.22 * m_leaf.heart;
        addStalk({0, 0}, {0, foot + 0.02}, 0.012);
        Blade blade = lamina({0, foot}, 0, 1 - foot, m_leaf.width / 2 - 0.004);
        blade.teeth = m_leaf.teeth;
        blade.lobes = m_leaf.lobes;
        blade.veins = m_leaf.veins;
        add(blade);
        if (m_leaf.heart <= 0) return;
        for (const double side : {-1.0, 1.0}) {
            Blade lobe =
                lamina({0.02 * side, foot + 0.2}, side * 148 * kDegree, 0.2 + 0.22 * m_leaf.heart, 0.25 * m_leaf.width);
            lobe.peak = 0.55;
            lobe.base = lobe.tip = 0.5;
            add(lobe);
        }
    }

    /// Lobes that spread like fingers out of one palm.
    void palmatelyLobed() {
        const glm::dvec2 palm(0, m_leaf.stalk + 0.16);
        addStalk({0, 0}, palm, 0.012);
        const double reach = 1 - palm.y;
        Blade middle = lamina(palm - glm::dvec2(0, 0.45 * (1 - m_leaf.lobe) * reach), 0,
                              (1 - m_leaf.lobe) * reach * 1.25, (1 - m_leaf.lobe) * reach * 0.55);
        middle.peak = middle.base = middle.tip = 0.5;
        add(middle);
        const int count = std::max(3, m_leaf.lobes);
        for (int i = 0; i < count; ++i) {
            const double at = 2.0 * i / (count - 1) - 1, turn = at * m_leaf.spread * kDegree;
            const double out = 1 - 0.16 * std::abs(at) - 0.36 * at * at;
            Blade lobe = lamina(palm, turn, fitted(palm, turn, out * reach), 0);
            lobe.half = lobe.length * 0.62 / std::sqrt(count - 1.0) * (1 - 0.35 * m_leaf.lobe);
            lobe.teeth = m_leaf.teeth;
            lobe.veins = m_leaf.veins;
            lobe.bend = 0.06 * at;
            add(lobe);
        }
    }

    /// Leaflets in pairs on a common stalk, and one at its end.
    void pinnate() {
        const double first = m_leaf.stalk, end = 0.76;
        addStalk({0, 0}, {0, end + 0.03}, 0.012);
        const int pairs = std::max(1, m_leaf.leaflets);
        const double spacing = (end - first) / pairs;
        for (int i = 0; i < pairs; ++i) {
            const double along = (i + 0.5) / pairs, y = first + (i + 0.35) * spacing;
            for (const double side : {-1.0, 1.0}) {
                const double turn = side * (m_leaf.spread - 14 * along + vary(6)) * kDegree;
                const double length = (0.62 + 0.38 * std::sin(std::numbers::pi * (0.2 + 0.6 * along))) * m_leaf.width /
                                      2 / std::max(0.4, std::sin(m_leaf.spread * kDegree));
                addLeaflet({0, y + vary(0.1) * spacing}, turn, length * (1 + vary(0.06)), spacing, i);
            }
        }
        addLeaflet({0, end}, vary(4) * kDegree, 1 - end, spacing, pairs);
    }

    /// Leaflets out of one point.
    void palmate() {
        const glm::dvec2 palm(0, m_leaf.stalk);
        addStalk({0, 0}, palm, 0.014);
        const int count = std::max(3, m_leaf.leaflets);
        for (int i = 0; i < count; ++i) {
            const double at = 2.0 * i / (count - 1) - 1, turn = at * m_leaf.spread * kDegree;
            const double length = fitted(palm, turn, (1 - 0.38 * at * at) * (1 - palm.y));
            Blade leaflet = lamina(palm, turn, length, length * m_leaf.lobe * 0.5);
            leaflet.veins = m_leaf.veins;
            leaflet.teeth = m_leaf.teeth;
            leaflet.layer = 1 + (count - std::abs(2 * i + 1 - count)) / 2;
            leaflet.tone = vary(0.25);
            add(leaflet);
        }
    }

    /// Stiff rays that part near their tips.
    void fan() {
        const glm::dvec2 palm(0, m_leaf.stalk);
        addStalk({0, 0}, palm, 0.03);
        const int count = std::max(5, m_leaf.leaflets);
        for (int i = 0; i < count; ++i) {
            const double at = 2.0 * i / (count - 1) - 1, turn = at * m_leaf.spread * kDegree;
            Blade ray =
                lamina(palm, turn, fitted(palm, turn, (1 - 0.12 * at * at) * (1 - palm.y) * (1 + vary(0.05))), 0);
            ray.half = 1.25 * ray.length * m_leaf.spread * kDegree / count * m_leaf.lobe;
            ray.peak = 0.45;
            ray.base = 1;
            ray.tip = 0.8;
            ray.bend = vary(0.05);
            ray.layer = i % 2;
            ray.tone = vary(0.35);
            add(ray);
        }
    }

    /// A bundle out of one sheath.
    void needles() {
        const int count = std::max(1, m_leaf.leaflets);
        for (int i = 0; i < count; ++i) {
            const double at = count > 1 ? 2.0 * i / (count - 1) - 1 : 0;
            const double turn = (at * m_leaf.spread + vary(5)) * kDegree;
            Blade needle = needleAt({0.01 * at, 0.01}, turn,
                                    fitted({0, 0}, turn, 0.98 * (1 - 0.25 * std::abs(at)) * (1 - 0.2 * uniform())));
            needle.bend = 0.1 * at + vary(0.05);
            needle.layer = static_cast<int>(3 * uniform());
            add(needle);
        }
        addStalk({0, 0}, {0, 0.07}, 0.03);
    }

    /// A twig with needles all around; perhaps with side twigs, shorter towards its tip.
    void needleTwig() {
        const double end = 0.9;
        const int pairs = m_leaf.lobes;
        for (int i = 0; i < 2 * pairs; ++i) {
            const double y = end * (i + 0.7 + vary(0.2)) / (2 * pairs + 1), side = i % 2 ? 1 : -1;
            const double turn = side * (90 * (1 - m_leaf.slant) + vary(6)) * kDegree, part = 1 - 0.85 * std::pow(y / end, 1.3);
            addNeedles({0, y}, turn, fitted({0, y}, turn, 0.66 * m_leaf.width * part * (0.85 + 0.3 * uniform())), 3 * (i % 2));
        }
        addNeedles({0, 0}, 0, end, pairs > 0 ? 6 : 0);
    }

    /// Twigs that fork into twigs, covered with scales.
    void scales() { spray({0, 0}, 0, 0.98, 2, 0); }

    /// Petals around a yellow middle.
    void blossom() { flower({0, 0.5}, 0.47, 0, 4); }

    /// Several on stalks out of one bud.
    void blossoms() {
        const int count = std::max(3, m_leaf.lobes);
        for (int i = 0; i < count; ++i) {
            const double around = 2 * std::numbers::pi * (i + 0.6 * uniform()) / count;
            const double out = i == 0 ? 0 : 0.24 + vary(0.03);
            const glm::dvec2 middle = glm::dvec2(0, 0.56) + out * glm::dvec2(std::sin(around), 0.9 * std::cos(around));
            addStalk({0, 0}, middle, 0.012);
            flower(middle, 0.2 + 0.025 * uniform(), i == 0 ? 8 : 2 * (i % 3), 8 + i);
        }
    }

    /// Flowers around an upright stalk, the upper ones smaller.
    void candle() {
        addStalk({0, 0}, {0, 0.96}, 0.016);
        const int count = std::max(6, m_leaf.lobes);
        for (int i = 0; i < count; ++i) {
            const double up = (i + 0.5) / count, radius = (0.13 - 0.07 * up) * (1 + vary(0.12));
            const double aside = m_leaf.width * 0.36 * (1 - 0.85 * up) * std::sin(2.4 * i);
            flower({std::clamp(aside, radius - m_leaf.width / 2, m_leaf.width / 2 - radius), 0.16 + 0.76 * up}, radius,
                   i % 3, i);
        }
    }

private:
    double uniform() { return m_random.uniform(++m_drawn, 1); }
    double vary(double by) { return by * (2 * uniform() - 1); }

    void add(const Blade& blade) { m_blades.push_back(blade); }

    Blade lamina(const glm::dvec2& foot, double turn, double length, double half) const {
        Blade blade;
        blade.foot = foot;
        blade.turn = turn;
        blade.length = length;
        blade.half = half;
        blade.peak = m_leaf.peak;
        blade.base = m_leaf.base;
        blade.tip = m_leaf.tip;
        blade.tooth = m_leaf.tooth;
        blade.lobe = m_leaf.lobe;
        blade.slant = m_leaf.slant;
        return blade;
    }

    Blade needleAt(const glm::dvec2& foot, double turn, double length) {
        Blade needle = lamina(foot, turn, length, m_leaf.lobe * 0.03);
        needle.peak = 0.3;
        needle.base = 0.25;
        needle.tip = 0.45;
        needle.tone = vary(0.4);
        needle.layer = 1;
        return needle;
    }

    /// All around a twig, those towards the eye foreshortened.
    void addNeedles(const glm::dvec2& foot, double turn, double length, int layer) {
        const glm::dvec2 axis = towards(turn), right(axis.y, -axis.x);
        const double fine = 1.0 / (1 + m_leaf.lobes), longest = 0.62 * m_leaf.width * fine;
        addStalk(foot, foot + length * axis, 0.022 * fine, layer + 1);
        const int count = std::max(4, static_cast<int>(std::lround(m_leaf.leaflets * length / 0.9)));
        for (int i = 0; i < count; ++i) {
            const double along = length * (i + 0.5) / count;
            const double around = 2 * std::numbers::pi * uniform(), aside = std::sin(around);
            const double off = turn + aside * (m_leaf.spread + vary(10)) * kDegree;
            const double shown = 0.45 + 0.55 * std::abs(aside);
            const glm::dvec2 at = foot + along * axis + 0.012 * fine * aside * right;
            Blade needle = needleAt(at, off, shown * fitted(foot + along * axis, off, longest));
            needle.bend = -0.12 * aside;
            needle.layer = layer + (std::cos(around) > 0 ? 2 : 0);
            needle.tone = (std::cos(around) > 0 ? 0.15 : -0.35) + vary(0.25);
            add(needle);
        }
        const glm::dvec2 tip = foot + length * axis;
        const double end = fine < 1 ? longest : 1;
        for (const double side : {-1.0, 0.0, 1.0}) {
            Blade needle = needleAt(tip - 0.01 * fine * axis, turn + side * 22 * kDegree, std::min(end, fitted(tip, turn, 1)));
            needle.layer += layer;
            add(needle);
        }
    }

    void addStalk(const glm::dvec2& from, const glm::dvec2& to, double thick, int layer = 1) {
        const glm::dvec2 way = to - from;
        const double length = std::hypot(way.x, way.y);
        if (length < 1e-6) return;
        Blade stalk;
        stalk.foot = from;
        stalk.turn = std::atan2(way.x, way.y);
        stalk.length = length;
        stalk.half = thick / 2;
        stalk.peak = 0.5;
        stalk.base = stalk.tip = 0.12;
        stalk.tissue = Blade::Tissue::Stalk;
        stalk.layer = layer;
        add(stalk);
    }

    void addLeaflet(const glm::dvec2& foot, double turn, double length, double spacing, int i) {
        Blade leaflet = lamina(foot, turn, fitted(foot, turn, length), 0);
        leaflet.half = std::min(length * m_leaf.lobe * 0.5, spacing * 0.62);
        leaflet.teeth = m_leaf.teeth;
        leaflet.veins = m_leaf.veins;
        leaflet.bend = 0.08 * std::sin(-turn);
        leaflet.layer = 2 + i % 2;
        leaflet.tone = vary(0.25);
        add(leaflet);
    }

    /// So long at most that it ends inside the card.
    double fitted(const glm::dvec2& foot, double turn, double length) const {
        const glm::dvec2 way = towards(turn);
        const double side = m_leaf.width / 2 - 0.01;
        if (std::abs(way.x) > 1e-6) length = std::min(length, (side - foot.x * (way.x > 0 ? 1 : -1)) / std::abs(way.x));
        if (way.y > 1e-6) length = std::min(length, (0.995 - foot.y) / way.y);
        if (way.y < -1e-6) length = std::min(length, (foot.y - 0.005) / -way.y);
        return std::max(0.01, length);
    }

    void spray(const glm::dvec2& foot, double turn, double length, int depth, int layer) {
        length = fitted(foot, turn, length);
        const glm::dvec2 way = towards(turn), aside(way.y, -way.x);
        const double thick = 0.014 + 0.006 * depth;
        const int scaleCount = std::max(3, static_cast<int>(length / (1.3 * thick)));
        if (depth > 0) {
            const int sides = static_cast<int>(m_leaf.leaflets * length);
            for (int i = 1; i < sides; ++i) {
                const double at = double(i) / sides, hand = i % 2 ? 1 : -1;
                spray(foot + at * length * way, turn + hand * (m_leaf.spread + vary(8)) * kDegree,
                      0.52 * length * (1 - 0.75 * at) * (1 + vary(0.15)), depth - 1, layer + 1);
            }
        }
        for (int i = 0; i < scaleCount; ++i) {
            const double at = double(i) / scaleCount, hand = i % 2 ? 1 : -1;
            Blade scale = lamina(foot + at * length * way + 0.12 * thick * hand * aside, turn + hand * 16 * kDegree,
                                 2.6 * thick, 0.62 * thick * (1.15 - 0.5 * at));
            scale.peak = 0.4;
            scale.base = 0.3;
            scale.tip = 0.7;
            scale.layer = 2 * layer + i % 2;
            scale.tone = 0.25 * layer - 0.3 + vary(0.3);
            add(scale);
        }
    }

    void flower(const glm::dvec2& middle, double radius, int layer, int salt) {
        const int petals = std::max(3, m_leaf.leaflets);
        const double start = 0.7 * salt + vary(0.3);
        for (int i = 0; i < petals; ++i) {
            const double turn = start + 2 * std::numbers::pi * i / petals;
            Blade petal = lamina(middle + 0.03 * radius * towards(turn), turn, radius * (1 + vary(0.06)), 0);
            petal.half = 0.5 * radius * (1 + vary(0.08)) * 5 / std::max(5, petals);
            petal.peak = 0.62;
            petal.base = 0.75;
            petal.tip = 0.45;
            petal.veins = 5;
            petal.layer = 3 * layer + 2 + i % 2;
            petal.tone = vary(0.3);
            petal.tissue = Blade::Tissue::Petal;
            add(petal);
        }
        for (int i = 0; i < 14; ++i) {
            const double turn = 2 * std::numbers::pi * (i + uniform()) / 14, out = radius * (0.2 + 0.25 * uniform());
            Blade anther;
            anther.foot = middle + out * towards(turn);
            anther.length = 0.07 * radius;
            anther.half = 0.035 * radius;
            anther.peak = anther.base = anther.tip = 0.5;
            anther.layer = 3 * layer + 4;
            anther.tissue = Blade::Tissue::Anther;
            add(anther);
        }
    }

    const LeafParams& m_leaf;
    CRandom m_random;
    std::uint64_t m_drawn = 0;
    std::vector<Blade> m_blades;
};
} // namespace

std::vector<Blade> bladesOf(const LeafParams& leaf) {
    constexpr void (CLeafMaker::*kMakers[])() = {
        &CLeafMaker::simple,  &CLeafMaker::palmatelyLobed, &CLeafMaker::pinnate,    &CLeafMaker::palmate,
        &CLeafMaker::fan,     &CLeafMaker::needles,        &CLeafMaker::needleTwig, &CLeafMaker::scales,
        &CLeafMaker::blossom, &CLeafMaker::blossoms,       &CLeafMaker::candle};
    static_assert(std::size(kMakers) == static_cast<std::size_t>(kLastLeafPlan) + 1);
    CLeafMaker maker(leaf);
    (maker.*kMakers[static_cast<std::size_t>(leaf.plan)])();
    std::vector<Blade> blades = maker.take();
    std::ranges::stable_sort(blades, {}, &Blade::layer);
    return blades;
}

} // namespace stromar
