#include "stromar/app/Impostor.h"
#include "stromar/util/Parallel.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace stromar {

namespace {
constexpr double kMargin = 1.0 / 32; // of the radius: colours of a frame do not reach the next one's, nor in the first halves

void copyInto(Pixels& atlas, int side, const Pixels& frame, int frameSide, int column, int row) {
    for (int y = 0; y < frameSide; ++y)
        std::copy_n(frame.begin() + std::ptrdiff_t(y) * frameSide, frameSide, atlas.begin() + (std::ptrdiff_t(row) * frameSide + y) * side + std::ptrdiff_t(column) * frameSide);
}

/// Spread over what the grid is for.
glm::dvec3 directionTo(int i, int count, bool whole) {
    constexpr double kGolden = 2.399963;
    const double z = whole ? (2 * i + 1.0) / count - 1 : i / double(count), across = std::sqrt(1 - z * z); // hardly ever from right above
    return {across * std::cos(kGolden * i), across * std::sin(kGolden * i), z};
}

/// Three views in one blur: crowns grow, thin stems fade. Where to cut so that from nowhere they cover much more or less than
/// the tree.
double alphaCutFor(const CImpostorCamera& camera, const ImpostorAtlas& atlas, bool whole, const CProgress& progress) {
    constexpr int kDirections = 12, kBins = 1000;
    constexpr double kLeast = 0.15, kMost = 0.75;
    struct Seen {
        double covered = 0;
        std::vector<std::size_t> mixed = std::vector<std::size_t>(kBins + 1); ///< how often an opacity is there
    };
    std::array<Seen, kDirections> seen;
    parallelFor(
        kDirections, 1,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const ImpostorFrame frame{ImpostorView::from(directionTo(static_cast<int>(i), kDirections, whole)), atlas.centre, glm::dvec2(atlas.radius), atlas.radius};
                const ImpostorPicture tree = camera.draw(frame, atlas.frame, atlas.frame);
                for (int y = 0; y < atlas.frame; ++y)
                    for (int x = 0; x < atlas.frame; ++x) {
                        const glm::dvec2 pixel(x + 0.5, y + 0.5), place = 2.0 * pixel / double(atlas.frame) - 1.0;
                        const glm::dvec3 origin = place.x * frame.view.right - place.y * frame.view.up + 2.0 * frame.view.towards;
                        seen[i].covered += sampleOf(tree, pixel).cover > kAlphaCut;
                        ++seen[i].mixed[static_cast<std::size_t>(sampleAlong(atlas, origin, -frame.view.towards).cover * kBins)];
                    }
            }
        },
        progress);
    std::array<double, kDirections> mixed{};
    double best = kAlphaCut, least = 1e9;
    for (int bin = kBins; bin >= kLeast * kBins; --bin) {
        double error = 0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            mixed[i] += double(seen[i].mixed[static_cast<std::size_t>(bin)]);
            error = std::max(error, std::abs(mixed[i] - seen[i].covered) / std::max(1.0, seen[i].covered));
        }
        if (bin <= kMost * kBins && error < least) least = error, best = double(bin) / kBins;
    }
    return best;
}
} // namespace

ImpostorAtlas drawImpostorAtlas(const CImpostorCamera& camera, bool whole, int side, const CProgress& progress) {
    const CImpostorCamera::Ball ball = camera.ball();
    constexpr int kAcross = ImpostorAtlas::kAcross;
    ImpostorAtlas atlas{CImpostorGrid(kAcross, whole), ball.centre, std::max(1e-6, (1 + kMargin) * ball.radius), side / kAcross, {side, side, {}, {}}};
    for (Pixels* pixels : {&atlas.picture.albedo, &atlas.picture.normalDepth}) pixels->resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    parallelFor(
        kAcross * kAcross, 1,
        [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const int column = static_cast<int>(i) % kAcross, row = static_cast<int>(i) / kAcross;
                const ImpostorPicture frame = camera.draw(atlas.frameAt(column, row), atlas.frame, atlas.frame);
                copyInto(atlas.picture.albedo, side, frame.albedo, atlas.frame, column, row);
                copyInto(atlas.picture.normalDepth, side, frame.normalDepth, atlas.frame, column, row);
            }
        },
        progress);
    atlas.alphaCut = alphaCutFor(camera, atlas, whole, progress);
    return atlas;
}

} // namespace stromar
