#include "Axes.h"
#include "Identifier.h"
#include "TextOut.h"
#include "stromar/io/Writers.h"
#include <cctype>

namespace stromar {

namespace {
/// A reference to a file: what is not a plain letter is written by its bytes.
std::string uri(const std::string& path) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string text;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || std::string_view("-._~/").find(c) != std::string_view::npos)
            text += c;
        else
            text += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
    return text;
}

/// A picture that a material's file refers to.
struct DaePicture {
    std::string id;
    std::string file;
};

/// COLLADA 1.4.1 as a stream: no copy of the model is made.
class CDaeWriter {
public:
    CDaeWriter(const ExportModel& model, std::ostream& stream) : m_model(model), m_out(stream) {}

    void write() {
        m_out << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
                 "<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n"
                 "<asset><contributor><authoring_tool>Stromar</authoring_tool></contributor>"
                 "<created>2000-01-01T00:00:00Z</created><modified>2000-01-01T00:00:00Z</modified>" // the same model, the same bytes
                 "<unit name=\"meter\" meter=\"1\"/><up_axis>Y_UP</up_axis></asset>\n";
        section("library_images", [&] { forMaterials([&](const Material& look) { writeImages(look); }); });
        section("library_effects", [&] { forMaterials([&](const Material& look) { writeEffect(look); }); });
        section("library_materials", [&] { forMaterials([&](const Material& look) { writeMaterial(look); }); });
        section("library_geometries", [&] {
            for (std::size_t i = 0; i < m_model.meshes.size(); ++i) writeGeometry(*m_model.meshes[i], i);
        });
        section("library_visual_scenes", [&] { writeScene(); });
        m_out << "<scene><instance_visual_scene url=\"#scene\"/></scene>\n</COLLADA>\n";
        m_out.flush();
    }

private:
    template <typename Write> void section(const char* name, Write&& write) {
        m_out << "<" << name << ">\n";
        write();
        m_out << "</" << name << ">\n";
    }
    template <typename Write> void forMaterials(Write&& write) {
        for (const Material& look : m_model.materials) write(look);
    }

    static std::string idOf(const Material& look) { return identifier(look.name); }
    std::string idOf(std::size_t mesh) const { return "mesh" + std::to_string(mesh); }

    static std::vector<DaePicture> picturesOf(const Material& look) {
        std::vector<DaePicture> pictures;
        if (!look.texture.empty()) pictures.push_back({idOf(look) + "-colour", look.texture});
        if (!look.normal.texture.empty()) pictures.push_back({idOf(look) + "-normal", look.normal.texture});
        return pictures;
    }

    void writeImages(const Material& look) {
        for (const DaePicture& picture : picturesOf(look))
            m_out << "<image id=\"" << picture.id << "\" name=\"" << picture.id << "\"><init_from>" << uri(picture.file) << "</init_from></image>\n";
    }

    void writeTexture(const std::string& picture) { m_out << "<texture texture=\"" << picture << "-sampler\" texcoord=\"st\"/>"; }

    void writeEffect(const Material& look) {
        const std::string id = idOf(look);
        const bool hasPicture = !look.texture.empty(), hasRelief = !look.normal.texture.empty();
        m_out << "<effect id=\"" << id << "-effect\"><profile_COMMON>\n";
        for (const DaePicture& picture : picturesOf(look))
            m_out << "<newparam sid=\"" << picture.id << "-surface\"><surface type=\"2D\"><init_from>" << picture.id << "</init_from></surface></newparam>\n"
                  << "<newparam sid=\"" << picture.id << "-sampler\"><sampler2D><source>" << picture.id << "-surface</source></sampler2D></newparam>\n";
        m_out << "<technique sid=\"common\"><lambert><diffuse>";
        if (hasPicture)
            writeTexture(id + "-colour");
        else
            m_out << "<color>" << look.colour.x << " " << look.colour.y << " " << look.colour.z << " 1</color>";
        m_out << "</diffuse>";
        if (look.cutOut && hasPicture) {
            m_out << "<transparent opaque=\"A_ONE\">";
            writeTexture(id + "-colour");
            m_out << "</transparent><transparency><float>1</float></transparency>";
        }
        m_out << "</lambert>";
        if (hasRelief) { // no part of the standard; several programs read it so
            m_out << "<extra><technique profile=\"FCOLLADA\"><bump bumptype=\"NORMALMAP\">";
            writeTexture(id + "-normal");
            m_out << "</bump></technique></extra>";
        }
        m_out << "</technique>\n";
        if (look.cutOut) m_out << "<extra><technique profile=\"GOOGLEEARTH\"><double_sided>1</double_sided></technique></extra>\n";
        m_out << "</profile_COMMON></effect>\n";
    }

    void writeMaterial(const Material& look) {
        m_out << "<material id=\"" << idOf(look) << "\" name=\"" << idOf(look) << "\"><instance_effect url=\"#" << idOf(look) << "-effect\"/></material>\n";
    }

    template <typename Vectors, typename Show>
    void writeSource(const std::string& id, const Vectors& values, std::string_view components, Show&& show) {
        m_out << "<source id=\"" << id << "\"><float_array id=\"" << id << "-array\" count=\"" << values.size() * components.size() << "\">";
        for (const auto& value : values) {
            const auto shown = show(value);
            for (int i = 0; i < shown.length(); ++i) m_out << shown[i] << " ";
            m_out.endRecord();
        }
        m_out << "</float_array><technique_common><accessor source=\"#" << id << "-array\" count=\"" << values.size() << "\" stride=\"" << components.size() << "\">";
        for (std::size_t i = 0; i < components.size(); ++i) m_out << "<param name=\"" << components.substr(i, 1) << "\" type=\"float\"/>";
        m_out << "</accessor></technique_common></source>\n";
    }

    void writeGeometry(const CMesh& mesh, std::size_t number) {
        const std::string id = idOf(number);
        m_out << "<geometry id=\"" << id << "\" name=\"" << identifier(mesh.name) << "\"><mesh>\n";
        writeSource(id + "-positions", mesh.positions, "XYZ", yUp);
        writeSource(id + "-normals", mesh.normals, "XYZ", yUp);
        writeSource(id + "-st", mesh.texCoords, "ST", [](const glm::vec2& t) { return t; });
        m_out << "<vertices id=\"" << id << "-vertices\"><input semantic=\"POSITION\" source=\"#" << id << "-positions\"/></vertices>\n"
              << "<triangles material=\"own\" count=\"" << mesh.triangleCount() << "\">";
        constexpr std::pair<const char*, const char*> kInputs[] = {{"VERTEX", "-vertices"}, {"NORMAL", "-normals"}, {"TEXCOORD", "-st"}};
        for (const auto& [semantic, source] : kInputs)
            m_out << "<input semantic=\"" << semantic << "\" source=\"#" << id << source << "\" offset=\"0\"" << (*semantic == 'T' ? " set=\"0\"" : "") << "/>";
        m_out << "<p>";
        for (const std::uint32_t vertex : mesh.indices) {
            m_out << std::size_t{vertex} << " ";
            m_out.endRecord();
        }
        m_out << "</p></triangles>\n</mesh></geometry>\n";
    }

    /// A node per mesh under one that bears the model's name.
    void writeScene() {
        m_out << "<visual_scene id=\"scene\"><node id=\"tree\" name=\"" << identifier(m_model.name) << "\">\n";
        for (std::size_t i = 0; i < m_model.meshes.size(); ++i)
            m_out << "<node id=\"node" << i << "\" name=\"" << identifier(m_model.meshes[i]->name) << "\"><instance_geometry url=\"#" << idOf(i)
                  << "\"><bind_material><technique_common><instance_material symbol=\"own\" target=\"#" << idOf(m_model.materialOf(*m_model.meshes[i]))
                  << "\"><bind_vertex_input semantic=\"st\" input_semantic=\"TEXCOORD\" input_set=\"0\"/></instance_material>"
                     "</technique_common></bind_material></instance_geometry></node>\n";
        m_out << "</node></visual_scene>\n";
    }

    const ExportModel& m_model;
    CTextOut m_out;
};
} // namespace

void writeDae(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) { CDaeWriter(model, files.create(path)).write(); }

} // namespace stromar
