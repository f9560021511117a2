#pragma once
#include "Arrangement.h"
#include "wind/StemChoice.h"
#include <filesystem>
#include <glm/vec2.hpp>

namespace stromar {

class CFileSet;

/// What Unreal's Pivot Painter 2 material functions read: two pictures with a texel for each stem that turns about its
/// own foot. Limits are Epic's: 30,000 of them, four generations; other stems follow what bears them.
class CPivotPainter {
public:
    /// The table outlives this.
    explicit CPivotPainter(const CWindTable& table);

    /// The middle of a stem's texel as texture coordinates, v down. Where no texel is its own, the first.
    glm::vec2 texelOf(std::uint32_t stem) const;
    /// "oak" → "oak_PivotPos_Index.exr", half floats: foot in centimetres of Unreal's axes, parent; and
    /// "oak_XVector_Extent.png", 8 bits: direction, and length by 2,048 cm.
    void write(const Arrangement& to, const std::filesystem::path& beside, CFileSet& files) const;

private:
    std::size_t lines() const;
    float parentOf(std::size_t element) const;

    const CWindTable& m_table;
    CStemChoice m_elements;
};

} // namespace stromar
