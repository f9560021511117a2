#include "TextOut.h"
#include "stromar/io/Writers.h"

namespace stromar {

namespace {
void writeMaterials(const ExportModel& model, std::ostream& stream) {
    CTextOut out(stream);
    for (const Material& look : model.materials) {
        out << "newmtl " << look.name << "\nKa 1 1 1\nKd ";
        if (look.texture.empty())
            out << look.colour.x << " " << look.colour.y << " " << look.colour.z;
        else
            out << "1 1 1";
        out << "\nKs 0 0 0\nillum 1\n";
        if (!look.texture.empty()) out << "map_Kd " << look.texture << "\n";
        if (const std::string& mask = look.opacity.texture.empty() ? look.texture : look.opacity.texture; look.cutOut && !mask.empty())
            out << "map_d " << mask << "\n";
        if (const std::string& normal = look.normal.texture; !normal.empty()) out << "norm " << normal << "\nmap_Bump " << normal << "\n";
        if (look.roughness.texture.empty())
            out << "Pr " << look.roughnessFactor << "\n";
        else
            out << "Pr 1\nmap_Pr " << look.roughness.texture << "\n";
        out << "\n";
    }
    out.flush();
}

void writeVertices(const CMesh& mesh, CTextOut& out) {
    for (const glm::vec3& p : mesh.positions) {
        out << "v " << p.x << " " << p.z << " " << -p.y << "\n";
        out.endRecord();
    }
    for (const glm::vec2& t : mesh.texCoords) {
        out << "vt " << t.x << " " << t.y << "\n";
        out.endRecord();
    }
    for (const glm::vec3& n : mesh.normals) {
        out << "vn " << n.x << " " << n.z << " " << -n.y << "\n";
        out.endRecord();
    }
}

void writeFaces(const CMesh& mesh, std::size_t first, CTextOut& out) {
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t vertex = first + mesh.indices[i];
        out << (i % 3 == 0 ? "f " : " ") << vertex << "/" << vertex << "/" << vertex << (i % 3 == 2 ? "\n" : "");
        out.endRecord();
    }
}
} // namespace

void writeObj(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    const std::filesystem::path library = path.parent_path() / (model.name + ".mtl"); // a name that every reader takes
    writeMaterials(model, files.create(library));
    CTextOut out(files.create(path));
    out << "# " << model.name << "\n# metres, y up\nmtllib " << library.filename().string() << "\n";
    std::size_t first = 1;
    for (const auto& mesh : model.meshes) {
        out << "o " << mesh->name << "\nusemtl " << model.materialOf(*mesh).name << "\n";
        writeVertices(*mesh, out);
        writeFaces(*mesh, first, out);
        first += mesh->vertexCount();
    }
    out.flush();
}

} // namespace stromar
