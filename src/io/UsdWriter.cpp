#include "Axes.h"
#include "Identifier.h"
#include "TextOut.h"
#include "ZipOut.h"
#include "stromar/io/Writers.h"
#include "stromar/texture/Opacity.h"
#include <algorithm>
#include <glm/common.hpp>

namespace stromar {

namespace {
CTextOut& operator<<(CTextOut& out, const glm::vec3& v) { return out << "(" << v.x << ", " << v.y << ", " << v.z << ")"; }
CTextOut& operator<<(CTextOut& out, const glm::vec2& v) { return out << "(" << v.x << ", " << v.y << ")"; }

struct Quaternion {
    float real;
    glm::vec3 rest;
};
CTextOut& operator<<(CTextOut& out, const Quaternion& q) { return out << "(" << q.real << ", " << q.rest.x << ", " << q.rest.y << ", " << q.rest.z << ")"; }

/// A picture that the file refers to.
struct UsdPicture {
    std::string name; ///< of its shader
    std::string file; ///< as the file names it
    std::filesystem::path source;
};

/// One model as a layer of text.
class CUsdWriter {
public:
    /// `packed`: pictures lie in the same package.
    CUsdWriter(const ExportModel& model, bool packed) : m_model(model), m_packed(packed), m_root(identifier(model.name)) {}

    void write(std::ostream& stream) const {
        CTextOut out(stream);
        out << "#usda 1.0\n(\n    defaultPrim = \"" << m_root << "\"\n    doc = \"Stromar\"\n    metersPerUnit = 1\n    upAxis = \"Y\"\n";
        writeTimes(out);
        out << ")\n\ndef Xform \"" << m_root << "\" (\n    kind = \"component\"\n";
        if (hasLods()) out << "    variants = {\n        string LOD = \"LOD0\"\n    }\n    prepend variantSets = \"LOD\"\n";
        out << ")\n{\n";
        if (hasLods())
            writeLods(out);
        else
            for (std::size_t i = 0; i < m_model.meshes.size(); ++i) writeShape(i, out);
        out << "    def Scope \"Looks\"\n    {\n";
        for (const Material& look : m_model.materials) writeMaterial(look, out);
        out << "    }\n}\n";
        out.flush();
    }

    std::vector<UsdPicture> pictures() const {
        std::vector<UsdPicture> all;
        for (const Material& look : m_model.materials)
            for (const UsdPicture& picture : picturesOf(look)) all.push_back(picture);
        return all;
    }

private:
    bool hasLods() const { return !m_model.coarser.empty(); }

    void writeTimes(CTextOut& out) const {
        if (m_model.samples.empty()) return;
        out << "    startTimeCode = " << kFirstTime << "\n    endTimeCode = " << kFirstTime + m_model.samples.front().size() - 1
            << "\n    timeCodesPerSecond = " << float(m_model.samplesPerSecond) << "\n    framesPerSecond = " << float(m_model.samplesPerSecond) << "\n";
    }

    void writeLods(CTextOut& out) const {
        out << "    variantSet \"LOD\" = {\n";
        for (std::size_t lod = 0; lod <= m_model.coarser.size(); ++lod) {
            out << "    \"LOD" << lod << "\" {\n";
            for (const auto& mesh : lod == 0 ? m_model.meshes : m_model.coarser[lod - 1]) writeMesh(*mesh, identifier(mesh->name), out);
            out << "    }\n";
        }
        out << "    }\n\n";
    }

    void writeShape(std::size_t i, CTextOut& out) const {
        const CMesh& mesh = *m_model.meshes[i];
        if (!m_model.isInstanced(i)) return writeMesh(mesh, identifier(mesh.name), out, i < m_model.samples.size() ? &m_model.samples[i] : nullptr);
        const Instances& all = m_model.instances[i];
        const std::string name = identifier(mesh.name);
        out << "    def PointInstancer \"" << name << "\"\n    {\n        int[] protoIndices = [";
        for (std::size_t k = 0; k < all.places.size(); ++k) {
            out << (k == 0 ? "0" : ", 0");
            out.endRecord();
        }
        out << "]\n        rel prototypes = </" << m_root << "/" << name << "/" << kPrototype << ">\n";
        writeArray("point3f[] positions", all.places, yUp, "", out);
        writeArray("quath[] orientations", all.turns, [](const glm::vec4& turn) { return Quaternion{turn.w, yUp(glm::vec3(turn))}; }, "", out);
        writeArray("float3[] scales", all.sizes, [](const glm::vec3& size) { return glm::vec3(size.x, size.z, size.y); }, "", out);
        writeMesh(mesh, kPrototype, out);
        out << "    }\n\n";
    }

    std::string place(const Material& look) const { return "/" + m_root + "/Looks/" + identifier(look.name); }

    template <typename Values, typename Show>
    static void writeValues(const Values& values, Show&& show, CTextOut& out) {
        out << "[";
        const char* between = "";
        for (const auto& value : values) {
            out << between << show(value);
            out.endRecord();
            between = ", ";
        }
        out << "]";
    }

    template <typename Values, typename Show>
    static void writeArray(const char* name, const Values& values, Show&& show, const char* behind, CTextOut& out) {
        out << "        " << name << " = ";
        writeValues(values, show, out);
        out << behind << "\n";
    }

    /// What a mesh is, and at the moments of a motion or null.
    struct Shape {
        const CMesh& mesh;
        const Meshes* samples;
    };

    /// An attribute of a mesh: its value, and that of each moment where it moves. write(mesh) writes such a value.
    template <typename Write>
    static void writeAttribute(const char* name, const Shape& shape, bool moves, const char* behind, CTextOut& out, Write&& write) {
        if (moves) writeSamples(name, *shape.samples, out, write);
        out << "        " << name << " = "; // behind the samples, which three.js would otherwise show the first of
        write(shape.mesh);
        out << behind << "\n";
    }

    template <typename Write> static void writeSamples(const char* name, const Meshes& samples, CTextOut& out, Write&& write) {
        static const CMesh kNothing;
        out << "        " << name << ".timeSamples = {\n";
        for (std::size_t i = 0; i < samples.size(); ++i) {
            out << "            " << kFirstTime + i << ": ";
            write(samples[i] ? *samples[i] : kNothing);
            out << ",\n";
        }
        out << "        }\n";
    }

    static void writeExtent(const CMesh& mesh, CTextOut& out) {
        const Bounds bounds = mesh.positions.empty() ? Bounds{} : mesh.bounds();
        const glm::vec3 a = yUp(bounds.min), b = yUp(bounds.max);
        out << "[" << glm::min(a, b) << ", " << glm::max(a, b) << "]";
    }

    /// Whether its triangles are the same at all moments, and only their corners move.
    static bool keepsTriangles(const Shape& shape) {
        return std::ranges::all_of(*shape.samples, [&](const auto& sample) {
            return sample && sample->indices == shape.mesh.indices && sample->texCoords == shape.mesh.texCoords;
        });
    }

    void writeMesh(const CMesh& mesh, const std::string& name, CTextOut& out, const Meshes* samples = nullptr) const {
        constexpr const char* kByVertex = " (\n            interpolation = \"vertex\"\n        )";
        const Material& look = m_model.materialOf(mesh);
        const Shape shape{mesh, samples};
        const bool moves = samples != nullptr, changes = moves && !keepsTriangles(shape);
        out << "    def Mesh \"" << name << "\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n    {\n"
            << "        uniform bool doubleSided = " << (look.cutOut ? "1" : "0") << "\n";
        writeAttribute("float3[] extent", shape, moves, "", out, [&](const CMesh& one) { writeExtent(one, out); });
        writeAttribute("int[] faceVertexCounts", shape, changes, "", out, [&](const CMesh& one) {
            writeValues(std::vector<std::size_t>(one.triangleCount(), 3), [](std::size_t corners) { return corners; }, out);
        });
        writeAttribute("int[] faceVertexIndices", shape, changes, "", out, [&](const CMesh& one) { writeValues(one.indices, [](std::uint32_t v) { return std::size_t{v}; }, out); });
        writeAttribute("normal3f[] normals", shape, moves, kByVertex, out, [&](const CMesh& one) { writeValues(one.normals, yUp, out); });
        writeAttribute("point3f[] points", shape, moves, "", out, [&](const CMesh& one) { writeValues(one.positions, yUp, out); });
        writeAttribute("texCoord2f[] primvars:st", shape, changes, kByVertex, out, [&](const CMesh& one) { writeValues(one.texCoords, [](const glm::vec2& t) { return t; }, out); });
        out << "        rel material:binding = <" << place(look) << ">\n        uniform token subdivisionScheme = \"none\"\n    }\n\n";
    }

    std::vector<UsdPicture> picturesOf(const Material& look) const {
        std::vector<UsdPicture> all;
        const auto add = [&](const char* name, const PictureRef& ref) {
            if (ref.picture.empty()) return;
            const std::string inside = "textures/" + look.name + "_" + name + ref.picture.extension().string();
            all.push_back({name, m_packed ? inside : ref.texture, ref.picture});
        };
        add("diffuse", {look.texture, look.picture});
        add("normal", look.normal);
        add(look.packed ? "orm" : "roughness", look.roughness);
        return all;
    }

    static bool has(const std::vector<UsdPicture>& pictures, std::string_view name) {
        return std::ranges::find(pictures, name, &UsdPicture::name) != pictures.end();
    }

    void writeMaterial(const Material& look, CTextOut& out) const {
        const std::string own = place(look);
        const std::vector<UsdPicture> pictures = picturesOf(look);
        const auto connected = [&](const char* input, const char* picture, const char* output) {
            out << "                " << input << ".connect = <" << own << "/" << picture << ".outputs:" << output << ">\n";
        };
        out << "        def Material \"" << identifier(look.name) << "\"\n        {\n            token outputs:surface.connect = <" << own
            << "/surface.outputs:surface>\n\n            def Shader \"surface\"\n            {\n"
            << "                uniform token info:id = \"UsdPreviewSurface\"\n";
        if (has(pictures, "diffuse"))
            connected("color3f inputs:diffuseColor", "diffuse", "rgb");
        else
            out << "                color3f inputs:diffuseColor = " << look.colour << "\n";
        if (has(pictures, "normal")) connected("normal3f inputs:normal", "normal", "rgb");
        if (look.cutOut && has(pictures, "diffuse")) {
            connected("float inputs:opacity", "diffuse", "a");
            out << "                float inputs:opacityThreshold = " << float(kAlphaCut) << "\n";
        }
        if (has(pictures, "orm")) {
            connected("float inputs:occlusion", "orm", "r");
            connected("float inputs:roughness", "orm", "g");
            connected("float inputs:metallic", "orm", "b");
        } else {
            if (has(pictures, "roughness"))
                connected("float inputs:roughness", "roughness", "r");
            else
                out << "                float inputs:roughness = " << look.roughnessFactor << "\n";
            out << "                float inputs:metallic = 0\n";
        }
        out << "                token outputs:surface\n            }\n\n";
        if (!pictures.empty())
            out << "            def Shader \"st\"\n            {\n                uniform token info:id = \"UsdPrimvarReader_float2\"\n"
                << "                string inputs:varname = \"st\"\n                float2 outputs:result\n            }\n\n";
        for (const UsdPicture& picture : pictures) writePicture(picture, own, out);
        out << "        }\n\n";
    }

    static void writePicture(const UsdPicture& picture, const std::string& material, CTextOut& out) {
        out << "            def Shader \"" << picture.name << "\"\n            {\n                uniform token info:id = \"UsdUVTexture\"\n"
            << "                asset inputs:file = @" << picture.file << "@\n                float2 inputs:st.connect = <" << material
            << "/st.outputs:result>\n                token inputs:sourceColorSpace = \"" << (picture.name == "diffuse" ? "sRGB" : "raw") << "\"\n"
            << "                token inputs:wrapS = \"repeat\"\n                token inputs:wrapT = \"repeat\"\n";
        if (picture.name == "normal")
            out << "                float4 inputs:scale = (2, 2, 2, 1)\n                float4 inputs:bias = (-1, -1, -1, 0)\n";
        for (const char* output : {"float outputs:r", "float outputs:g", "float outputs:b", "float outputs:a", "float3 outputs:rgb"})
            out << "                " << output << "\n";
        out << "            }\n\n";
    }

    static constexpr std::size_t kFirstTime = 1;
    static constexpr const char* kPrototype = "prototype"; ///< of what stands at many places

    const ExportModel& m_model;
    bool m_packed;
    std::string m_root;
};
} // namespace

void writeUsda(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    CUsdWriter(model, false).write(files.create(path));
}

void writeUsdz(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    const CUsdWriter writer(model, true);
    CZipOut package(files.create(path));
    package.add(model.name + ".usda", [&](std::ostream& stream) { writer.write(stream); });
    for (const UsdPicture& picture : writer.pictures())
        package.add(picture.file, [&](std::ostream& stream) { stream << readFile(picture.source); });
    package.finish();
}

} // namespace stromar
