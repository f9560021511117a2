#include "VertexColours.h"
#include "stromar/mesh/Shading.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace stromar {

namespace {
constexpr const char* kColour = "COLOR_0";
constexpr const char* kOcclusion = "_OCCLUSION";

/// 0 to 1, another for every leaf, the same at every level of detail.
double numberOf(const CLeaf& leaf, std::uint64_t salt) {
    std::uint64_t bits = salt;
    for (int axis = 0; axis < 3; ++axis) {
        bits ^= std::bit_cast<std::uint32_t>(leaf.position[axis]);
        bits *= 0x9E3779B97F4A7C15u;
        bits ^= bits >> 29;
    }
    return double(bits >> 40) / double(1 << 24);
}

/// As the window tints a leaf, times its picture.
struct LeafTint {
    double variation, sunAndShade;

    bool isPlain() const { return variation == 0 && sunAndShade == 0; }
    /// `open`: how much of the sky it sees, 0 to 1.
    glm::dvec3 of(const CLeaf& leaf, double open) const {
        const double lightness = numberOf(leaf, 1) - 0.5, hue = numberOf(leaf, 2) - 0.5;
        const glm::dvec3 own = kLeafTint + variation * (lightness * glm::dvec3(1, 0.76, 0.8) + hue * glm::dvec3(0.45, 0, -0.3));
        const double lit = std::clamp((open - kInTheMiddle) / (1 - kInTheMiddle), 0.0, 1.0);
        return glm::clamp(own * sunAndShadeAt(lit, sunAndShade), 0.0, 1.0);
    }
};

/// Of the vertices of one mesh.
class CColourMaker {
public:
    CColourMaker(const CMesh& mesh, const Crown& crown, ExportedOcclusion occlusion) : m_mesh(mesh), m_crown(crown), m_occlusion(occlusion) {}

    void tint(const COrganMesh& organs, const LeafTint& tint) {
        if (tint.isPlain()) return;
        const std::size_t points = organs.blade().points.size();
        for (std::size_t i = 0; i < organs.count(); ++i)
            m_tints.push_back(tint.of(organs.leaf(i), double(ambientAt(m_crown, m_mesh, i * points)) / 255));
        m_points = points;
    }

    void addTo(VertexChannels& channels) const {
        const bool taken = std::ranges::find(channels, kColour, &VertexChannel::name) != channels.end(); // by the wind
        if (!taken && (!m_tints.empty() || m_occlusion == ExportedOcclusion::InColours)) channels.push_back(colours());
        if (m_occlusion == ExportedOcclusion::Attribute) channels.push_back(occlusion());
    }

private:
    VertexChannel colours() const {
        VertexChannel channel{kColour, VertexChannel::Type::Byte, 4, {}};
        channel.bytes.reserve(4 * m_mesh.vertexCount());
        for (std::size_t v = 0; v < m_mesh.vertexCount(); ++v) {
            glm::dvec3 colour = m_tints.empty() ? glm::dvec3(1) : m_tints[v / m_points];
            if (m_occlusion == ExportedOcclusion::InColours) colour *= double(ambientAt(m_crown, m_mesh, v)) / 255;
            for (int c = 0; c < 3; ++c) channel.bytes += static_cast<char>(static_cast<std::uint8_t>(std::lround(255 * colour[c])));
            channel.bytes += '\xff';
        }
        return channel;
    }
    VertexChannel occlusion() const {
        VertexChannel channel{kOcclusion, VertexChannel::Type::Float, 1, {}};
        channel.bytes.reserve(sizeof(float) * m_mesh.vertexCount());
        for (std::size_t v = 0; v < m_mesh.vertexCount(); ++v) {
            const float open = static_cast<float>(ambientAt(m_crown, m_mesh, v)) / 255;
            channel.bytes.append(reinterpret_cast<const char*>(&open), sizeof open);
        }
        return channel;
    }

    const CMesh& m_mesh;
    const Crown& m_crown;
    ExportedOcclusion m_occlusion;
    std::vector<glm::dvec3> m_tints; ///< by leaf
    std::size_t m_points = 0;        ///< of a leaf
};

void addColours(std::vector<VertexChannels>& all, const Meshes& meshes, const Crown& crown, const TreeModel* model, ExportedOcclusion occlusion) {
    all.resize(meshes.size());
    std::vector<CColourMaker> makers;
    for (const auto& mesh : meshes) makers.emplace_back(*mesh, crown, occlusion);
    std::size_t next = 0;
    if (model)
        model->visitMeshes([&](const std::shared_ptr<const CMesh>&, int) { ++next; },
                           [&](const std::shared_ptr<const COrganMesh>& organs, int) {
                               const bool leaves = isLeaf(organs->surface());
                               makers[next++].tint(*organs, {model->params.common.leafColourV, leaves ? model->params.common.leafSunShade : 0});
                           });
    for (std::size_t i = 0; i < meshes.size(); ++i) makers[i].addTo(all[i]);
}
} // namespace

void addColours(ExportModel& model, std::span<const std::shared_ptr<const TreeModel>> lods, const ExportOptions& options) {
    const auto occlusion = static_cast<ExportedOcclusion>(options.occlusion);
    const Crown crown = crownOf(model.meshes);
    const auto lod = [&](std::size_t i) { return i < lods.size() ? lods[i].get() : nullptr; };
    addColours(model.channels, model.meshes, crown, lod(0), occlusion);
    model.coarserChannels.resize(model.coarser.size());
    for (std::size_t i = 0; i < model.coarser.size(); ++i) addColours(model.coarserChannels[i], model.coarser[i], crown, lod(i + 1), occlusion);
}

} // namespace stromar
