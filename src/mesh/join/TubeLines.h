#pragma once
#include "join/BoundsTree.h"
#include "join/WoodPatch.h"
#include "stem/TubeWalls.h"
#include <glm/geometric.hpp>
#include <optional>

namespace stromar {

/// The lines along a tube's walls, one at each point of its lowest ring; rings further up have fewer points.
class CTubeLines {
public:
    static constexpr double kBeyond = 1e-3; ///< of the way between two rings that a line is looked along further: a collar's lowest ring lies on the wood, but for rounding

    const Tube& tube;
    glm::dvec3 base; ///< inside the wood
    double radius = 0; ///< metres, of the lowest ring of its own

    /// How far up a tube may come out, and how far around its base what belongs to it may: radii of the wood or of the path it parts from.
    struct Reach {
        double up, around = 0;
    };
    CTubeLines(const CTree& tree, std::span<const StemMesh> stems, const BranchTube& of, const Reach& reach)
        : tube(stems[of.generation].plan.tubes[of.tube]), m_tree(tree), m_stems(stems), m_generation(of.generation), m_mesh(*stems[of.generation].mesh) {
        const CStem& stem = own().stems[tube.stem];
        const CPath& path = own().paths[tube.path];
        m_isClone = path.source >= 0;
        base = own().segments[m_isClone ? path.firstSegment : stem.firstSegment].position;
        for (std::uint32_t r = 0; r <= tube.collarRings; ++r) addRing(tube.firstVertex + r * (tube.points + 1), tube.points);
        for (std::uint32_t i = 0; i < tube.points; ++i) radius = std::max(radius, glm::distance(m_rings.back().middle, at(tube.collarRings, i)));
        m_unit = m_isClone ? radius : std::max(stem.parentRadius, radius);
        m_around = reach.around * m_unit;
        addRings(stems[of.generation].plan, reach.up * m_unit);
    }

    bool isClone() const { return m_isClone; }
    std::uint32_t rings() const { return static_cast<std::uint32_t>(m_rings.size()); }
    /// Where a line is at a ring, or inside of that at a share of the tube's width.
    glm::dvec3 at(std::uint32_t ring, std::uint32_t line, double width = 1) const {
        const Ring& own = m_rings[ring];
        if (own.points == 1) return placeOf(own.vertex);
        const double turn = double(line) * own.points / tube.points;
        const auto low = static_cast<std::uint32_t>(turn);
        const glm::dvec3 place = glm::mix(placeOf(own.vertex + low), placeOf(own.vertex + std::min(low + 1, own.points)), turn - low);
        const glm::dvec3 within = glm::mix(own.middle, place, width);
        return m_isClone && ring == 0 ? glm::mix(base, within, kWithinSource) : within;
    }
    /// Lets lines start in the middle of what is drawn of the wood: a thin one is a prism beside its axis.
    void startInMiddle() { base = middleOfWood(0); }
    /// In what is drawn of the wood, so many radii of it below the tube's base.
    glm::dvec3 middleOfWood(double below) const {
        if (m_isClone) return base;
        const CStem& stem = own().stems[tube.stem];
        const CGeneration& generation = m_tree.generation(m_generation - 1);
        const StemMesh& wood = m_stems[m_generation - 1];
        const CStem& parent = generation.stems[static_cast<std::size_t>(stem.parent)];
        const std::int32_t index = wood.plan.tubeOfPath[parent.firstPath + wood.plan.drawnPath(generation, parent, stem.path)];
        if (index < 0) return base;
        return CTubeWalls(generation, wood.plan, wood.plan.tubes[static_cast<std::size_t>(index)]).middleAt(*wood.mesh, stem.offset - below * m_unit);
    }
    /// So many metres along a line, from the base; nothing beyond the last ring.
    std::optional<glm::dvec3> placeAt(std::uint32_t line, double along) const {
        glm::dvec3 low = base;
        for (std::uint32_t r = 0; r < rings(); ++r) {
            const glm::dvec3 high = at(r, line);
            const double length = glm::distance(low, high);
            if (along < length) return glm::mix(low, high, along / length);
            along -= length;
            low = high;
        }
        return {};
    }
    /// Repeats of the bark along the tube at its base. Of lines with two rings.
    double barkPerMetre() const {
        const std::uint32_t own = rings() > tube.collarRings + 1 ? tube.collarRings : 0;
        const Ring &low = m_rings[own], &high = m_rings[own + 1];
        const double length = glm::distance(placeOf(low.vertex), placeOf(high.vertex));
        return length > 0 ? (double(m_mesh.texCoords[high.vertex].y) - double(m_mesh.texCoords[low.vertex].y)) / length : 0;
    }
    /// What the lines lie in up to a ring, from the one before or the base.
    CWoodPatch::Capsule around(std::uint32_t ring) const {
        CWoodPatch::Capsule own{ring == 0 ? base : m_rings[ring - 1].middle, m_rings[ring].middle, 0};
        for (std::uint32_t i = 0; i < tube.points; ++i) {
            own.radius = std::max(own.radius, glm::distance(own.to, at(ring, i)));
            if (ring > 0) own.radius = std::max(own.radius, glm::distance(own.from, at(ring - 1, i)));
        }
        own.radius += kRoom * radius + 2 * kBeyond * glm::distance(own.from, own.to);
        return own;
    }
    Bounds bounds() const {
        Bounds all{glm::vec3(base - m_around), glm::vec3(base + m_around)};
        for (std::uint32_t r = 0; r < rings(); ++r) {
            const CWoodPatch::Capsule own = around(r);
            for (const glm::dvec3& end : {own.from, own.to}) {
                include(all, glm::vec3(end - own.radius - radius));
                include(all, glm::vec3(end + own.radius + radius));
            }
        }
        return all;
    }

private:
    struct Ring {
        std::uint32_t vertex, points; ///< one at the tip
        glm::dvec3 middle;
    };
    static constexpr double kRoom = 0.1; // radii of the tube
    static constexpr double kWithinSource = 0.8; // a clone starts with a ring of the path that it parts from; its lines are to start within

    const CGeneration& own() const { return m_tree.generation(m_generation); }
    glm::dvec3 placeOf(std::uint32_t vertex) const { return glm::dvec3(m_mesh.positions[vertex]); }
    void addRing(std::uint32_t vertex, std::uint32_t points) {
        glm::dvec3 middle(0);
        for (std::uint32_t i = 0; i < points; ++i) middle += placeOf(vertex + i) / double(points);
        m_rings.push_back({vertex, points, middle});
    }
    void addRings(const MeshPlan& plan, double reach) {
        const stromar::Ring* own = plan.ringsOf(tube);
        for (std::uint32_t r = 1; r < tube.ringCount; ++r) {
            const bool tip = tube.pointed && r + 1 == tube.ringCount;
            const std::uint32_t before = m_rings.back().points;
            if (own[r].parted || (!tip && before % own[r].points != 0)) return;
            if (r > 1 && glm::distance(base, at(rings() - 1, 0)) > reach) return;
            addRing(m_rings.back().vertex + before + 1, tip ? 1 : own[r].points);
        }
    }
    const CTree& m_tree;
    std::span<const StemMesh> m_stems;
    std::size_t m_generation;
    const CMesh& m_mesh;
    std::vector<Ring> m_rings;
    bool m_isClone = false;
    double m_unit, m_around; ///< metres: a radius of the wood, see Reach
};

} // namespace stromar
