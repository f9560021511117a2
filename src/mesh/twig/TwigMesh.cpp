#include "foliage/Foliage.h"
#include "twig/CrownView.h"
#include "twig/LeafyTwigs.h"
#include "twig/StraightStem.h"
#include "stem/TubeWriter.h"
#include "stromar/mesh/twig/Twig.h"
#include "stromar/util/Parallel.h"
#include <cmath>
#include <numbers>

namespace stromar {

namespace {
constexpr std::size_t kGrain = 512;
constexpr double kBendPerRow = 0.5; // radians
constexpr int kMaxRows = 4;
constexpr double kMinGrowth = 0.5; // of areas
constexpr double kMaxCut = 2;       // length of a stem over that of its card
constexpr double kMaxBent = 0.3;    // cosine between a normal and the triangles around it
constexpr double kMaxGrowth = 4;

/// How the twigs' cards are made.
struct CardPlan {
    std::vector<LeafyTwig> twigs; ///< that get one
    std::uint32_t planes, rows;
    double each; ///< for how many twigs a card stands
    VertexLook look;

    std::size_t verticesOfCard() const { return std::size_t{planes} * (rows + 1) * 2; }
    std::size_t indicesOfCard() const { return std::size_t{planes} * rows * 6; }
};

/// Of a card that follows its twig as closely as can be seen at this level of detail.
double rowsFor(const Twig& typical, double maxSag) {
    const double wanted = std::ceil(typical.bend / kBendPerRow), sag = typical.bend * typical.length / 8;
    const double seen = maxSag > 0 ? std::ceil(std::sqrt(sag / maxSag)) : wanted;
    return std::clamp(std::min(wanted, seen), 1.0, double(kMaxRows));
}

CardPlan planCards(const std::vector<LeafyTwig>& twigs, const Twig& typical, const Detail& detail, double treeHeight) {
    CardPlan plan{};
    const double budget = std::min(double(detail.leafBudget), std::ceil(leavesOn(twigs) * detail.cardShare));
    const double perTwig = budget / std::max(1.0, double(twigs.size()));
    const double planes = typical.flat || perTwig < detail.twigPlanes ? 1 : detail.twigPlanes;
    plan.planes = static_cast<std::uint32_t>(planes);
    plan.rows = static_cast<std::uint32_t>(std::clamp(std::floor(perTwig / planes), 1.0, rowsFor(typical, detail.maxSag * treeHeight)));
    const auto max = static_cast<std::size_t>(budget) / (plan.planes * plan.rows);
    const std::size_t count = std::min(twigs.size(), max);
    for (std::size_t i = 0; i < count; ++i) plan.twigs.push_back(twigs[evenly(i, count, twigs.size())]);
    plan.look.skyVisibility = static_cast<std::uint8_t>(std::lround(255 * detail.cardSky));
    plan.each = count > 0 ? double(twigs.size()) / double(count) : 1;
    return plan;
}

/// Writes the cards of twigs, one after the other.
class CCardWriter {
public:
    CCardWriter(const CTree& tree, const Twig& twig, const CardPlan& plan, const Rounding& rounding, double fit, CMesh& mesh)
        : m_tree(tree), m_twig(twig), m_plan(plan), m_rounding(rounding), m_fit(fit),
          m_mesh(mesh), m_rows(plan.rows + 1), m_points(2 * m_rows.size()) {
        for (std::uint32_t row = 0; row < plan.rows; ++row)
            for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) m_corners.push_back(2 * row + corner);
    }

    void write(std::size_t card) {
        const LeafyTwig& own = m_plan.twigs[card];
        const CStraightStem stem(m_tree.generation(own.generation), own.of(m_tree), m_twig.turn);
        setSize(stem, m_plan.each * own.leaves);
        auto first = static_cast<std::uint32_t>(card * m_plan.verticesOfCard());
        VertexSink sink = sinkAt(m_mesh, first);
        std::uint32_t* index = m_mesh.indices.data() + card * m_plan.indicesOfCard();
        for (std::uint32_t plane = 0; plane < m_plan.planes; ++plane) {
            placeRows(stem, std::numbers::pi * plane / m_plan.planes);
            if (m_plan.rows == 1 || !facePoints()) {
                straighten(stem, std::numbers::pi * plane / m_plan.planes);
                facePoints();
            }
            for (std::size_t i = 0; i < m_points.size(); ++i)
                sink.add(m_points[i].place, normalOf(m_points[i]), double(i % 2), double(i / 2) / m_plan.rows, m_plan.look);
            for (const std::uint32_t corner : m_corners) *index++ = first + corner;
            first += static_cast<std::uint32_t>(m_points.size());
        }
    }

private:
    struct Row {
        glm::dvec3 middle, right;
    };
    struct Point {
        glm::dvec3 place, front;
        double minCosine; ///< to `front` of a normal that looks out of all triangles around
    };

    /// The part of what the picture shows that is seen on the average from all sides: half of one plane; of two, the wider
    /// one and what the narrower one adds in the gaps.
    double seenPart() const {
        if (m_plan.planes == 1) return 0.5;
        const double wider = std::numbers::sqrt2 / 2, gaps = 1 - m_twig.shownArea / m_twig.cardArea();
        return wider + (1 - wider) * gaps;
    }

    /// How far the card reaches, so that as much is seen of it as of the twigs for which it stands.
    void setSize(const CStraightStem& stem, double leaves) {
        const double beyond = m_twig.high.y - m_twig.length; // the tip: leaves do not grow with their twig
        const double longer = (stem.length() + beyond) / (m_twig.length + beyond);
        const double growth = m_fit * std::clamp(leaves * m_twig.seenPerLeaf / (seenPart() * m_twig.shownArea * longer), kMinGrowth, kMaxGrowth);
        m_along = longer * std::pow(growth, 0.25); // rather wider than longer: the crown keeps its size
        m_across = std::pow(growth, 0.75);
        double chords = 0;
        for (std::uint32_t row = 1; row <= m_plan.rows; ++row)
            chords += glm::distance(stem.pointAt(yOf(row - 1)), stem.pointAt(yOf(row)));
        m_across *= std::min(kMaxCut, (yOf(m_plan.rows) - yOf(0)) / std::max(1e-9, chords));
    }

    double yOf(std::uint32_t row) const {
        return m_along * (m_twig.low.y + double(row) / m_plan.rows * (m_twig.high.y - m_twig.low.y));
    }

    void placeRows(const CStraightStem& stem, double turn) {
        for (std::uint32_t row = 0; row <= m_plan.rows; ++row) {
            const Frame frame = stem.frameOf(stem.segmentAt(yOf(row)));
            m_rows[row] = {stem.pointAt(yOf(row)), std::cos(turn) * frame[0] + std::sin(turn) * frame[2]};
        }
    }

    /// A flat card from the first row to the last.
    void straighten(const CStraightStem& stem, double turn) {
        const Frame middle = stem.frameOf(stem.segments().size() / 2);
        const glm::dvec3 low = m_rows.front().middle, way = m_rows.back().middle - low;
        const double length = glm::length(way);
        const glm::dvec3 along = length > 1e-9 ? way / length : middle[1];
        const Frame turned = transported({middle[2], middle[0], middle[1]}, along); // front, right, along
        const glm::dvec3 right = std::cos(turn) * turned[1] + std::sin(turn) * turned[0];
        const double reach = std::max(length, yOf(m_plan.rows) - yOf(0)) / m_plan.rows;
        for (std::uint32_t row = 0; row <= m_plan.rows; ++row) m_rows[row] = {low + row * reach * along, right};
    }

    /// Places the points and finds where they look; false when the card is too bent for that.
    bool facePoints() {
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            const double u = double(i % 2), x = m_across * (m_twig.low.x + u * (m_twig.high.x - m_twig.low.x));
            m_points[i] = {m_rows[i / 2].middle + x * m_rows[i / 2].right, glm::dvec3(0), 1};
        }
        forEachTriangle([](Point& point, const glm::dvec3& front) { point.front += front; });
        for (Point& point : m_points) point.front /= std::max(1e-12, glm::length(point.front));
        forEachTriangle([](Point& point, const glm::dvec3& front) {
            point.minCosine = std::min(point.minCosine, glm::dot(point.front, front));
        });
        bool good = true;
        for (Point& point : m_points) {
            good = good && point.minCosine > kMaxBent;
            point.minCosine = std::min(0.99, 0.05 + std::sqrt(std::max(0.0, 1 - point.minCosine * point.minCosine)));
        }
        return good;
    }

    template <typename Visit>
    void forEachTriangle(Visit&& visit) {
        for (std::size_t c = 0; c < m_corners.size(); c += 3) {
            Point *p = &m_points[m_corners[c]], *q = &m_points[m_corners[c + 1]], *r = &m_points[m_corners[c + 2]];
            const glm::dvec3 across = glm::cross(q->place - p->place, r->place - p->place);
            const glm::dvec3 front = across / std::max(1e-30, glm::length(across));
            for (Point* point : {p, q, r}) visit(*point, front);
        }
    }

    glm::dvec3 normalOf(const Point& point) const {
        Rounding rounding = m_rounding;
        rounding.minCosine = std::max(rounding.minCosine, point.minCosine);
        return rounding.turned(point.front, point.place);
    }

    const CTree& m_tree;
    const Twig& m_twig;
    const CardPlan& m_plan;
    const Rounding& m_rounding;
    double m_fit; ///< of areas: what lies behind one another in the crown
    CMesh& m_mesh;
    double m_along = 1, m_across = 1;
    std::vector<std::uint32_t> m_corners; ///< of the triangles of one plane
    std::vector<Row> m_rows;              ///< of the plane that is being written
    std::vector<Point> m_points;          ///< two of each row
};
CardPlan planCards(const StemSet& twigs, const CTree& tree, const COrgans& leaves, const Twig& typical,
                   const MeshParams& params, const Detail& detail) {
    return planCards(leafyTwigs(twigs, tree, leaves, params.seasonOf(Organ::Leaf).share), typical, detail, tree.height());
}
} // namespace

std::vector<TwigPlace> twigsOfCards(const StemSet& twigs, const CTree& tree, const COrgans& leaves, const Twig& typical,
                                    const MeshParams& params, const Detail& detail) {
    std::vector<TwigPlace> places;
    for (const LeafyTwig& twig : planCards(twigs, tree, leaves, typical, params, detail).twigs)
        places.push_back({twig.generation, twig.stem});
    return places;
}

std::size_t maxVerticesOfCard(const Detail& detail) {
    return 2 * static_cast<std::size_t>(detail.twigPlanes * (kMaxRows + 1));
}

namespace {
/// What is measured of a crown's cards.
class CCrown {
public:
    CCrown(const StemSet& twigs, const CTree& tree, const COrgans& leaves, const MeshParams& params, const Twig& typical, const CProgress& progress)
        : m_all(twigs), m_twigs(leafyTwigs(twigs, tree, leaves, params.seasonOf(Organ::Leaf).share)), m_tree(tree), m_twig(typical),
          m_rounding(roundingOf(tree, leaves, params.leaf)), m_mask(typical), m_minRadius(params.minRadius), m_progress(progress) {
        const std::shared_ptr<const CMesh> ends = bases();
        const Bounds box = ends->bounds();
        const double reach = glm::length(typical.high - typical.low);
        m_frame = {glm::dvec3(box.min + box.max) / 2.0, glm::length(glm::dvec3(box.max - box.min)) / 2 + reach};
    }

    CardPlan plan(const Detail& detail) const { return planCards(m_twigs, m_twig, detail, m_tree.height()); }
    /// Of the leaves of the twigs alone, or of all.
    std::vector<CrownPart> leavesOfTwigs(const std::shared_ptr<const COrgans>& leaves, const StemSet& twigs, const MeshParams& params) const {
        return partsOfLeaves(leaves, &twigs, leavesOn(m_twigs), params);
    }
    std::vector<CrownPart> allLeaves(const std::shared_ptr<const COrgans>& leaves, const MeshParams& params) const {
        return partsOfLeaves(leaves, nullptr, double(leaves->total) * params.seasonOf(Organ::Leaf).share, params);
    }
    /// What cards show of the twigs besides leaves.
    std::vector<CrownPart> withWood(std::vector<CrownPart> leaves) const {
        leaves.push_back({woodOfTwigs(m_twigs, m_tree, m_minRadius), nullptr, nullptr, CrownLayer::Wood});
        return leaves;
    }
    /// What is seen beside twigs or their cards.
    std::vector<CrownPart> partsBeside(const CrownOrgans& organs, const MeshParams& params) {
        std::vector<CrownPart> parts = blossomParts(organs, m_tree, params, detailOf(Model::Full, 1), m_progress);
        parts.push_back(wood());
        return parts;
    }
    std::vector<CrownPart> cardsAlone(const CardPlan& plan, double fit) const { return {{cards(plan, fit), nullptr, &m_mask}}; }

    /// As it is seen where a level of detail takes over.
    CrownLook lookOf(std::vector<CrownPart> parts, const std::vector<CrownPart>& beside, const Detail& detail) const {
        parts.insert(parts.end(), beside.begin(), beside.end());
        return crownLook(parts, m_frame, pixelsAt(detail), m_progress);
    }
    /// With the wood that cards do not stand for: what lies before or behind it covers nothing.
    double coverOf(const std::vector<CrownPart>& parts, const Detail& detail) {
        auto& cover = m_covers[static_cast<std::size_t>(detail.lod)];
        if (!cover) cover = std::make_unique<CCrownCover>(m_frame, pixelsAt(detail), std::vector{wood()}, m_progress);
        return cover->with(parts);
    }

    std::shared_ptr<const CMesh> cards(const CardPlan& plan, double fit) const {
        const std::size_t count = plan.twigs.size();
        const auto mesh = allocateMesh("twigs", Surface::Twig, plan.verticesOfCard() * count, plan.indicesOfCard() * count);
        parallelFor(
            count, kGrain,
            [&](std::size_t begin, std::size_t end) {
                CCardWriter writer(m_tree, m_twig, plan, m_rounding, fit, *mesh);
                for (std::size_t card = begin; card < end; ++card) writer.write(card);
            },
            m_progress);
        return mesh;
    }

    /// Of the areas of cards that are right for a single twig: so that they, with what is drawn `beside` them, cover as much as is wanted.
    CrownFit fitOf(const CardPlan& plan, const Detail& detail, double wanted, std::vector<CrownPart> beside = {}) {
        beside.emplace_back();
        return fitTo(wanted, m_twig.cardFit, detail.lod == kMaxLod ? kGoodFarFit : kGoodFit, [&](double fit) {
            beside.back() = {cards(plan, fit), nullptr, &m_mask};
            return coverOf(beside, detail);
        });
    }

private:
    const CrownPart& wood() {
        if (!m_wood.mesh) m_wood = otherWood(m_all, m_tree, m_minRadius);
        return m_wood;
    }
    double pixelsAt(const Detail& detail) const { return pixelsOf(m_frame, m_tree.height(), detail); }
    std::vector<CrownPart> partsOfLeaves(const std::shared_ptr<const COrgans>& leaves, const StemSet* twigs, double present, const MeshParams& params) const {
        return leafParts(leaves, twigs, present, m_tree, params, m_twig.masks, detailOf(Model::Full, 1), m_progress);
    }

    /// Of the twigs.
    std::shared_ptr<const CMesh> bases() const {
        auto mesh = allocateMesh("ends", Surface::Bark, 0, 0);
        for (const LeafyTwig& twig : m_twigs) {
            const CStraightStem stem(m_tree.generation(twig.generation), twig.of(m_tree), m_twig.turn);
            for (const double y : {0.0, stem.length()}) mesh->positions.push_back(glm::vec3(stem.pointAt(y)));
        }
        return mesh;
    }

    const StemSet& m_all; ///< twigs, with those that bear no leaves
    std::vector<LeafyTwig> m_twigs;
    const CTree& m_tree;
    const Twig& m_twig;
    Rounding m_rounding;
    CTwigMask m_mask;
    double m_minRadius;
    CrownFrame m_frame;
    const CProgress& m_progress;
    CrownPart m_wood;                                                     ///< of stems that are no twigs; made when it is asked for
    std::array<std::unique_ptr<const CCrownCover>, kMaxLod + 1> m_covers; ///< by level of detail, likewise
};

CardLooks looksOf(const Twig& twig, const StemSet& twigs, const CTree& tree, const CrownOrgans& organs, const MeshParams& params, const CProgress& progress) {
    CCrown crown(twigs, tree, *organs.leaves, params, twig, progress);
    const Detail& near = detailOf(Model::Full, 2);
    const std::vector<CrownPart> beside = crown.partsBeside(organs, params);
    return {crown.lookOf(crown.withWood(crown.leavesOfTwigs(organs.leaves, twigs, params)), beside, near),
            crown.lookOf(crown.cardsAlone(crown.plan(near), twig.cardFit), beside, near)};
}
} // namespace

void measureCrown(Twig& twig, const StemSet& twigs, const CTree& tree, const CrownOrgans& organs, const MeshParams& params, const CProgress& progress) {
    const auto& leaves = organs.leaves;
    CCrown crown(twigs, tree, *leaves, params, twig, progress);
    const Detail &near = detailOf(Model::Full, 2), &far = detailOf(Model::Full, 3);
    const std::vector<CrownPart> own = crown.withWood(crown.leavesOfTwigs(leaves, twigs, params));
    twig.twigsCover = crown.coverOf(own, near);
    const CardPlan plan = crown.plan(near);
    const CrownFit fit = crown.fitOf(plan, near, twig.twigsCover);
    const std::vector<CrownPart> cards = crown.cardsAlone(plan, fit.areas);
    twig.cardFit = fit.areas;
    twig.cardsCover = {fit.covered, crown.coverOf(cards, far)};
    twig.allCover = {twig.twigsCover, twig.cardsCover.far};
    twig.looks = std::make_shared<const CLazy<CardLooks>>(
        [twig, twigs, tree, organs, params](const CProgress& later) { return looksOf(twig, twigs, tree, organs, params, later); });
    if (leaves->countOn(twigs) == leaves->total) return;
    const std::vector<CrownPart> all = crown.withWood(crown.allLeaves(leaves, params));
    twig.allCover = {crown.coverOf(all, near), crown.coverOf(all, far)};
}

namespace {
/// The fit of cards that have leaves `beside` them, or none.
double fitBeside(CCrown& crown, const CardPlan& plan, const Twig& typical, const Detail& detail, const std::vector<CrownPart>& beside) {
    const bool far = detail.lod == kMaxLod;
    if (!beside.empty()) return crown.fitOf(plan, detail, far ? typical.allCover.far : typical.allCover.near, beside).areas;
    return far ? crown.fitOf(plan, detail, typical.cardsCover.far).areas : typical.cardFit; // as it was measured
}
} // namespace

std::shared_ptr<const CMesh> meshOfTwigs(const StemSet& twigs, const CTree& tree, const COrgans& leaves, const Twig& typical,
                                         const MeshParams& params, const Detail& detail,
                                         const CProgress& progress, const OrganMeshes& beside) {
    CCrown crown(twigs, tree, leaves, params, typical, progress);
    const CardPlan plan = crown.plan(detail);
    return crown.cards(plan, fitBeside(crown, plan, typical, detail, partsOf(beside, typical.masks, progress)));
}

} // namespace stromar
