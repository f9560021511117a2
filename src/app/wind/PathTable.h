#pragma once
#include "Arrangement.h"
#include "stromar/model/ExportModel.h"
#include "stromar/tree/Wind.h"

namespace stromar {

/// One path of a stem in the table that leaves the program.
struct PathRow {
    std::uint32_t stem;  ///< in the wind's table
    std::int32_t parent; ///< the row it grows out of; of a clone, the one it splits from
    float along;         ///< metres from that stem's base
    std::uint32_t firstNode, nodes;
    float start;       ///< metres of the first node from the base of its stem
    std::uint32_t own; ///< row of the stem's path 0
};

/// The wind's table path by path, with what shaders ask of places on it.
class CPathTable {
public:
    explicit CPathTable(const CWindTable& table);

    const std::vector<PathRow>& rows() const { return m_rows; }
    std::uint32_t rowAt(const SwayPlace& place) const { return m_rowOfNode[place.index()]; }
    std::uint32_t stemNumberAt(const SwayPlace& place) const { return m_rows[rowAt(place)].stem; }
    const WindStem& stemAt(const SwayPlace& place) const { return m_table.stems()[stemNumberAt(place)]; }
    /// Metres from the stem's base.
    float alongAt(const SwayPlace& place) const {
        return glm::mix(m_along[place.index()], m_along[place.index() + 1], place.part);
    }

    /// How far the wood bends there, 0 not at all.
    struct Bend {
        float trunk;    ///< with the trunk
        float below;    ///< with all stems below
        float own;      ///< with its own stem
        float branches; ///< with all stems but the trunk
    };
    Bend bendAt(const SwayPlace& place) const;

    /// The tables of a file.
    DataTable stemTable(const Arrangement& to) const;
    DataTable nodeTable(const Arrangement& to) const;

private:
    void addStem(std::uint32_t index);
    void addBend(const WindStem& stem);

    const CWindTable& m_table;
    std::vector<PathRow> m_rows;
    std::vector<std::uint32_t> m_rowOfNode;
    std::vector<float> m_along; ///< by node
    std::vector<Bend> m_bends;  ///< by stem, at its base
};

} // namespace stromar
