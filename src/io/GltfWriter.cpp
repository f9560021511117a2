#include "Axes.h"
#include "GltfBytes.h"
#include "stromar/io/Writers.h"
#include "stromar/mesh/Shading.h"
#include "stromar/texture/Opacity.h"
#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tiny_gltf.h>

namespace stromar {

static_assert(std::endian::native == std::endian::little, "glTF's buffers are little-endian");

namespace {
constexpr std::size_t kMostShort = 65'535; // vertices; its own number may stand for the end of a strip
constexpr std::uint64_t kLargestFile = 0xffffffff; // a GLB says its length in 32 bits

/// One after the other: what the parts of the buffer hold is described first and streamed later, so that no copy of the
/// model is made.
class CGltf {
public:
    CGltf(const ExportModel& source, bool embed) : m_source(source), m_embed(embed) {
        m_gltf.asset.version = "2.0";
        m_gltf.asset.generator = "Stromar";
        addMaterials();
        m_gltf.scenes.emplace_back();
        m_gltf.defaultScene = 0;
        m_gltf.buffers.emplace_back();
        addSkeleton();
        if (source.coarser.empty())
            addSingleModel();
        else
            addLods();
        for (const Clip& clip : source.clips) addClip(clip);
        addTables();
        require("KHR_mesh_quantization", quantised());
        require(kMeshopt, packed());
        require(kInstancing, std::ranges::any_of(source.instances, [](const Instances& of) { return !of.places.empty(); })); // else one huge leaf
    }

    std::uint64_t bufferBytes() const { return m_bytes; }

    /// The description; the buffer lies in the file `uri`, or in the same GLB when that is empty.
    std::string json(const std::string& uri) const {
        std::ostringstream text;
        tinygltf::TinyGLTF writer;
        writer.SetImageWriter(nullptr, nullptr); // pictures are copied or embedded as they are
        if (!writer.WriteGltfSceneToStream(&m_gltf, text, false, false))
            throw CError("the glTF library cannot describe the model");
        auto document = nlohmann::ordered_json::parse(text.str());
        if (m_bytes == 0) { // of an empty tree without pictures
            document.erase("buffers");
            return document.dump(uri.empty() ? -1 : 1);
        }
        document["buffers"][0] = {{"byteLength", m_bytes}};
        for (const auto& [view, description] : m_packedViews) // the library leaves out extensions of these
            document["bufferViews"][view]["extensions"][kMeshopt] = description;
        if (m_unpackedBytes > 0) // what it would be without: never there, but described
            document["buffers"][1] = {{"byteLength", m_unpackedBytes}, {"extensions", {{kMeshopt, {{"fallback", true}}}}}};
        if (!uri.empty()) document["buffers"][0]["uri"] = uri;
        return document.dump(uri.empty() ? -1 : 1);
    }

    void writeBuffer(std::ostream& out) const {
        std::uint64_t written = 0;
        for (const auto& part : m_parts) {
            const std::string bytes = part();
            out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
            const std::size_t padding = (4 - bytes.size() % 4) % 4;
            out.write("\0\0\0", static_cast<std::streamsize>(padding));
            written += bytes.size() + padding;
        }
        if (written != m_bytes) throw CError("the model changed while it was written");
    }

private:
    using Part = std::function<std::string()>;
    static constexpr const char *kMeshopt = "EXT_meshopt_compression", *kInstancing = "EXT_mesh_gpu_instancing";

    bool quantised() const { return m_source.compression != ExportModel::Compression::None; }
    bool packed() const { return m_source.compression == ExportModel::Compression::Meshopt; }
    void require(const char* extension, bool used) {
        if (!used || m_gltf.meshes.empty()) return;
        m_gltf.extensionsUsed.emplace_back(extension);
        m_gltf.extensionsRequired.emplace_back(extension);
    }

    void addMaterials() {
        m_gltf.samplers.emplace_back();
        m_gltf.samplers[0].minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
        m_gltf.samplers[0].magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
        for (const Material& look : m_source.materials) {
            tinygltf::Material material;
            material.name = look.name;
            material.pbrMetallicRoughness.metallicFactor = 0;
            material.pbrMetallicRoughness.roughnessFactor = double(look.roughnessFactor);
            material.doubleSided = look.cutOut;
            if (look.cutOut) {
                material.alphaMode = "MASK";
                material.alphaCutoff = kAlphaCut;
            }
            if (look.picture.empty())
                material.pbrMetallicRoughness.baseColorFactor = {look.colour.x, look.colour.y, look.colour.z, 1};
            else
                material.pbrMetallicRoughness.baseColorTexture.index =
                    addTexture(look.name, {look.texture, look.picture});
            if (!look.normal.picture.empty())
                material.normalTexture.index = addTexture(look.name + "_normal", look.normal);
            if (!look.roughness.picture.empty()) { // grey: its green counts, its blue is multiplied by no metal
                material.pbrMetallicRoughness.metallicRoughnessTexture.index =
                    addTexture(look.name + "_roughness", look.roughness);
                material.pbrMetallicRoughness.roughnessFactor = 1;
                if (look.packed) {
                    material.occlusionTexture.index = material.pbrMetallicRoughness.metallicRoughnessTexture.index;
                    material.pbrMetallicRoughness.metallicFactor = 1;
                }
            }
            if (look.cutOut && m_source.leafLight) addTransmission(material);
            m_gltf.materials.push_back(material);
        }
    }

    /// Light from behind comes through, in the colours of the picture.
    void addTransmission(tinygltf::Material& material) {
        constexpr const char* kName = "KHR_materials_diffuse_transmission";
        constexpr double kShare = 0.4; // of a leaf's light
        tinygltf::Value::Object values{{"diffuseTransmissionFactor", tinygltf::Value(kShare)}};
        if (const int picture = material.pbrMetallicRoughness.baseColorTexture.index; picture >= 0)
            values["diffuseTransmissionColorTexture"] = tinygltf::Value(tinygltf::Value::Object{{"index", tinygltf::Value(picture)}});
        material.extensions[kName] = tinygltf::Value(values);
        if (std::ranges::find(m_gltf.extensionsUsed, kName) == m_gltf.extensionsUsed.end()) m_gltf.extensionsUsed.emplace_back(kName);
    }

    int addTexture(const std::string& name, const PictureRef& look) {
        tinygltf::Image image;
        image.name = name;
        if (m_embed) {
            const auto bytes = std::make_shared<const std::string>(readFile(look.picture));
            image.mimeType = mimeTypeOf(*bytes, look.picture);
            image.bufferView = addView(bytes->size(), 0, [bytes] { return *bytes; });
        } else
            image.uri = look.texture;
        m_gltf.images.push_back(image);
        tinygltf::Texture texture;
        texture.sampler = 0;
        texture.source = static_cast<int>(m_gltf.images.size()) - 1;
        m_gltf.textures.push_back(texture);
        return static_cast<int>(m_gltf.textures.size()) - 1;
    }

    static std::string mimeTypeOf(const std::string& bytes, const std::filesystem::path& picture) {
        if (bytes.starts_with("\x89PNG")) return "image/png";
        if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
        throw CError(picture.string() + ": glTF takes PNG and JPEG pictures only");
    }

    /// One node per generation, under one that bears the model's name.
    void addSingleModel() {
        tinygltf::Node root;
        root.name = m_source.name;
        for (std::size_t i = 0; i < m_source.meshes.size(); ++i) {
            const auto& mesh = m_source.meshes[i];
            if (m_source.isInstanced(i)) {
                root.children.push_back(addInstanced(mesh, m_source.instances[i]));
                continue;
            }
            const int index = addMesh(mesh->name, {mesh}, m_source.channels, i);
            root.children.push_back(addNode(mesh->name, index, {mesh}));
        }
        if (!m_source.joints.empty()) { // what bones move hangs on nothing else
            for (const int node : root.children) m_gltf.scenes[0].nodes.push_back(node);
            return;
        }
        m_gltf.nodes.push_back(root);
        m_gltf.scenes[0].nodes.push_back(static_cast<int>(m_gltf.nodes.size()) - 1);
    }

    /// EXT_mesh_gpu_instancing. The mesh is whole: what a quantised one is measured in belongs to its node.
    int addInstanced(const std::shared_ptr<const CMesh>& mesh, const Instances& instances) {
        const std::size_t count = instances.places.size();
        tinygltf::Mesh own;
        own.name = mesh->name;
        own.primitives.push_back(makePrimitive(mesh, nullptr, nullptr));
        m_gltf.meshes.push_back(own);
        Attributes attributes;
        attributes["TRANSLATION"] = addVertices<glm::vec3>(count, TINYGLTF_TYPE_VEC3, [&instances](std::size_t i) { return yUp(instances.places[i]); });
        attributes["ROTATION"] = addStrided(count, kTurnStride, TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_SHORT, true,
                                            [&instances] { return quantisedTurns(instances.turns); });
        attributes["SCALE"] = addVertices<glm::vec3>(count, TINYGLTF_TYPE_VEC3, [&instances](std::size_t i) {
            return glm::vec3(instances.sizes[i].x, instances.sizes[i].z, instances.sizes[i].y);
        });
        for (const VertexChannel& channel : instances.channels) attributes[channel.name] = addChannel(channel, count);
        tinygltf::Value::Object named;
        for (const auto& [name, accessor] : attributes) named[name] = tinygltf::Value(accessor);
        tinygltf::Node node;
        node.name = mesh->name;
        node.mesh = static_cast<int>(m_gltf.meshes.size()) - 1;
        node.extensions[kInstancing] = tinygltf::Value(tinygltf::Value::Object{{"attributes", tinygltf::Value(named)}});
        m_gltf.nodes.push_back(node);
        return static_cast<int>(m_gltf.nodes.size()) - 1;
    }

    /// Bones at rest are only shifted; the first nodes of the file are theirs.
    void addSkeleton() {
        const auto& joints = m_source.joints;
        if (joints.empty()) return;
        tinygltf::Skin skin;
        skin.name = m_source.name + "_bones";
        std::vector<glm::mat4> toJoint;
        for (std::size_t j = 0; j < joints.size(); ++j) {
            const glm::vec3 base = yUp(joints[j].base), from = joints[j].parent < 0 ? glm::vec3(0) : yUp(joints[static_cast<std::size_t>(joints[j].parent)].base);
            tinygltf::Node node;
            node.name = joints[j].name;
            const glm::vec3 shift = base - from;
            node.translation = {shift.x, shift.y, shift.z};
            m_gltf.nodes.push_back(node);
            if (joints[j].parent >= 0) m_gltf.nodes[static_cast<std::size_t>(joints[j].parent)].children.push_back(static_cast<int>(j));
            skin.joints.push_back(static_cast<int>(j));
            glm::mat4 own(1);
            own[3] = glm::vec4(-base, 1);
            toJoint.push_back(own);
        }
        skin.skeleton = 0;
        skin.inverseBindMatrices = addNumbers(toJoint, TINYGLTF_TYPE_MAT4);
        m_gltf.skins.push_back(skin);
        m_gltf.scenes[0].nodes.push_back(0);
    }

    void addClip(const Clip& clip) {
        tinygltf::Animation animation;
        animation.name = clip.name;
        const int times = addNumbers(clip.seconds, TINYGLTF_TYPE_SCALAR);
        m_gltf.accessors.back().minValues = {clip.seconds.front()};
        m_gltf.accessors.back().maxValues = {clip.seconds.back()};
        const auto add = [&](std::size_t joint, const char* path, int values) {
            tinygltf::AnimationSampler sampler;
            sampler.input = times;
            sampler.output = values;
            sampler.interpolation = "LINEAR";
            tinygltf::AnimationChannel channel;
            channel.sampler = static_cast<int>(animation.samplers.size());
            channel.target_node = static_cast<int>(joint);
            channel.target_path = path;
            animation.samplers.push_back(sampler);
            animation.channels.push_back(channel);
        };
        for (std::size_t j = 0; j < clip.turns.size(); ++j) {
            if (clip.turns[j].empty()) continue;
            std::vector<glm::vec4> turns = clip.turns[j];
            for (glm::vec4& q : turns) q = glm::vec4(yUp(glm::vec3(q)), q.w);
            add(j, "rotation", addNumbers(turns, TINYGLTF_TYPE_VEC4));
        }
        for (std::size_t j = 0; j < clip.scales.size(); ++j) {
            if (clip.scales[j].empty()) continue;
            std::vector<glm::vec3> scales;
            for (const float scale : clip.scales[j]) scales.emplace_back(scale);
            add(j, "scale", addNumbers(scales, TINYGLTF_TYPE_VEC3));
        }
        if (!animation.channels.empty()) m_gltf.animations.push_back(animation);
    }

    /// In the extras of the scene: which part of the buffer holds which table, and the names of its columns.
    void addTables() {
        tinygltf::Value::Object all;
        for (const DataTable& table : m_source.tables) {
            const int view = addView(table.bytes.size(), 0, [bytes = &table.bytes] { return *bytes; });
            tinygltf::Value::Array columns;
            for (const std::string& column : table.columns) columns.emplace_back(column);
            all[table.name] = tinygltf::Value(tinygltf::Value::Object{
                {"bufferView", tinygltf::Value(view)},
                {"rows", tinygltf::Value(static_cast<int>(table.bytes.size() / (4 * table.columns.size())))},
                {"columns", tinygltf::Value(columns)}});
        }
        if (!all.empty()) m_gltf.scenes[0].extras = tinygltf::Value(tinygltf::Value::Object{{"wind", tinygltf::Value(all)}});
    }

    /// One mesh per level of detail, as engines want it; the node of the finest refers to the others (MSFT_lod).
    void addLods() {
        tinygltf::Value::Array ids, coverage;
        const std::size_t count = m_source.coarser.size() + 1;
        int first = 0;
        for (std::size_t lod = 0; lod < count; ++lod) {
            const std::string name = m_source.name + "_LOD" + std::to_string(lod);
            const bool carries = !m_source.channels.empty();
            const Meshes& parts = lod == 0 ? m_source.meshes : m_source.coarser[lod - 1];
            const int mesh = addMesh(name, parts, lod == 0 || !carries ? m_source.channels : m_source.coarserChannels[lod - 1]);
            const int node = addNode(name, mesh, parts, parts.front()->surface != Surface::Impostor);
            if (lod == 0) first = node;
            if (lod > 0) ids.emplace_back(node);
            coverage.emplace_back(screenCoverage(lod, count));
        }
        tinygltf::Node& finest = m_gltf.nodes[static_cast<std::size_t>(first)];
        finest.extensions["MSFT_lod"] = tinygltf::Value(tinygltf::Value::Object{{"ids", tinygltf::Value(ids)}});
        finest.extras = tinygltf::Value(tinygltf::Value::Object{{"MSFT_screencoverage", tinygltf::Value(coverage)}});
        m_gltf.extensionsUsed.emplace_back("MSFT_lod");
        m_gltf.scenes[0].nodes.push_back(first);
    }

    int addNode(const std::string& name, int mesh, const Meshes& parts, bool skinned = true) {
        tinygltf::Node node;
        node.name = name;
        node.mesh = mesh;
        if (quantised()) {
            const QuantisedBox box(parts);
            node.translation = {box.low.x, box.low.y, box.low.z};
            node.scale = {box.step, box.step, box.step};
        }
        if (!m_gltf.skins.empty() && skinned) node.skin = 0;
        m_gltf.nodes.push_back(node);
        return static_cast<int>(m_gltf.nodes.size()) - 1;
    }

    /// `channels` are of the parts, from the `first` one on, or empty.
    int addMesh(const std::string& name, const Meshes& parts, const std::vector<VertexChannels>& channels, std::size_t first = 0) {
        tinygltf::Mesh mesh;
        mesh.name = name;
        const QuantisedBox box(parts);
        for (std::size_t i = 0; i < parts.size(); ++i)
            mesh.primitives.push_back(makePrimitive(parts[i], quantised() ? &box : nullptr, channels.empty() ? nullptr : &channels[first + i]));
        m_gltf.meshes.push_back(mesh);
        return static_cast<int>(m_gltf.meshes.size()) - 1;
    }

    /// Quantised in the box, or whole without one.
    tinygltf::Primitive makePrimitive(const std::shared_ptr<const CMesh>& mesh, const QuantisedBox* box, const VertexChannels* channels) {
        const std::size_t count = mesh->vertexCount();
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.material = static_cast<int>(m_source.materialIndex(*mesh));
        auto& attributes = primitive.attributes;
        if (box)
            addQuantised(mesh, *box, attributes);
        else
            addWhole(mesh, attributes);
        for (std::size_t c = 0; channels && c < channels->size(); ++c) attributes[(*channels)[c].name] = addChannel((*channels)[c], count);
        primitive.indices = packed() ? addPackedIndices(*mesh) : addIndices(mesh);
        return primitive;
    }

    using Attributes = std::map<std::string, int>;

    void addWhole(const std::shared_ptr<const CMesh>& mesh, Attributes& attributes) {
        const std::size_t count = mesh->vertexCount();
        attributes["POSITION"] = addVertices<glm::vec3>(count, TINYGLTF_TYPE_VEC3,
                                                        [mesh](std::size_t v) { return yUp(mesh->positions[v]); });
        const Bounds bounds = mesh->bounds();
        tinygltf::Accessor& position = m_gltf.accessors.back();
        const glm::vec3 a = yUp(bounds.min), b = yUp(bounds.max), low = glm::min(a, b), high = glm::max(a, b);
        position.minValues = {low.x, low.y, low.z};
        position.maxValues = {high.x, high.y, high.z};
        attributes["NORMAL"] =
            addVertices<glm::vec3>(count, TINYGLTF_TYPE_VEC3, [mesh](std::size_t v) { return yUp(mesh->normals[v]); });
        attributes["TANGENT"] = addTangents(mesh);
        attributes["TEXCOORD_0"] = addTexCoords(mesh);
    }

    int addTexCoords(const std::shared_ptr<const CMesh>& mesh) {
        return addVertices<glm::vec2>(mesh->vertexCount(), TINYGLTF_TYPE_VEC2,
                                      [mesh](std::size_t v) { return glm::vec2(mesh->texCoords[v].x, 1 - mesh->texCoords[v].y); });
    }

    /// KHR_mesh_quantization: 20 bytes a vertex instead of 48, 24 where bark repeats.
    void addQuantised(const std::shared_ptr<const CMesh>& mesh, const QuantisedBox& box, Attributes& attributes) {
        const std::size_t count = mesh->vertexCount();
        attributes["POSITION"] = addStrided(count, kPositionStride, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, false,
                                            [mesh, box] { return quantisedPositions(*mesh, box); });
        const Bounds bounds = mesh->bounds();
        const glm::u16vec3 a = box.of(yUp(bounds.min)), b = box.of(yUp(bounds.max)), low = glm::min(a, b), high = glm::max(a, b);
        m_gltf.accessors.back().minValues = {double(low.x), double(low.y), double(low.z)};
        m_gltf.accessors.back().maxValues = {double(high.x), double(high.y), double(high.z)};
        attributes["NORMAL"] = addStrided(count, kDirectionStride, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_BYTE, true,
                                          [mesh] { return quantisedNormals(*mesh); });
        attributes["TANGENT"] = addStrided(count, kDirectionStride, TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_BYTE, true,
                                           [mesh] { return quantisedTangents(*mesh); });
        if (hasUnitTexCoords(*mesh))
            attributes["TEXCOORD_0"] = addStrided(count, kTexCoordStride, TINYGLTF_TYPE_VEC2, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, true,
                                                  [mesh] { return quantisedTexCoords(*mesh); });
        else
            attributes["TEXCOORD_0"] = addTexCoords(mesh);
    }

    int addStrided(std::size_t count, std::size_t stride, int type, int component, bool normalised, const Part& part) {
        const int view = addVertexView(count, stride, part);
        m_gltf.bufferViews[static_cast<std::size_t>(view)].byteStride = stride;
        const int accessor = addAccessor(view, count, type, component);
        m_gltf.accessors.back().normalized = normalised;
        return accessor;
    }

    int addVertexView(std::size_t count, std::size_t stride, const Part& part) {
        if (packed()) return addPackedView(count, stride, TINYGLTF_TARGET_ARRAY_BUFFER, "ATTRIBUTES", packedVertices(part(), stride));
        return addView(count * stride, TINYGLTF_TARGET_ARRAY_BUFFER, part);
    }

    /// How many bytes it takes is known when it is packed: it is kept until it is written.
    int addPackedView(std::size_t count, std::size_t stride, int target, const char* mode, const std::string& bytes) {
        const auto kept = std::make_shared<const std::string>(bytes);
        const int index = addView(kept->size(), target, [kept] { return *kept; });
        tinygltf::BufferView& view = m_gltf.bufferViews[static_cast<std::size_t>(index)];
        m_packedViews[static_cast<std::size_t>(index)] = {{"buffer", 0},          {"byteOffset", view.byteOffset}, {"byteLength", kept->size()},
                                                          {"byteStride", stride}, {"count", count},                {"mode", mode}};
        view.buffer = 1;
        view.byteOffset = m_unpackedBytes;
        view.byteLength = count * stride;
        if (target == TINYGLTF_TARGET_ARRAY_BUFFER) view.byteStride = stride;
        m_unpackedBytes += (count * stride + 3) / 4 * 4;
        return index;
    }

    int addPackedIndices(const CMesh& mesh) {
        const bool isShort = mesh.vertexCount() <= kMostShort;
        const int view = addPackedView(mesh.indices.size(), isShort ? sizeof(std::uint16_t) : sizeof(std::uint32_t),
                                       TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, "TRIANGLES", packedIndices(mesh.indices, mesh.vertexCount()));
        return addAccessor(view, mesh.indices.size(), TINYGLTF_TYPE_SCALAR,
                           isShort ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    }

    int addChannel(const VertexChannel& channel, std::size_t count) {
        constexpr int kComponents[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
        constexpr int kTypes[] = {TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4};
        const int view = addVertexView(count, channel.bytes.size() / std::max<std::size_t>(1, count), [bytes = &channel.bytes] { return *bytes; });
        const int accessor = addAccessor(view, count, kTypes[channel.components - 1], kComponents[static_cast<std::size_t>(channel.type)]);
        m_gltf.accessors.back().normalized = channel.type == VertexChannel::Type::Byte;
        return accessor;
    }

    /// Of a few values, which are kept until they are written.
    template <typename Value>
    int addNumbers(const std::vector<Value>& values, int type) {
        const std::size_t bytes = values.size() * sizeof(Value);
        const int view = addView(bytes, 0, [values, bytes] { return std::string(reinterpret_cast<const char*>(values.data()), bytes); });
        return addAccessor(view, values.size(), type, TINYGLTF_COMPONENT_TYPE_FLOAT);
    }

    int addTangents(const std::shared_ptr<const CMesh>& mesh) {
        const int view = addView(mesh->vertexCount() * sizeof(glm::vec4), TINYGLTF_TARGET_ARRAY_BUFFER, [mesh] {
            std::vector<glm::vec4> tangents = tangentsOf(*mesh);
            for (glm::vec4& t : tangents) t = glm::vec4(yUp(glm::vec3(t)), t.w);
            return std::string(reinterpret_cast<const char*>(tangents.data()), tangents.size() * sizeof(glm::vec4));
        });
        return addAccessor(view, mesh->vertexCount(), TINYGLTF_TYPE_VEC4, TINYGLTF_COMPONENT_TYPE_FLOAT);
    }

    int addIndices(const std::shared_ptr<const CMesh>& mesh) {
        if (mesh->vertexCount() <= kMostShort) return addShortIndices(mesh);
        const std::size_t bytes = mesh->indices.size() * sizeof(std::uint32_t);
        const int view = addView(bytes, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, [mesh, bytes] {
            return std::string(reinterpret_cast<const char*>(mesh->indices.data()), bytes);
        });
        return addAccessor(view, mesh->indices.size(), TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    }

    int addShortIndices(const std::shared_ptr<const CMesh>& mesh) {
        const int view = addView(mesh->indices.size() * sizeof(std::uint16_t), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, [mesh] {
            const std::vector<std::uint16_t> indices(mesh->indices.begin(), mesh->indices.end());
            return std::string(reinterpret_cast<const char*>(indices.data()), indices.size() * sizeof(std::uint16_t));
        });
        return addAccessor(view, mesh->indices.size(), TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
    }

    template <typename T, typename Get>
    int addVertices(std::size_t count, int type, Get&& get, int component = TINYGLTF_COMPONENT_TYPE_FLOAT) {
        const int view = addVertexView(count, sizeof(T), [count, get] {
            std::string bytes(count * sizeof(T), '\0');
            for (std::size_t v = 0; v < count; ++v) {
                const T value = get(v);
                std::memcpy(bytes.data() + v * sizeof(T), &value, sizeof(T));
            }
            return bytes;
        });
        return addAccessor(view, count, type, component);
    }

    int addAccessor(int view, std::size_t count, int type, int component) {
        tinygltf::Accessor accessor;
        accessor.bufferView = view;
        accessor.count = count;
        accessor.type = type;
        accessor.componentType = component;
        m_gltf.accessors.push_back(accessor);
        return static_cast<int>(m_gltf.accessors.size()) - 1;
    }

    int addView(std::size_t bytes, int target, Part part) {
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = m_bytes;
        view.byteLength = bytes;
        view.target = target;
        m_gltf.bufferViews.push_back(view);
        m_parts.push_back(std::move(part));
        m_bytes += (bytes + 3) / 4 * 4;
        return static_cast<int>(m_gltf.bufferViews.size()) - 1;
    }

    const ExportModel& m_source;
    bool m_embed;
    tinygltf::Model m_gltf;
    std::vector<Part> m_parts;
    std::uint64_t m_bytes = 0;
    std::uint64_t m_unpackedBytes = 0; ///< of what is packed
    std::map<std::size_t, nlohmann::ordered_json> m_packedViews; ///< how, by their place
};

bool embedsPictures(const ExportModel& model) { return std::ranges::any_of(model.materials, [](const Material& material) { return material.texture.empty(); }); }

void writeWord(std::ostream& out, std::uint32_t word) { out.write(reinterpret_cast<const char*>(&word), sizeof(word)); }
} // namespace

void writeGlb(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    const CGltf gltf(model, embedsPictures(model));
    std::string json = gltf.json({});
    json.append((4 - json.size() % 4) % 4, ' ');
    const bool buffered = gltf.bufferBytes() > 0;
    const std::uint64_t length = 12 + 8 + json.size() + (buffered ? 8 + gltf.bufferBytes() : 0);
    if (length > kLargestFile) throw CError(path.string() + ": the model is too large for a .glb, .gltf may take it");
    std::ostream& out = files.create(path);
    for (const std::uint32_t word : {0x46546C67u, 2u, static_cast<std::uint32_t>(length)}) writeWord(out, word);
    for (const std::uint32_t word : {static_cast<std::uint32_t>(json.size()), 0x4E4F534Au}) writeWord(out, word);
    out << json;
    if (!buffered) return;
    for (const std::uint32_t word : {static_cast<std::uint32_t>(gltf.bufferBytes()), 0x004E4942u}) writeWord(out, word);
    gltf.writeBuffer(out);
}

void writeGltf(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    const CGltf gltf(model, embedsPictures(model));
    const std::string buffer = model.name + ".bin";
    files.create(path) << gltf.json(buffer);
    if (gltf.bufferBytes() > 0) gltf.writeBuffer(files.create(path.parent_path() / buffer));
}

} // namespace stromar
