#include "WindExport.h"
#include "stromar/mesh/Shading.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>

namespace stromar {

namespace {
constexpr double kSlender = 60;       // length over diameter of the softest stems
constexpr double kClipSeconds = 5;    // of the wind, where nothing else was asked for
constexpr double kClipStrength = 0.5; // likewise
constexpr double kGrowthSeconds = 10;
constexpr int kGrowthKeys = 60;
constexpr float kSeed = 1e-3f; // the scale of what is not yet there
constexpr float kPhaseTurn = static_cast<float>(2 * std::numbers::pi);

/// Axes of a format whose writer has y up.
glm::vec3 yUp(const glm::vec3& v) { return {v.x, v.z, -v.y}; }

template <typename Value>
void put(std::string& bytes, const Value& value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof(Value));
    std::memcpy(bytes.data() + at, &value, sizeof(Value));
}

/// One path of a stem in the table that leaves the program.
struct PathRow {
    std::uint32_t stem;  ///< in the wind's table
    std::int32_t parent; ///< the row it grows out of; of a clone, the one it splits from
    float along;         ///< metres from that stem's base
    std::uint32_t firstNode, nodes;
    float start;       ///< metres of the first node from the base of its stem
    std::uint32_t own; ///< row of the stem's path 0
};

/// The wind's table path by path, with what shaders ask of places on it.
class CPathTable {
public:
    explicit CPathTable(const CWindTable& table)
        : m_table(table), m_rowOfNode(table.nodeCount()), m_along(table.nodeCount()) {
        for (std::uint32_t s = 0; s < table.stems().size(); ++s) addStem(s);
        for (const WindStem& stem : table.stems()) addBend(stem);
    }

    const std::vector<PathRow>& rows() const { return m_rows; }
    float alongOf(std::size_t node) const { return m_along[node]; }
    float alongAt(const SwayPlace& place) const {
        return glm::mix(m_along[place.index()], m_along[place.index() + 1], place.part);
    }
    std::uint32_t rowAt(const SwayPlace& place) const { return m_rowOfNode[place.index()]; }
    const WindStem& stemAt(const SwayPlace& place) const { return m_table.stems()[m_rows[rowAt(place)].stem]; }

    /// How far the wood bends there, 0 not at all.
    struct Bend {
        float trunk;    ///< with the trunk
        float below;    ///< with all stems below
        float own;      ///< with its own stem
        float branches; ///< with all stems but the trunk
    };
    Bend bendAt(const SwayPlace& place) const {
        const std::uint32_t index = m_rows[rowAt(place)].stem;
        const WindStem& stem = m_table.stems()[index];
        const float own = ownBend(stem, alongAt(place));
        const Bend& base = m_bends[index];
        if (stem.parent < 0) return {own, 0, own, 0};
        return {base.trunk, base.below, own, 1 - (1 - base.branches) * (1 - own)};
    }

private:
    void addStem(std::uint32_t index) {
        const WindStem& stem = m_table.stems()[index];
        const CGeneration& all = m_table.tree().generation(stem.generation);
        const CStem& own = all.stems[stem.stem];
        const auto first = static_cast<std::uint32_t>(m_rows.size());
        for (std::uint32_t p = 0; p < own.pathCount; ++p) {
            const CPath& path = all.paths[own.firstPath + p];
            PathRow row{index,
                        -1,
                        0,
                        m_table.nodeOf(stem.generation, path.firstSegment),
                        path.segmentCount + 1,
                        static_cast<float>(all.segments[path.firstSegment].start),
                        first};
            if (path.source >= 0) {
                row.parent = static_cast<std::int32_t>(first) + path.source;
                row.along = row.start;
            } else if (stem.parent >= 0) {
                row.parent = static_cast<std::int32_t>(m_rowOfNode[stem.parentNode]);
                row.along = alongAt(stem.on());
            }
            float along = row.start;
            for (std::uint32_t n = 0; n < row.nodes; ++n) {
                m_rowOfNode[row.firstNode + n] = static_cast<std::uint32_t>(m_rows.size());
                m_along[row.firstNode + n] = along;
                if (n + 1 < row.nodes) along += static_cast<float>(all.segments[path.firstSegment + n].length);
            }
            m_rows.push_back(row);
        }
    }

    static float ownBend(const WindStem& stem, float along) {
        const double slender = stem.diameter > 0 ? std::min(1.0, stem.length / stem.diameter / kSlender) : 1;
        return static_cast<float>(slender * std::clamp(along / stem.length, 0.0, 1.0));
    }

    void addBend(const WindStem& stem) {
        if (stem.parent < 0) {
            m_bends.push_back({});
            return;
        }
        const Bend at = bendAt(stem.on());
        m_bends.push_back({at.trunk, 1 - (1 - at.below) * (1 - at.own), 0, at.branches});
    }

    const CWindTable& m_table;
    std::vector<PathRow> m_rows;
    std::vector<std::uint32_t> m_rowOfNode;
    std::vector<float> m_along; ///< by node
    std::vector<Bend> m_bends;  ///< by stem, at its base
};

/// What a vertex of a swaying model is.
struct SwayVertex {
    SwayPlace place;
    float phase;       ///< 0..1, of its leaf or its stem
    float flutter;     ///< 0 wood and the foot of a leaf … 1 a leaf's tip
    std::uint8_t open; ///< 255: no occlusion
};

/// Fills a channel from every vertex.
using PutVertex = void (*)(std::string& bytes, const SwayVertex& vertex, const CPathTable& paths);
struct ChannelRow {
    const char* name;
    VertexChannel::Type type;
    int components;
    PutVertex put;
};

std::uint8_t byteOf(float share) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.f, 1.f))); }
float stemPhase(const WindStem& stem) { return static_cast<float>(stem.phase) / kPhaseTurn; }

constexpr ChannelRow kAttributes[] = {
    {"_STEM", VertexChannel::Type::Float, 2,
     [](std::string& bytes, const SwayVertex& v, const CPathTable& paths) {
         put(bytes, glm::vec2(static_cast<float>(paths.rowAt(v.place)), paths.alongAt(v.place)));
     }},
    {"_WIND", VertexChannel::Type::Float, 4, [](std::string& bytes, const SwayVertex& v, const CPathTable& paths) {
         const auto bend = paths.bendAt(v.place);
         put(bytes, glm::vec4(bend.below, bend.own, v.phase, v.flutter));
     }}};
// Crytek, GPU Gems 3 chapter 16.
constexpr ChannelRow kCryEngine[] = {
    {"COLOR_0", VertexChannel::Type::Byte, 4, [](std::string& bytes, const SwayVertex& v, const CPathTable& paths) {
         const auto bend = paths.bendAt(v.place);
         for (const std::uint8_t byte : {byteOf(v.flutter), byteOf(v.phase), byteOf(bend.branches), v.open})
             put(bytes, byte);
     }}};
// Unity's TerrainEngine.cginc: animParams = float4(color.xy, texcoord1.xy).
constexpr ChannelRow kUnity[] = {
    {"COLOR_0", VertexChannel::Type::Byte, 4,
     [](std::string& bytes, const SwayVertex& v, const CPathTable& paths) {
         for (const std::uint8_t byte :
              {byteOf(stemPhase(paths.stemAt(v.place))), byteOf(v.flutter), std::uint8_t{0}, v.open})
             put(bytes, byte);
     }},
    {"TEXCOORD_1", VertexChannel::Type::Float, 2, [](std::string& bytes, const SwayVertex& v, const CPathTable& paths) {
         const auto bend = paths.bendAt(v.place);
         put(bytes, glm::vec2(bend.trunk, bend.branches));
     }}};

std::span<const ChannelRow> channelsOf(ExportedWind wind) {
    if (wind == ExportedWind::Attributes) return kAttributes;
    if (wind == ExportedWind::CryEngine) return kCryEngine;
    if (wind == ExportedWind::Unity) return kUnity;
    return {};
}

/// Calls `visit(mesh number, vertex number, SwayVertex)` for every vertex of a model's meshes, in order.
template <typename Visit>
void forEachVertex(const ModelSway& sway, const Meshes& meshes, const CPathTable& paths, Visit&& visit) {
    const Crown crown = crownOf(meshes);
    std::size_t number = 0;
    const auto tell = [&](std::size_t v, const SwayPlace& place, float phase, float flutter) {
        visit(number, SwayVertex{place, phase, flutter, ambientAt(crown, *meshes[number], v)});
    };
    sway.model->visitMeshes(
        [&](const std::shared_ptr<const CMesh>& mesh, int) {
            const SwayPlaces& places = *sway.placesOf(*mesh);
            for (std::size_t v = 0; v < places.size(); ++v) tell(v, places[v], stemPhase(paths.stemAt(places[v])), 0);
            ++number;
        },
        [&](const std::shared_ptr<const COrganMesh>& organs, int) {
            const SwayPlaces& places = *sway.placesOf(*organs);
            const auto& points = organs->blade().points;
            for (std::size_t v = 0; v < places.size() * points.size(); ++v) {
                const std::size_t i = v / points.size();
                const Flutter own = flutterOf(sway.table->tree(), organs->leaf(i));
                const auto tip = static_cast<float>(std::clamp(points[v % points.size()].place.y, 0.0, 1.0));
                tell(v, places[i], own.phase / kPhaseTurn, own.amount * tip);
            }
            ++number;
        });
}

std::vector<VertexChannels> channelsFor(const ModelSway& sway, const Meshes& meshes, std::span<const ChannelRow> rows) {
    std::vector<VertexChannels> all(meshes.size());
    for (VertexChannels& own : all)
        for (const ChannelRow& row : rows) own.push_back({row.name, row.type, row.components, {}});
    const CPathTable paths(*sway.table);
    forEachVertex(sway, meshes, paths, [&](std::size_t mesh, const SwayVertex& vertex) {
        for (std::size_t c = 0; c < rows.size(); ++c) rows[c].put(all[mesh][c].bytes, vertex, paths);
    });
    return all;
}

DataTable stemTable(const CWindTable& table, const CPathTable& paths, const Arrangement& to) {
    DataTable out{
        "stems",
        {"base.x",       "base.y",       "base.z",     "axis.x",      "axis.y",       "axis.z", "x.x",
         "x.y",          "x.z",          "y.x",        "y.y",         "y.z",          "length", "diameter",
         "flexibility",  "angularSpeed", "phase",      "seed:uint32", "parent:int32", "along",  "firstNode:uint32",
         "nodes:uint32", "start",        "stem:uint32"},
        {}};
    for (const PathRow& row : paths.rows()) {
        const WindStem& stem = table.stems()[row.stem];
        for (const glm::vec3& v : {to.point(glm::vec3(stem.base)), to.direction(glm::vec3(stem.axis)),
                                   to.direction(glm::vec3(stem.x)), to.direction(glm::vec3(stem.y))})
            put(out.bytes, yUp(v));
        for (const double number :
             {stem.length * to.scale, stem.diameter * to.scale, stem.flexibility, stem.angularSpeed, stem.phase})
            put(out.bytes, static_cast<float>(number));
        put(out.bytes, stem.seed);
        put(out.bytes, row.parent);
        put(out.bytes, row.along * to.scale);
        put(out.bytes, row.firstNode);
        put(out.bytes, row.nodes);
        put(out.bytes, row.start * to.scale);
        put(out.bytes, row.own);
    }
    return out;
}

DataTable nodeTable(const CWindTable& table, const CPathTable& paths, const Arrangement& to) {
    DataTable out{"nodes", {"x", "y", "z", "along"}, {}};
    for (std::size_t n = 0; n < table.nodeCount(); ++n) {
        put(out.bytes, yUp(to.point(table.still()[n])));
        put(out.bytes, to.scale * paths.alongOf(n));
    }
    return out;
}

/// The stems that get bones, and which bone each stem follows.
class CSkeleton {
public:
    /// With `fall`, what is above its cut hangs on a joint at the hinge.
    CSkeleton(const CWindTable& table, std::size_t count, const CFall* fall)
        : m_table(table), m_fall(fall), m_roots(fall ? 2 : 1), m_boneOf(table.stems().size(), 0) {
        const auto& stems = table.stems();
        std::vector<std::uint32_t> byThickness(stems.size());
        std::iota(byThickness.begin(), byThickness.end(), 0u);
        std::ranges::stable_sort(
            byThickness, [&](std::uint32_t a, std::uint32_t b) { return stems[a].diameter > stems[b].diameter; });
        std::vector<bool> chosen(stems.size());
        for (std::size_t i = 0; i < std::min(count, stems.size()); ++i) chosen[byThickness[i]] = true;
        for (std::uint32_t s = 0; s < stems.size(); ++s) {
            const int parent = stems[s].parent < 0 ? m_roots - 1 : m_boneOf[static_cast<std::size_t>(stems[s].parent)];
            m_boneOf[s] = stands(s) ? 0 : parent;
            if (!chosen[s] || stands(s)) continue;
            m_boneOf[s] = static_cast<int>(m_bones.size()) + m_roots;
            m_bones.push_back({s, parent});
        }
    }

    struct Bone {
        std::uint32_t stem;
        int parent; ///< joint
    };
    /// Joint 0 is the ground; the bones come last.
    int jointOf(std::uint32_t stem, const SwayPlace& place) const {
        return m_fall && !m_fall->falls(place.index()) ? 0 : m_boneOf[stem];
    }

    std::vector<Joint> joints(const Arrangement& to) const {
        std::vector<Joint> all{{"ground", -1, glm::vec3(0)}};
        if (m_fall) all.push_back({"hinge", 0, to.point(glm::vec3(m_fall->hinge()))});
        for (const Bone& bone : m_bones) {
            const WindStem& stem = m_table.stems()[bone.stem];
            all.push_back({"stem_" + std::to_string(stem.generation) + "_" + std::to_string(stem.stem), bone.parent,
                           to.point(glm::vec3(stem.base))});
        }
        return all;
    }

    Clip wind(const Motion& motion, const Arrangement& to) const {
        Wind wind = motion.wind;
        if (wind.strength == 0) wind.strength = kClipStrength;
        wind.loop = motion.frames > 0 ? motion.loopingWind().loop : motion.seconds > 0 ? motion.seconds : kClipSeconds;
        const int keys = std::max(2, static_cast<int>(std::lround(wind.loop * motion.fps)));
        Clip clip = emptyClip("wind");
        for (int k = 0; k <= keys; ++k) {
            clip.seconds.push_back(static_cast<float>(wind.loop * k / keys));
            for (std::size_t b = 0; b < m_bones.size(); ++b)
                turn(clip, b + std::size_t(m_roots),
                     m_table.pushOn(stemOf(b), wind, wind.loop * (k % keys) / keys).turn / 2.0, to);
        }
        return clip;
    }

    Clip fall(double fps, const Arrangement& to) const {
        Clip clip = emptyClip("fall");
        const int keys = std::max(2, static_cast<int>(std::lround(m_fall->seconds() * fps)));
        for (int k = 0; k <= keys; ++k) {
            const double seconds = m_fall->seconds() * k / keys;
            clip.seconds.push_back(static_cast<float>(seconds));
            turn(clip, 1, m_fall->angleAt(seconds) * m_fall->axis(), to);
            for (std::size_t b = 0; b < m_bones.size(); ++b)
                turn(clip, b + std::size_t(m_roots), m_fall->pushAt(stemOf(b), seconds).turn / 2.0, to);
        }
        return clip;
    }

    /// Each stem as large as it is by then; those that wait for their parent's tip are seeds.
    Clip growth() const {
        Clip clip{"growth", {}, {}, std::vector<std::vector<float>>(jointCount())};
        for (int k = 0; k <= kGrowthKeys; ++k) {
            const double age = double(k) / kGrowthKeys;
            clip.seconds.push_back(static_cast<float>(kGrowthSeconds * age));
            for (std::size_t b = 0; b < m_bones.size(); ++b) {
                const int parent = m_bones[b].parent;
                const float whole =
                    parent < m_roots ? 1 : maturity(m_bones[static_cast<std::size_t>(parent - m_roots)].stem, age);
                clip.scales[b + std::size_t(m_roots)].push_back(maturity(m_bones[b].stem, age) / whole);
            }
        }
        return clip;
    }

private:
    std::size_t jointCount() const { return m_bones.size() + std::size_t(m_roots); }
    const WindStem& stemOf(std::size_t bone) const { return m_table.stems()[m_bones[bone].stem]; }
    /// Whether a felling leaves it where it is.
    bool stands(std::uint32_t stem) const {
        const WindStem& own = m_table.stems()[stem];
        return m_fall && own.parent >= 0 && !m_fall->falls(own.firstNode);
    }
    Clip emptyClip(const char* name) const { return {name, {}, std::vector<std::vector<glm::vec4>>(jointCount()), {}}; }

    /// A stem's joint gets half its turn: a stiff piece in place of an arc.
    static void turn(Clip& clip, std::size_t joint, const glm::dvec3& by, const Arrangement& to) {
        const glm::vec3 axis = to.direction(glm::vec3(by));
        const float angle = glm::length(axis);
        const float part = angle > 0 ? std::sin(angle / 2) / angle : 0;
        clip.turns[joint].push_back(glm::vec4(part * axis, std::cos(angle / 2)));
    }

    /// How long a stem is by now, as a part of what it will be.
    float maturity(std::uint32_t index, double age) const {
        const WindStem& stem = m_table.stems()[index];
        const double birth = m_table.tree().generation(stem.generation).stems[stem.stem].birth;
        if (age >= 1) return 1;
        if (age <= birth) return kSeed;
        const double left = (1 - age) / (1 - birth);
        return std::max(kSeed, static_cast<float>(1 - left * left * left));
    }

    const CWindTable& m_table;
    const CFall* m_fall;
    int m_roots;               ///< joints in front of the bones
    std::vector<int> m_boneOf; ///< joint by stem
    std::vector<Bone> m_bones;
};

std::vector<VertexChannels> bonesFor(const ModelSway& sway, const Meshes& meshes, const CSkeleton& skeleton) {
    std::vector<VertexChannels> all(meshes.size());
    for (VertexChannels& own : all)
        own = {{"JOINTS_0", VertexChannel::Type::Short, 4, {}}, {"WEIGHTS_0", VertexChannel::Type::Byte, 4, {}}};
    const CPathTable paths(*sway.table);
    forEachVertex(sway, meshes, paths, [&](std::size_t mesh, const SwayVertex& vertex) {
        const auto joint =
            static_cast<std::uint16_t>(skeleton.jointOf(paths.rows()[paths.rowAt(vertex.place)].stem, vertex.place));
        for (const std::uint16_t index : {joint, std::uint16_t{0}, std::uint16_t{0}, std::uint16_t{0}})
            put(all[mesh][0].bytes, index);
        put(all[mesh][1].bytes, std::array<std::uint8_t, 4>{255, 0, 0, 0});
    });
    return all;
}
} // namespace

void addWind(ExportModel& model, std::span<const std::shared_ptr<const ModelSway>> sways, const ExportOptions& options,
             const Motion& motion, const Arrangement& arrangement) {
    const auto wind = static_cast<ExportedWind>(options.wind);
    const CWindTable& table = *sways.front()->table; // all levels of detail have the same stems
    std::optional<CFall> fall;
    if (motion.felling && wind == ExportedWind::Bones) fall.emplace(sways.front()->table, *motion.felling);
    const CSkeleton skeleton(table, static_cast<std::size_t>(options.bones), fall ? &*fall : nullptr);
    const auto channels = [&](std::size_t lod, const Meshes& meshes) {
        return wind == ExportedWind::Bones ? bonesFor(*sways[lod], meshes, skeleton)
                                           : channelsFor(*sways[lod], meshes, channelsOf(wind));
    };
    model.channels = channels(0, model.meshes);
    for (std::size_t lod = 0; lod < model.coarser.size(); ++lod)
        model.coarserChannels.push_back(channels(lod + 1, model.coarser[lod]));
    if (wind == ExportedWind::Attributes) {
        const CPathTable paths(table);
        model.tables = {stemTable(table, paths, arrangement), nodeTable(table, paths, arrangement)};
    }
    if (wind != ExportedWind::Bones) return;
    model.joints = skeleton.joints(arrangement);
    model.clips = {skeleton.wind(motion, arrangement), skeleton.growth()};
    if (fall && fall->anythingFalls()) model.clips.push_back(skeleton.fall(motion.fps, arrangement));
}

} // namespace stromar
