#include "CollisionExport.h"
#include "stromar/app/Collision.h"
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>

namespace stromar {

namespace {
constexpr int kSides = 8, kRings = 2; // of a round end, without its pole

/// Counter-clockwise seen from outside, in one piece.
std::shared_ptr<CMesh> meshOf(const Capsule& capsule) {
    auto mesh = std::make_shared<CMesh>();
    mesh->surface = Surface::Bark;
    const glm::dvec3 along = capsule.to - capsule.from;
    const glm::dvec3 z = glm::length(along) > 0 ? glm::normalize(along) : glm::dvec3(0, 0, 1);
    const glm::dvec3 x = glm::normalize(glm::cross(z, std::abs(z.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0))), y = glm::cross(z, x);
    const auto add = [&](const glm::dvec3& middle, const glm::dvec3& direction) {
        mesh->positions.push_back(glm::vec3(middle + capsule.radius * direction));
        mesh->normals.push_back(glm::vec3(direction));
        mesh->texCoords.push_back(glm::vec2(0));
        mesh->looks.push_back({});
    };
    add(capsule.from, -z);
    for (int ring = -kRings; ring <= kRings; ++ring) {
        if (ring == 0) continue; // each end has its own middle ring
        const bool lower = ring < 0;
        const double up = glm::half_pi<double>() * (lower ? ring + 1 : ring - 1) / kRings;
        for (int i = 0; i < kSides; ++i) {
            const double turn = glm::two_pi<double>() * i / kSides;
            add(lower ? capsule.from : capsule.to, std::cos(up) * (std::cos(turn) * x + std::sin(turn) * y) + std::sin(up) * z);
        }
    }
    add(capsule.to, z);
    const auto last = static_cast<std::uint32_t>(mesh->vertexCount()) - 1;
    const auto vertex = [](int ring, int i) { return static_cast<std::uint32_t>(1 + ring * kSides + i % kSides); };
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (const std::uint32_t corner : {a, b, c}) mesh->indices.push_back(corner);
    };
    for (int i = 0; i < kSides; ++i) {
        triangle(0, vertex(0, i + 1), vertex(0, i));
        for (int ring = 0; ring + 1 < 2 * kRings; ++ring) {
            triangle(vertex(ring, i), vertex(ring, i + 1), vertex(ring + 1, i));
            triangle(vertex(ring, i + 1), vertex(ring + 1, i + 1), vertex(ring + 1, i));
        }
        triangle(last, vertex(2 * kRings - 1, i), vertex(2 * kRings - 1, i + 1));
    }
    return mesh;
}

std::string numbered(const char* pattern, const std::string& name, std::size_t number) {
    std::string text(name.size() + 64, '\0');
    text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), pattern, name.c_str(), number)));
    return text;
}

/// As engines look for them by name.
std::string nameOf(ExportedCollision kind, const ExportModel& model, std::size_t number) {
    if (kind == ExportedCollision::Unreal) return numbered("UCX_%s_%02zu", model.meshes.front()->name, number);
    return numbered("%s_collision_%02zu-colonly", model.name, number);
}
} // namespace

void addCollision(ExportModel& model, const CTree& tree, const ExportOptions& options, const Format& format, const Arrangement& to,
                  const std::filesystem::path& path, CFileSet& files) {
    const auto kind = static_cast<ExportedCollision>(options.collision);
    if (kind == ExportedCollision::None) return;
    auto list = nlohmann::ordered_json::array();
    const auto inFile = [&](const glm::dvec3& point) {
        const glm::vec3 p = to.point(glm::vec3(point));
        return format.upAxis == "y" ? nlohmann::ordered_json{p.x, p.z, -p.y} : nlohmann::ordered_json{p.x, p.y, p.z};
    };
    std::vector<std::shared_ptr<const CMesh>> hulls;
    for (const Capsule& capsule : collisionOf(tree)) {
        list.push_back({{"from", inFile(capsule.from)}, {"to", inFile(capsule.to)}, {"radius", float(capsule.radius) * to.scale}});
        if (kind == ExportedCollision::Json) continue;
        const std::shared_ptr<CMesh> hull = meshOf(capsule);
        hull->name = nameOf(kind, model, hulls.size());
        for (glm::vec3& p : hull->positions) p = to.point(p);
        for (glm::vec3& n : hull->normals) n = to.direction(n);
        hulls.push_back(hull);
    }
    for (const auto& hull : hulls) {
        model.meshes.push_back(hull);
        if (!model.channels.empty()) model.channels.emplace_back();
    }
    files.create(path.parent_path() / (model.name + "_collision.json")) << nlohmann::ordered_json{{"up", format.upAxis}, {"capsules", list}}.dump(1) << "\n";
}

} // namespace stromar
