#include "wind/WindExport.h"
#include "wind/PathTable.h"
#include "wind/PivotPainter.h"
#include "wind/PutBytes.h"
#include "wind/Skeleton.h"
#include "stromar/mesh/Shading.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace stromar {

namespace {
constexpr float kPhaseTurn = static_cast<float>(2 * std::numbers::pi);

/// What a vertex of a swaying model is.
struct SwayVertex {
    SwayPlace place;
    float phase;       ///< 0..1, of its leaf or its stem
    float flutter;     ///< 0 wood and the foot of a leaf … 1 a leaf's tip
    std::uint8_t open; ///< 255: no occlusion
};

/// What channels are filled from.
struct Sources {
    CPathTable paths;
    CPivotPainter pivots;
    CSkeleton skeleton;
};

/// Fills a channel from every vertex.
using PutVertex = void (*)(std::string& bytes, const SwayVertex& vertex, const Sources& from);
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
     [](std::string& bytes, const SwayVertex& v, const Sources& from) {
         put(bytes, glm::vec2(static_cast<float>(from.paths.rowAt(v.place)), from.paths.alongAt(v.place)));
     }},
    {"_WIND", VertexChannel::Type::Float, 4, [](std::string& bytes, const SwayVertex& v, const Sources& from) {
         const auto bend = from.paths.bendAt(v.place);
         put(bytes, glm::vec4(bend.below, bend.own, v.phase, v.flutter));
     }}};
// Crytek, GPU Gems 3 chapter 16.
constexpr ChannelRow kCryEngine[] = {
    {"COLOR_0", VertexChannel::Type::Byte, 4, [](std::string& bytes, const SwayVertex& v, const Sources& from) {
         const auto bend = from.paths.bendAt(v.place);
         for (const std::uint8_t byte : {byteOf(v.flutter), byteOf(v.phase), byteOf(bend.branches), v.open})
             put(bytes, byte);
     }}};
// Unity's TerrainEngine.cginc: animParams = float4(color.xy, texcoord1.xy).
constexpr ChannelRow kUnity[] = {
    {"COLOR_0", VertexChannel::Type::Byte, 4,
     [](std::string& bytes, const SwayVertex& v, const Sources& from) {
         for (const std::uint8_t byte :
              {byteOf(stemPhase(from.paths.stemAt(v.place))), byteOf(v.flutter), std::uint8_t{0}, v.open})
             put(bytes, byte);
     }},
    {"TEXCOORD_1", VertexChannel::Type::Float, 2, [](std::string& bytes, const SwayVertex& v, const Sources& from) {
         const auto bend = from.paths.bendAt(v.place);
         put(bytes, glm::vec2(bend.trunk, bend.branches));
     }}};

constexpr ChannelRow kPivotPainter[] = {
    {"TEXCOORD_1", VertexChannel::Type::Float, 2, [](std::string& bytes, const SwayVertex& v, const Sources& from) {
         put(bytes, from.pivots.texelOf(from.paths.stemNumberAt(v.place)));
     }}};
constexpr ChannelRow kBones[] = {
    {"JOINTS_0", VertexChannel::Type::Short, 4,
     [](std::string& bytes, const SwayVertex& v, const Sources& from) {
         const int joint = from.skeleton.jointOf(from.paths.stemNumberAt(v.place), v.place);
         put(bytes, std::array<std::uint16_t, 4>{static_cast<std::uint16_t>(joint), 0, 0, 0});
     }},
    {"WEIGHTS_0", VertexChannel::Type::Byte, 4, [](std::string& bytes, const SwayVertex&, const Sources&) {
         put(bytes, std::array<std::uint8_t, 4>{255, 0, 0, 0});
     }}};

/// By ExportedWind.
constexpr std::span<const ChannelRow> kChannels[] = {{}, kAttributes, kCryEngine, kUnity, kPivotPainter, kBones};

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

std::vector<VertexChannels> channelsFor(const ModelSway& sway, const Meshes& meshes, const Sources& from,
                                        std::span<const ChannelRow> rows) {
    std::vector<VertexChannels> all(meshes.size());
    for (VertexChannels& own : all)
        for (const ChannelRow& row : rows) own.push_back({row.name, row.type, row.components, {}});
    forEachVertex(sway, meshes, from.paths, [&](std::size_t mesh, const SwayVertex& vertex) {
        for (std::size_t c = 0; c < rows.size(); ++c) rows[c].put(all[mesh][c].bytes, vertex, from);
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
    const Sources from{CPathTable(table), CPivotPainter(table),
                       CSkeleton(table, static_cast<std::size_t>(options.bones), fall ? &*fall : nullptr)};
    const auto rows = kChannels[static_cast<std::size_t>(options.wind)];
    model.channels = channelsFor(*sways[0], model.meshes, from, rows);
    for (std::size_t lod = 0; lod < model.coarser.size(); ++lod)
        model.coarserChannels.push_back(channelsFor(*sways[lod + 1], model.coarser[lod], from, rows));
    if (wind == ExportedWind::Attributes)
        model.tables = {from.paths.stemTable(arrangement), from.paths.nodeTable(arrangement)};
    if (wind != ExportedWind::Bones) return;
    model.joints = from.skeleton.joints(arrangement);
    model.clips = {from.skeleton.wind(motion, arrangement), from.skeleton.growth()};
    if (fall && fall->anythingFalls()) model.clips.push_back(from.skeleton.fall(motion.fps, arrangement));
}

void addWindPictures(const ModelSway& sway, const ExportOptions& options, const Arrangement& arrangement,
                     const std::filesystem::path& beside, CFileSet& files) {
    if (options.wind == static_cast<int>(ExportedWind::PivotPainter))
        CPivotPainter(*sway.table).write(arrangement, beside, files);
}

} // namespace stromar
