#include "TextOut.h"
#include "stromar/io/Writers.h"
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace stromar {

namespace {
/// POV-Ray is left-handed with y up: exchanging y and z keeps what one sees.
void put(CTextOut& out, const glm::vec3& v) { out << "<" << v.x << "," << v.z << "," << v.y << ">"; }

template <typename Vector, typename Put>
void putList(CTextOut& out, std::string_view keyword, const Vector& values, Put&& putOne) {
    out << "  " << keyword << " {\n    " << values.size();
    for (const auto& value : values) {
        out << ",\n    ";
        putOne(value);
        out.endRecord();
    }
    out << "\n  }\n";
}

void putFaces(CTextOut& out, const CMesh& mesh) {
    out << "  face_indices {\n    " << mesh.triangleCount();
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        out << ",\n    <" << std::size_t{mesh.indices[i]} << "," << std::size_t{mesh.indices[i + 1]} << ","
            << std::size_t{mesh.indices[i + 2]} << ">";
        out.endRecord();
    }
    out << "\n  }\n";
}

std::string_view imageType(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (ending == ".jpg" || ending == ".jpeg") return "jpeg";
    if (ending == ".tga") return "tga";
    if (ending == ".tif" || ending == ".tiff") return "tiff";
    if (ending == ".bmp") return "bmp";
    return "png";
}

void putTexture(CTextOut& out, const Material& look) {
    out << "#declare Tree_" << look.name << " = texture {\n";
    if (look.texture.empty())
        out << "  pigment { rgb <" << look.colour.x << "," << look.colour.y << "," << look.colour.z << "> }\n";
    else
        out << "  uv_mapping\n  pigment { image_map { " << imageType(look.texture) << " \"" << look.texture
            << "\" interpolate 2 } }\n";
    out << "  finish { diffuse " << (look.cutOut ? "0.6, 0.4" : "0.85") << " ambient 0.12 }\n}\n";
}

void putMesh(CTextOut& out, const CMesh& mesh, const Material& look) {
    out << "mesh2 { // " << mesh.name << "\n";
    putList(out, "vertex_vectors", mesh.positions, [&](const glm::vec3& p) { put(out, p); });
    putList(out, "normal_vectors", mesh.normals, [&](const glm::vec3& n) { put(out, n); });
    putList(out, "uv_vectors", mesh.texCoords, [&](const glm::vec2& t) { out << "<" << t.x << "," << t.y << ">"; });
    putFaces(out, mesh);
    out << "  texture { Tree_" << look.name << " }\n}\n";
}

Bounds boundsOf(const ExportModel& model) {
    if (model.meshes.empty()) return {{-1, -1, 0}, {1, 1, 2}}; // a tree before its life
    Bounds all = model.meshes.front()->bounds();
    for (const auto& mesh : model.meshes) {
        const Bounds own = mesh->bounds();
        all = {glm::min(all.min, own.min), glm::max(all.max, own.max)};
    }
    return all;
}

void putStage(CTextOut& out, const Bounds& box) {
    const glm::vec3 middle = (box.min + box.max) / 2.f;
    const float size = glm::length(box.max - box.min);
    out << "\n// A stage; declare Tree_Only before including this file to get the object alone.\n"
           "#ifndef (Tree_Only)\nglobal_settings { assumed_gamma 1.0 }\nbackground { rgb <0.62,0.75,0.9> }\ncamera {\n "
           " location ";
    put(out, middle + glm::vec3(0, -1.35f * size, 0.1f * size));
    out << "\n  right x*image_width/image_height\n  angle 45\n  look_at ";
    put(out, middle);
    out << "\n}\nlight_source { ";
    put(out, middle + glm::vec3(-2, -3, 4) * size);
    out << " rgb <1.1,1.05,0.95> parallel point_at ";
    put(out, middle);
    out << " }\nlight_source { ";
    put(out, middle + glm::vec3(3, -2, 1) * size);
    out << " rgb <0.35,0.4,0.5> parallel point_at ";
    put(out, middle);
    out << " shadowless }\nplane { y, 0 pigment { rgb <0.36,0.42,0.26> } }\nobject { Tree }\n#end\n";
}
} // namespace

void writePov(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    CTextOut out(files.create(path));
    out << "// " << model.name << "\n// metres, y up\n#version 3.7;\n";
    for (const Material& look : model.materials) putTexture(out, look);
    out << "#declare Tree = union {\n";
    if (model.meshes.empty()) out << "sphere { 0, 1e-6 }\n"; // a union has to have something
    for (const auto& mesh : model.meshes) putMesh(out, *mesh, model.materialOf(*mesh));
    out << "}\n";
    putStage(out, boundsOf(model));
    out.flush();
}

} // namespace stromar
