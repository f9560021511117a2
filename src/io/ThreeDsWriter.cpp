#include "ByteOut.h"
#include "stromar/io/Writers.h"

namespace stromar {

namespace {
using LittleOut = CByteOut<std::endian::little>;

constexpr std::size_t kMaxPerChunk = 65000; // vertices and faces are counted in 16 bits

enum ChunkId : std::uint16_t {
    kColour = 0x0011,
    kPercent = 0x0030,
    kVersion = 0x0002,
    kMeshVersion = 0x3D3E,
    kEditor = 0x3D3D,
    kMain = 0x4D4D,
    kObject = 0x4000,
    kTriangles = 0x4100,
    kVertices = 0x4110,
    kFaces = 0x4120,
    kFaceMaterial = 0x4130,
    kTexCoords = 0x4140,
    kSmoothing = 0x4150,
    kAxes = 0x4160,
    kMaterial = 0xAFFF,
    kMaterialName = 0xA000,
    kAmbient = 0xA010,
    kDiffuse = 0xA020,
    kTwoSided = 0xA081,
    kTexture = 0xA200,
    kOpacity = 0xA210,
    kMapFile = 0xA300,
    kMapFlags = 0xA351,
};
constexpr std::uint16_t kUseAlpha = 0x40;

/// A chunk: its length is known when the object dies.
class CThreeDsChunk {
public:
    CThreeDsChunk(LittleOut& out, ChunkId id) : m_out(out), m_start(out.size()) {
        out.u16(id);
        out.u32(0);
    }
    ~CThreeDsChunk() { m_out.patch32(m_start + 2, static_cast<std::uint32_t>(m_out.size() - m_start)); }
    CThreeDsChunk(const CThreeDsChunk&) = delete;
    CThreeDsChunk& operator=(const CThreeDsChunk&) = delete;

private:
    LittleOut& m_out;
    std::size_t m_start;
};

void addColour(LittleOut& out, ChunkId id, const glm::vec3& colour) {
    const CThreeDsChunk chunk(out, id);
    const CThreeDsChunk bytes(out, kColour);
    for (int i = 0; i < 3; ++i) out.u8(static_cast<std::uint8_t>(255 * colour[i] + 0.5f));
}

void addMap(LittleOut& out, ChunkId id, const std::string& file, std::uint16_t flags) {
    const CThreeDsChunk map(out, id);
    {
        const CThreeDsChunk percent(out, kPercent);
        out.u16(100);
    }
    {
        const CThreeDsChunk name(out, kMapFile);
        out.zeroText(file);
    }
    const CThreeDsChunk tiling(out, kMapFlags);
    out.u16(flags);
}

void addMaterial(LittleOut& out, const Material& look) {
    const CThreeDsChunk material(out, kMaterial);
    {
        const CThreeDsChunk name(out, kMaterialName);
        out.zeroText(look.name);
    }
    addColour(out, kAmbient, look.colour);
    addColour(out, kDiffuse, look.texture.empty() ? look.colour : glm::vec3(1));
    if (look.cutOut) const CThreeDsChunk twoSided(out, kTwoSided);
    if (look.texture.empty()) return;
    addMap(out, kTexture, look.texture, 0);
    if (look.cutOut) addMap(out, kOpacity, look.texture, kUseAlpha);
}

void addFaces(LittleOut& out, const MeshChunk& chunk, const std::string& material) {
    const auto count = static_cast<std::uint16_t>(chunk.indices.size() / 3);
    const CThreeDsChunk faces(out, kFaces);
    out.u16(count);
    for (std::size_t i = 0; i < chunk.indices.size(); ++i) {
        out.u16(static_cast<std::uint16_t>(chunk.indices[i]));
        if (i % 3 == 2) out.u16(7); // all three edges are visible
    }
    {
        const CThreeDsChunk faceMaterial(out, kFaceMaterial);
        out.zeroText(material);
        out.u16(count);
        for (std::uint16_t i = 0; i < count; ++i) out.u16(i);
    }
    const CThreeDsChunk smoothing(out, kSmoothing);
    for (std::uint16_t i = 0; i < count; ++i) out.u32(1);
}

void addObject(LittleOut& out, const CMesh& mesh, const MeshChunk& part, const std::string& name,
               const std::string& material) {
    const CThreeDsChunk object(out, kObject);
    out.zeroText(name);
    const CThreeDsChunk triangles(out, kTriangles);
    const auto count = static_cast<std::uint16_t>(part.vertices.size());
    {
        const CThreeDsChunk vertices(out, kVertices);
        out.u16(count);
        for (const std::uint32_t v : part.vertices)
            for (int i = 0; i < 3; ++i) out.f32(mesh.positions[v][i]);
    }
    {
        const CThreeDsChunk texCoords(out, kTexCoords);
        out.u16(count);
        for (const std::uint32_t v : part.vertices) {
            out.f32(mesh.texCoords[v].x);
            out.f32(mesh.texCoords[v].y);
        }
    }
    {
        const CThreeDsChunk axes(out, kAxes);
        for (int i = 0; i < 12; ++i) out.f32(i % 4 == 0 && i < 9 ? 1.f : 0.f);
    }
    addFaces(out, part, material);
}

/// Names have at most ten letters: "branch2_12".
std::string objectName(std::size_t mesh, const CMesh& whole, std::size_t part) {
    const std::string base = !isBark(whole.surface) ? whole.name
                             : mesh == 0            ? "trunk"
                                                            : "branch" + std::to_string(mesh);
    return base + "_" + std::to_string(part);
}
} // namespace

void write3ds(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    LittleOut out;
    {
        const CThreeDsChunk main(out, kMain);
        {
            const CThreeDsChunk version(out, kVersion);
            out.u32(3);
        }
        const CThreeDsChunk editor(out, kEditor);
        {
            const CThreeDsChunk version(out, kMeshVersion);
            out.u32(3);
        }
        for (const Material& look : model.materials) addMaterial(out, look);
        for (std::size_t m = 0; m < model.meshes.size(); ++m) {
            const CMesh& mesh = *model.meshes[m];
            const auto parts = cutIntoChunks(mesh, kMaxPerChunk, kMaxPerChunk);
            for (std::size_t p = 0; p < parts.size(); ++p)
                addObject(out, mesh, parts[p], objectName(m, mesh, p), model.materialOf(mesh).name);
        }
    }
    files.create(path).write(out.bytes().data(), static_cast<std::streamsize>(out.size()));
}

} // namespace stromar
