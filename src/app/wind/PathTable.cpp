#include "wind/PathTable.h"
#include "wind/PutBytes.h"
#include <algorithm>

namespace stromar {

namespace {
float ownBend(const WindStem& stem, float along) {
    return static_cast<float>(stem.slenderness() * std::clamp(along / stem.length, 0.0, 1.0));
}
} // namespace

CPathTable::CPathTable(const CWindTable& table)
    : m_table(table), m_rowOfNode(table.nodeCount()), m_along(table.nodeCount()) {
    for (std::uint32_t s = 0; s < table.stems().size(); ++s) addStem(s);
    for (const WindStem& stem : table.stems()) addBend(stem);
}

CPathTable::Bend CPathTable::bendAt(const SwayPlace& place) const {
    const std::uint32_t index = m_rows[rowAt(place)].stem;
    const WindStem& stem = m_table.stems()[index];
    const float own = ownBend(stem, alongAt(place));
    const Bend& base = m_bends[index];
    if (stem.parent < 0) return {own, 0, own, 0};
    return {base.trunk, base.below, own, 1 - (1 - base.branches) * (1 - own)};
}

void CPathTable::addStem(std::uint32_t index) {
    const WindStem& stem = m_table.stems()[index];
    const CGeneration& all = m_table.tree().generation(stem.generation);
    const CStem& own = all.stems[stem.stem];
    const auto first = static_cast<std::uint32_t>(m_rows.size());
    for (std::uint32_t p = 0; p < own.pathCount; ++p) {
        const CPath& path = all.paths[own.firstPath + p];
        PathRow row{index,
                    -1,
                    0,
                    m_table.nodeOf(stem.generation, path.firstSegment),
                    path.segmentCount + 1,
                    static_cast<float>(all.segments[path.firstSegment].start),
                    first};
        if (path.source >= 0) {
            row.parent = static_cast<std::int32_t>(first) + path.source;
            row.along = row.start;
        } else if (stem.parent >= 0) {
            row.parent = static_cast<std::int32_t>(rowAt(stem.on));
            row.along = alongAt(stem.on);
        }
        float along = row.start;
        for (std::uint32_t n = 0; n < row.nodes; ++n) {
            m_rowOfNode[row.firstNode + n] = static_cast<std::uint32_t>(m_rows.size());
            m_along[row.firstNode + n] = along;
            if (n + 1 < row.nodes) along += static_cast<float>(all.segments[path.firstSegment + n].length);
        }
        m_rows.push_back(row);
    }
}

void CPathTable::addBend(const WindStem& stem) {
    if (stem.parent < 0) {
        m_bends.push_back({});
        return;
    }
    const Bend at = bendAt(stem.on);
    m_bends.push_back({at.trunk, 1 - (1 - at.below) * (1 - at.own), 0, at.branches});
}

DataTable CPathTable::stemTable(const Arrangement& to) const {
    DataTable out{
        "stems",
        {"base.x",       "base.y",       "base.z",     "axis.x",      "axis.y",       "axis.z", "x.x",
         "x.y",          "x.z",          "y.x",        "y.y",         "y.z",          "length", "diameter",
         "flexibility",  "angularSpeed", "phase",      "seed:uint32", "parent:int32", "along",  "firstNode:uint32",
         "nodes:uint32", "start",        "stem:uint32"},
        {}};
    for (const PathRow& row : m_rows) {
        const WindStem& stem = m_table.stems()[row.stem];
        for (const glm::vec3& v : {to.point(glm::vec3(stem.base)), to.direction(glm::vec3(stem.axis)),
                                   to.direction(glm::vec3(stem.x)), to.direction(glm::vec3(stem.y))})
            put(out.bytes, yUp(v));
        for (const double number :
             {stem.length * to.scale, stem.diameter * to.scale, stem.flexibility, stem.angularSpeed, stem.phase})
            put(out.bytes, static_cast<float>(number));
        put(out.bytes, stem.seed);
        put(out.bytes, row.parent);
        put(out.bytes, row.along * to.scale);
        put(out.bytes, row.firstNode);
        put(out.bytes, row.nodes);
        put(out.bytes, row.start * to.scale);
        put(out.bytes, row.own);
    }
    return out;
}

DataTable CPathTable::nodeTable(const Arrangement& to) const {
    DataTable out{"nodes", {"x", "y", "z", "along"}, {}};
    for (std::size_t n = 0; n < m_table.nodeCount(); ++n) {
        put(out.bytes, yUp(to.point(m_table.still()[n])));
        put(out.bytes, to.scale * m_along[n]);
    }
    return out;
}

} // namespace stromar
