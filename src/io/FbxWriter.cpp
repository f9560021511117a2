#include "Axes.h"
#include "FbxOut.h"
#include "stromar/io/Writers.h"
#include "stromar/mesh/Shading.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <span>

namespace stromar {

namespace {
constexpr float kCentimetres = 100; // in a metre
constexpr std::string_view kFileId("\x28\xb3\x2a\xeb\xb6\x24\xcc\xc2\xbf\xc8\xb0\x2a\xa9\x2b\xfc\xf1", 16);
constexpr const char* kFileTime = "1970-01-01 10:00:00:000"; // the id and the mark at the end belong to this time

/// Names of objects have their class behind them.
std::string named(std::string_view name, std::string_view kind) { return std::string(name) + std::string("\0\1", 2) + std::string(kind); }

/// A mesh and what its vertices carry, or null.
struct Part {
    const CMesh* mesh;
    const VertexChannels* channels;

    const VertexChannel* channel(std::string_view name) const {
        if (!channels) return nullptr;
        const auto found = std::ranges::find(*channels, name, &VertexChannel::name);
        return found == channels->end() ? nullptr : &*found;
    }
};
using Parts = std::vector<Part>;

Parts partsOf(const Meshes& meshes, const std::vector<VertexChannels>& channels) {
    Parts parts;
    for (std::size_t i = 0; i < meshes.size(); ++i) parts.push_back({meshes[i].get(), channels.empty() ? nullptr : &channels[i]});
    return parts;
}

double numberIn(const VertexChannel& channel, std::size_t place) {
    if (channel.type == VertexChannel::Type::Byte) return double(static_cast<std::uint8_t>(channel.bytes[place])) / 255;
    float value;
    std::memcpy(&value, channel.bytes.data() + place * sizeof value, sizeof value);
    return value;
}

/// `start(part)` gives get(vertex), a vector of `size` numbers.
template <typename Start>
auto ofVertices(const Parts& parts, int size, Start start) {
    std::size_t count = 0;
    for (const Part& part : parts) count += part.mesh->vertexCount();
    return fbxDoubles(count * static_cast<std::size_t>(size), [&parts, size, start](auto&& push) {
        for (const Part& part : parts) {
            const auto get = start(part);
            for (std::size_t v = 0; v < part.mesh->vertexCount(); ++v) {
                const auto value = get(v);
                for (int i = 0; i < size; ++i) push(double(value[i]));
            }
        }
    });
}

/// Where a part has no such channel, `otherwise`.
auto ofChannel(const Parts& parts, std::string_view name, int size, double otherwise) {
    return ofVertices(parts, size, [=](const Part& part) {
        return [=, channel = part.channel(name)](std::size_t v) {
            glm::dvec4 value(otherwise);
            for (int i = 0; channel && i < size; ++i) value[i] = numberIn(*channel, v * static_cast<std::size_t>(size) + static_cast<std::size_t>(i));
            return value;
        };
    });
}

/// The last corner of a polygon is told by its complement.
auto polygonsOf(const Parts& parts) {
    std::size_t corners = 0;
    for (const Part& part : parts) corners += part.mesh->indices.size();
    return fbxIntegers(corners, [&parts](auto&& push) {
        std::size_t first = 0;
        for (const Part& part : parts) {
            for (std::size_t i = 0; i < part.mesh->indices.size(); ++i) {
                const auto vertex = static_cast<std::int32_t>(first + part.mesh->indices[i]);
                push(i % 3 == 2 ? ~vertex : vertex);
            }
            first += part.mesh->vertexCount();
        }
    });
}

/// Numbers its objects, writes them one after another and remembers what hangs on what.
class CFbxWriter {
public:
    CFbxWriter(const ExportModel& model, std::ostream& stream) : m_model(model), m_out(stream) {}

    void write() {
        writeHead();
        writeSettings();
        writeDocuments();
        writeDefinitions();
        m_out.node("Objects", [&] { writeObjects(); });
        writeConnections();
        m_out.finish();
    }

private:
    using Id = std::int64_t;
    static constexpr Id kRoot = 0;

    Id newId() { return ++m_lastId; }

    // Properties70: name, type, label, flags, values.
    template <typename... Values>
    void property(const char* name, const char* type, const char* label, const char* flags, const Values&... values) {
        m_out.leaf("P", name, type, label, flags, values...);
    }
    void integer(const char* name, std::int32_t value) { property(name, "int", "Integer", "", value); }
    void number(const char* name, double value) { property(name, "Number", "", "A", value); }
    void colour(const char* name, const glm::vec3& c) { property(name, "Color", "", "A", double(c.x), double(c.y), double(c.z)); }

    void writeHead() {
        m_out.node("FBXHeaderExtension", [&] {
            m_out.leaf("FBXHeaderVersion", 1003);
            m_out.leaf("FBXVersion", 7400);
            m_out.leaf("EncryptionType", 0);
            m_out.leaf("Creator", "Stromar");
        });
        m_out.leaf("FileId", FbxBytes{kFileId});
        m_out.leaf("CreationTime", kFileTime);
        m_out.leaf("Creator", "Stromar");
    }

    /// Centimetres, y up, x to the right.
    void writeSettings() {
        m_out.node("GlobalSettings", [&] {
            m_out.leaf("Version", 1000);
            m_out.node("Properties70", [&] {
                integer("UpAxis", 1);
                integer("UpAxisSign", 1);
                integer("FrontAxis", 2);
                integer("FrontAxisSign", 1);
                integer("CoordAxis", 0);
                integer("CoordAxisSign", 1);
                integer("OriginalUpAxis", -1);
                integer("OriginalUpAxisSign", 1);
                property("UnitScaleFactor", "double", "Number", "", 1.0);
                property("OriginalUnitScaleFactor", "double", "Number", "", 1.0);
            });
        });
    }

    void writeDocuments() {
        m_out.node("Documents", [&] {
            m_out.leaf("Count", 1);
            m_out.node("Document", [&] { m_out.leaf("RootNode", kRoot); }, newId(), "", "Scene");
        });
        m_out.node("References", [] {});
    }

    bool hasLods() const { return !m_model.coarser.empty(); }

    void writeDefinitions() {
        const auto meshes = static_cast<std::int32_t>(hasLods() ? 1 + m_model.coarser.size() : m_model.meshes.size());
        std::int32_t pictures = 0;
        for (const Material& material : m_model.materials) pictures += static_cast<std::int32_t>(picturesOf(material).size());
        const std::pair<const char*, std::int32_t> kinds[] = {{"GlobalSettings", 1},
                                                              {"NodeAttribute", 1},
                                                              {"Model", meshes + 1},
                                                              {"Geometry", meshes},
                                                              {"Material", static_cast<std::int32_t>(m_model.materials.size())},
                                                              {"Texture", pictures},
                                                              {"Video", pictures}};
        std::int32_t count = 0;
        for (const auto& [kind, own] : kinds) count += own;
        m_out.node("Definitions", [&] {
            m_out.leaf("Version", 100);
            m_out.leaf("Count", count);
            for (const auto& [kind, own] : kinds) m_out.node("ObjectType", [&, n = own] { m_out.leaf("Count", n); }, kind);
        });
    }

    void writeObjects() {
        for (const Material& material : m_model.materials) writeMaterial(material);
        const Id top = hasLods() ? writeLodGroup() : writeNull();
        if (!hasLods()) {
            for (std::size_t i = 0; i < m_model.meshes.size(); ++i) {
                const Meshes one{m_model.meshes[i]};
                const auto own = m_model.channels.empty() ? std::vector<VertexChannels>() : std::vector<VertexChannels>{m_model.channels[i]};
                writeMesh(m_model.meshes[i]->name, one, own, top);
            }
            return;
        }
        writeMesh(lodName(0), m_model.meshes, m_model.channels, top);
        for (std::size_t lod = 1; lod <= m_model.coarser.size(); ++lod)
            writeMesh(lodName(lod), m_model.coarser[lod - 1],
                      m_model.coarserChannels.empty() ? std::vector<VertexChannels>() : m_model.coarserChannels[lod - 1], top);
    }
    std::string lodName(std::size_t lod) const { return m_model.name + "_LOD" + std::to_string(lod); }

    /// The node that all meshes hang on.
    template <typename Fill>
    Id writeTop(const char* kind, Fill&& attribute) {
        const Id own = newId(), top = newId();
        m_out.node("NodeAttribute", attribute, own, named(m_model.name, "NodeAttribute"), kind);
        writeModel(top, m_model.name, kind);
        connect(own, top);
        connect(top, kRoot);
        return top;
    }
    Id writeNull() {
        return writeTop("Null", [&] { m_out.leaf("TypeFlags", "Null"); });
    }
    /// Switches at per cent of the screen's height.
    Id writeLodGroup() {
        return writeTop("LodGroup", [&] {
            m_out.leaf("TypeFlags", "LodGroup");
            m_out.node("Properties70", [&] {
                property("ThresholdsUsedAsPercentage", "bool", "", "", 1);
                for (std::size_t lod = 0; lod < m_model.coarser.size(); ++lod)
                    property(("Thresholds|Level" + std::to_string(lod)).c_str(), "Distance", "", "",
                             100 * screenCoverage(lod, m_model.coarser.size() + 1), "cm");
            });
        });
    }

    void writeModel(Id id, const std::string& name, const char* kind) {
        m_out.node(
            "Model",
            [&] {
                m_out.leaf("Version", 232);
                m_out.node("Properties70", [&] {
                    property("InheritType", "enum", "", "", 1);
                    integer("DefaultAttributeIndex", 0);
                });
                m_out.leaf("Shading", true);
                m_out.leaf("Culling", "CullingOff");
            },
            id, named(name, "Model"), kind);
    }

    void writeMesh(const std::string& name, const Meshes& meshes, const std::vector<VertexChannels>& channels, Id top) {
        const Id geometry = newId(), node = newId();
        writeGeometry(geometry, name, partsOf(meshes, channels));
        writeModel(node, name, "Mesh");
        connect(geometry, node);
        connect(node, top);
        for (const std::size_t material : materialsIn(meshes)) connect(m_materials[material], node);
    }

    /// In the order in which the polygons number them.
    std::vector<std::size_t> materialsIn(const Meshes& meshes) const {
        std::vector<std::size_t> all;
        for (const auto& mesh : meshes)
            if (const std::size_t own = m_model.materialIndex(*mesh); std::ranges::find(all, own) == all.end()) all.push_back(own);
        return all;
    }

    void writeGeometry(Id id, const std::string& name, const Parts& parts) {
        m_out.node(
            "Geometry",
            [&] {
                m_out.leaf("GeometryVersion", 124);
                m_out.leaf("Vertices", ofVertices(parts, 3, [](const Part& part) {
                               return [mesh = part.mesh](std::size_t v) { return kCentimetres * yUp(mesh->positions[v]); };
                           }));
                m_out.leaf("PolygonVertexIndex", polygonsOf(parts));
                writeLayers(parts);
            },
            id, named(name, "Geometry"), "Mesh");
    }

    void writeLayers(const Parts& parts) {
        const auto has = [&](const char* channel) { return std::ranges::any_of(parts, [&](const Part& part) { return part.channel(channel); }); };
        std::vector<const char*> first{"LayerElementNormal", "LayerElementTangent", "LayerElementBinormal", "LayerElementUV", "LayerElementMaterial"};
        writeLayer(first[0], 0, 101, "", "Normals", ofVertices(parts, 3, [](const Part& part) {
                       return [mesh = part.mesh](std::size_t v) { return yUp(mesh->normals[v]); };
                   }));
        writeLayer(first[1], 0, 101, "UVMap", "Tangents", ofVertices(parts, 3, [](const Part& part) {
                       return [tangents = tangentsOf(*part.mesh)](std::size_t v) { return yUp(glm::vec3(tangents[v])); };
                   }));
        writeLayer(first[2], 0, 101, "UVMap", "Binormals", ofVertices(parts, 3, [](const Part& part) {
                       return [mesh = part.mesh, tangents = tangentsOf(*part.mesh)](std::size_t v) {
                           return tangents[v].w * yUp(glm::cross(mesh->normals[v], glm::vec3(tangents[v])));
                       };
                   }));
        writeLayer(first[3], 0, 101, "UVMap", "UV", ofVertices(parts, 2, [](const Part& part) {
                       return [mesh = part.mesh](std::size_t v) { return mesh->texCoords[v]; };
                   }));
        if (has("COLOR_0")) {
            writeLayer("LayerElementColor", 0, 101, "Color", "Colors", ofChannel(parts, "COLOR_0", 4, 1));
            first.push_back("LayerElementColor");
        }
        if (has("TEXCOORD_1")) writeLayer("LayerElementUV", 1, 101, "UVMap_1", "UV", ofChannel(parts, "TEXCOORD_1", 2, 0));
        writeMaterialLayer(parts);
        writeLayerList(0, first);
        if (has("TEXCOORD_1")) writeLayerList(1, {"LayerElementUV"});
    }

    /// A value for each vertex.
    template <typename Array>
    void writeLayer(const char* kind, std::int32_t number, std::int32_t version, const char* name, const char* values, const Array& array) {
        m_out.node(
            kind,
            [&] {
                m_out.leaf("Version", version);
                m_out.leaf("Name", name);
                m_out.leaf("MappingInformationType", "ByVertice");
                m_out.leaf("ReferenceInformationType", "Direct");
                m_out.leaf(values, array);
            },
            number);
    }

    void writeMaterialLayer(const Parts& parts) {
        Meshes borrowed;
        for (const Part& part : parts) borrowed.emplace_back(std::shared_ptr<const CMesh>(), part.mesh);
        const std::vector<std::size_t> order = materialsIn(borrowed);
        std::size_t triangles = 0;
        for (const Part& part : parts) triangles += part.mesh->triangleCount();
        const bool same = order.size() <= 1;
        m_out.node(
            "LayerElementMaterial",
            [&] {
                m_out.leaf("Version", 101);
                m_out.leaf("Name", "");
                m_out.leaf("MappingInformationType", same ? "AllSame" : "ByPolygon");
                m_out.leaf("ReferenceInformationType", "IndexToDirect");
                m_out.leaf("Materials", fbxIntegers(same ? 1 : triangles, [&](auto&& push) {
                               if (same) return push(0);
                               for (const Part& part : parts) {
                                   const auto at = std::ranges::find(order, m_model.materialIndex(*part.mesh)) - order.begin();
                                   for (std::size_t t = 0; t < part.mesh->triangleCount(); ++t) push(static_cast<std::int32_t>(at));
                               }
                           }));
            },
            0);
    }

    void writeLayerList(std::int32_t number, const std::vector<const char*>& kinds) {
        m_out.node(
            "Layer",
            [&] {
                m_out.leaf("Version", 100);
                for (const char* kind : kinds)
                    m_out.node("LayerElement", [&] {
                        m_out.leaf("Type", kind);
                        m_out.leaf("TypedIndex", number);
                    });
            },
            number);
    }

    /// A picture and what of the material it is.
    struct Picture {
        const char* use;
        std::string name;
        PictureRef file;
    };
    static std::vector<Picture> picturesOf(const Material& look) {
        std::vector<Picture> all;
        if (!look.picture.empty()) all.push_back({"DiffuseColor", look.name, {look.texture, look.picture}});
        if (look.cutOut && !look.opacity.picture.empty()) all.push_back({"TransparentColor", look.name + "_opacity", look.opacity});
        if (!look.normal.picture.empty()) all.push_back({"NormalMap", look.name + "_normal", look.normal});
        return all;
    }

    void writeMaterial(const Material& look) {
        const Id id = newId();
        m_materials.push_back(id);
        m_out.node(
            "Material",
            [&] {
                m_out.leaf("Version", 102);
                m_out.leaf("ShadingModel", "phong");
                m_out.leaf("MultiLayer", 0);
                m_out.node("Properties70", [&] {
                    colour("DiffuseColor", look.picture.empty() ? look.colour : glm::vec3(1));
                    number("DiffuseFactor", 1);
                    colour("EmissiveColor", glm::vec3(0));
                    number("EmissiveFactor", 0);
                    colour("SpecularColor", glm::vec3(0.2f));
                    number("SpecularFactor", 0.25);
                    number("Shininess", look.cutOut ? 9 : 1);
                    number("ReflectionFactor", 0);
                    number("Opacity", 1);
                });
            },
            id, named(look.name, "Material"), "");
        for (const Picture& picture : picturesOf(look)) writePicture(picture, id);
    }

    void writePicture(const Picture& picture, Id material) {
        const bool inside = picture.file.texture.empty();
        const std::string file = inside ? picture.name + picture.file.picture.extension().string() : picture.file.texture;
        const Id video = newId(), texture = newId();
        m_out.node(
            "Video",
            [&] {
                m_out.leaf("Type", "Clip");
                m_out.node("Properties70", [&] { property("Path", "KString", "XRefUrl", "", file); });
                m_out.leaf("UseMipMap", 0);
                m_out.leaf("Filename", file);
                m_out.leaf("RelativeFilename", file);
                if (inside) m_out.leaf("Content", FbxBytes{readFile(picture.file.picture)});
            },
            video, named(picture.name, "Video"), "Clip");
        m_out.node(
            "Texture",
            [&] {
                m_out.leaf("Type", "TextureVideoClip");
                m_out.leaf("Version", 202);
                m_out.leaf("TextureName", named(picture.name, "Texture"));
                m_out.node("Properties70", [&] {
                    property("UVSet", "KString", "", "", "UVMap");
                    property("UseMaterial", "bool", "", "", 1);
                });
                m_out.leaf("Media", named(picture.name, "Video"));
                m_out.leaf("FileName", file);
                m_out.leaf("RelativeFilename", file);
                m_out.leaf("ModelUVTranslation", 0.0, 0.0);
                m_out.leaf("ModelUVScaling", 1.0, 1.0);
                m_out.leaf("Texture_Alpha_Source", "None");
                m_out.leaf("Cropping", 0, 0, 0, 0);
            },
            texture, named(picture.name, "Texture"), "");
        connect(video, texture);
        m_connections.push_back({texture, material, picture.use});
    }

    struct Connection {
        Id from, to;
        const char* use; ///< the property of `to`; null: all of it
    };
    void connect(Id from, Id to) { m_connections.push_back({from, to, nullptr}); }

    void writeConnections() {
        m_out.node("Connections", [&] {
            for (const Connection& connection : m_connections)
                if (connection.use)
                    m_out.leaf("C", "OP", connection.from, connection.to, connection.use);
                else
                    m_out.leaf("C", "OO", connection.from, connection.to);
        });
    }

    const ExportModel& m_model;
    CFbxOut m_out;
    Id m_lastId = 1'000'000;
    std::vector<Id> m_materials;
    std::vector<Connection> m_connections;
};
} // namespace

void writeFbx(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) { CFbxWriter(model, files.create(path)).write(); }

} // namespace stromar
