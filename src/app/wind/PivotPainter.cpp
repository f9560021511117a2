#include "wind/PivotPainter.h"
#include "wind/PutBytes.h"
#include "stromar/texture/HalfPicture.h"
#include "stromar/texture/TextureMaps.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr std::size_t kMostElements = 30000, kWidth = 256;
constexpr std::uint32_t kGenerations = 4;
constexpr float kCentimetres = 100;
constexpr double kExtentStep = 8; // centimetres of one of 256 steps

/// Left-handed, z up, centimetres: where an engine puts what a file with y up says in metres.
glm::vec3 inUnreal(const glm::vec3& file) { return {file.x, file.z, file.y}; }

/// The half float whose bits are those of `number` + 1024: never denormal, so that no reader rounds it to 0.
float packed(std::size_t number) {
    const auto bits = static_cast<int>(number + 1024);
    return static_cast<float>(std::ldexp(1024 + (bits & 1023), (bits >> 10) - 25));
}

std::uint8_t byteOf(double share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}
} // namespace

CPivotPainter::CPivotPainter(const CWindTable& table)
    : m_table(table), m_elements(table, kMostElements, [&](std::uint32_t stem) {
          return table.stems()[stem].generation < kGenerations;
      }) {}

std::size_t CPivotPainter::lines() const {
    return std::max<std::size_t>(1, (m_elements.leaders().size() + kWidth - 1) / kWidth);
}

glm::vec2 CPivotPainter::texelOf(std::uint32_t stem) const {
    const auto element = static_cast<std::size_t>(std::max(0, m_elements.leaderOf(stem)));
    return {(float(element % kWidth) + 0.5f) / float(kWidth), (float(element / kWidth) + 0.5f) / float(lines())};
}

/// A root is its own parent.
float CPivotPainter::parentOf(std::size_t element) const {
    const int below = m_elements.leaderBelow(element);
    return packed(below < 0 ? element : static_cast<std::size_t>(below));
}

void CPivotPainter::write(const Arrangement& to, const std::filesystem::path& beside, CFileSet& files) const {
    std::vector<std::array<float, 4>> pivots(kWidth * lines());
    std::vector<std::array<std::uint8_t, 4>> axes(kWidth * lines());
    for (std::size_t e = 0; e < m_elements.leaders().size(); ++e) {
        const WindStem& stem = m_table.stems()[m_elements.leaders()[e]];
        const glm::vec3 foot = kCentimetres * inUnreal(yUp(to.point(glm::vec3(stem.base))));
        const glm::vec3 axis = inUnreal(yUp(to.direction(glm::vec3(stem.axis))));
        const double steps = double(kCentimetres) * stem.length * double(to.scale) / kExtentStep;
        pivots[e] = {foot.x, foot.y, foot.z, parentOf(e)};
        axes[e] = {byteOf((axis.x + 1) / 2), byteOf((axis.y + 1) / 2), byteOf((axis.z + 1) / 2),
                   byteOf(std::clamp(steps, 1.0, 256.0) / 256)};
    }
    const auto named = [&](const char* suffix) {
        std::filesystem::path path = beside;
        return path += suffix;
    };
    const auto width = static_cast<int>(kWidth), height = static_cast<int>(lines());
    writeExr(pivots, width, height, named("_PivotPos_Index.exr"), files);
    writePng(axes, width, height, named("_XVector_Extent.png"), files);
}

} // namespace stromar
