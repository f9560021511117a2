#include "ByteOut.h"
#include "stromar/io/Writers.h"

namespace stromar {

namespace {
using BigOut = CByteOut<std::endian::big>;

constexpr const char* kUvMap = "UV";
constexpr std::uint32_t kMaxPoints = 0xFFFFFF; // indices have 24 bits

/// A chunk or, with a 16-bit length, a sub-chunk; padded to an even length.
class CLwoChunk {
public:
    CLwoChunk(BigOut& out, const char* id, bool sub = false) : m_out(out), m_sub(sub) {
        out.text(id);
        m_length = out.size();
        if (sub)
            out.u16(0);
        else
            out.u32(0);
        m_start = out.size();
    }
    ~CLwoChunk() {
        const auto length = static_cast<std::uint32_t>(m_out.size() - m_start);
        if (m_sub)
            m_out.patch16(m_length, static_cast<std::uint16_t>(length));
        else
            m_out.patch32(m_length, length);
        if (length % 2 == 1) m_out.u8(0);
    }
    CLwoChunk(const CLwoChunk&) = delete;
    CLwoChunk& operator=(const CLwoChunk&) = delete;

private:
    BigOut& m_out;
    bool m_sub;
    std::size_t m_length, m_start;
};

/// Text with a zero behind it, padded to an even length.
void putName(BigOut& out, const std::string& text) {
    out.zeroText(text);
    if (text.size() % 2 == 0) out.u8(0);
}

/// An index: two bytes when small, else four with the first 0xFF.
void putIndex(BigOut& out, std::size_t index) {
    if (index < 0xFF00)
        out.u16(static_cast<std::uint16_t>(index));
    else
        out.u32(0xFF000000u | static_cast<std::uint32_t>(index));
}

void addPoints(BigOut& out, const ExportModel& model) {
    const CLwoChunk chunk(out, "PNTS");
    for (const auto& mesh : model.meshes)
        for (const glm::vec3& p : mesh->positions) {
            out.f32(p.x);
            out.f32(p.z);
            out.f32(p.y);
        }
}

void addTexCoords(BigOut& out, const ExportModel& model) {
    const CLwoChunk chunk(out, "VMAP");
    out.text("TXUV");
    out.u16(2);
    putName(out, kUvMap);
    std::size_t point = 0;
    for (const auto& mesh : model.meshes)
        for (const glm::vec2& t : mesh->texCoords) {
            putIndex(out, point++);
            out.f32(t.x);
            out.f32(t.y);
        }
}

/// Front faces are clockwise here.
void addPolygons(BigOut& out, const ExportModel& model) {
    const CLwoChunk chunk(out, "POLS");
    out.text("FACE");
    std::size_t first = 0;
    for (const auto& mesh : model.meshes) {
        for (std::size_t t = 0; t < mesh->indices.size(); t += 3) {
            out.u16(3);
            for (const std::size_t corner : {t, t + 2, t + 1}) putIndex(out, first + mesh->indices[corner]);
        }
        first += mesh->vertexCount();
    }
}

void addPolygonTags(BigOut& out, const ExportModel& model) {
    const CLwoChunk chunk(out, "PTAG");
    out.text("SURF");
    std::size_t polygon = 0;
    for (const auto& mesh : model.meshes)
        for (std::size_t t = 0; t < mesh->triangleCount(); ++t) {
            putIndex(out, polygon++);
            out.u16(static_cast<std::uint16_t>(model.materialIndex(*mesh)));
        }
}

void addImage(BigOut& out, std::uint32_t number, const std::string& file) {
    const CLwoChunk clip(out, "CLIP");
    out.u32(number);
    const CLwoChunk still(out, "STIL", true);
    putName(out, file);
}

void addValue(BigOut& out, const char* id, float value) {
    const CLwoChunk chunk(out, id, true);
    out.f32(value);
    out.u16(0); // no envelope
}

void addTextureBlock(BigOut& out, std::uint32_t image) {
    const CLwoChunk block(out, "BLOK", true);
    {
        const CLwoChunk header(out, "IMAP", true);
        putName(out, "\x80");
        {
            const CLwoChunk channel(out, "CHAN", true);
            out.text("COLR");
        }
        const CLwoChunk enabled(out, "ENAB", true);
        out.u16(1);
    }
    {
        const CLwoChunk projection(out, "PROJ", true);
        out.u16(5); // by texture coordinates
    }
    {
        const CLwoChunk map(out, "VMAP", true);
        putName(out, kUvMap);
    }
    const CLwoChunk picture(out, "IMAG", true);
    putIndex(out, image);
}

void addSurface(BigOut& out, const Material& look, std::uint32_t image) {
    const CLwoChunk surface(out, "SURF");
    putName(out, look.name);
    putName(out, "");
    {
        const CLwoChunk colour(out, "COLR", true);
        for (int i = 0; i < 3; ++i) out.f32(look.texture.empty() ? look.colour[i] : 1.f);
        out.u16(0);
    }
    addValue(out, "DIFF", 1);
    {
        const CLwoChunk smooth(out, "SMAN", true);
        out.f32(1.56f); // smooth up to this angle, radians
    }
    {
        const CLwoChunk sides(out, "SIDE", true);
        out.u16(look.cutOut ? 3 : 1);
    }
    if (!look.texture.empty()) addTextureBlock(out, image);
}
} // namespace

void writeLwo(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    if (model.vertexCount() > kMaxPoints || model.triangleCount() > kMaxPoints)
        throw CError("a LightWave object holds at most 16,777,215 points and polygons; choose a lower level of detail");
    BigOut out;
    {
        const CLwoChunk form(out, "FORM");
        out.text("LWO2");
        {
            const CLwoChunk tags(out, "TAGS");
            for (const Material& look : model.materials) putName(out, look.name);
        }
        {
            const CLwoChunk layer(out, "LAYR");
            out.u16(0);
            out.u16(0);
            for (int i = 0; i < 3; ++i) out.f32(0);
            putName(out, model.name);
        }
        addPoints(out, model);
        addTexCoords(out, model);
        addPolygons(out, model);
        addPolygonTags(out, model);
        for (std::uint32_t i = 0; i < model.materials.size(); ++i)
            if (!model.materials[i].texture.empty()) addImage(out, i + 1, model.materials[i].texture);
        for (std::uint32_t i = 0; i < model.materials.size(); ++i) addSurface(out, model.materials[i], i + 1);
    }
    files.create(path).write(out.bytes().data(), static_cast<std::streamsize>(out.size()));
}

} // namespace stromar
