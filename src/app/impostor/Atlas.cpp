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

/// Spread over what the grid is for: half of it evenly by height, hardly ever from right above.
glm::dvec3 directionTo(int i, int count, bool whole) {
    constexpr double kGolden = 2.399963, kHighest = 1.35;
    const double z = whole ? (2 * i + 1.0) / count - 1 : std::sin(kHighest * i / count), across = std::sqrt(1 - z * z);
    return {across * std::cos(kGolden * i), across * std::sin(kGolden * i), z};
}

/// A number for each view, row by row.
using PerView = std::array<double, ImpostorAtlas::kAcross * ImpostorAtlas::kAcross>;

/// How much of a tree is seen from all around, and what mixed views show there: three in one blur, crowns grow, thin stems fade.
class CCoverage {
public:
    CCoverage(const CImpostorCamera& camera, const ImpostorAtlas& atlas, bool whole, const CProgress& progress) : m_progress(progress) {
        for (int i = 0; i < kDirections; ++i)
            m_seen[static_cast<std::size_t>(i)].frame = {ImpostorView::from(directionTo(i, kDirections, whole)), atlas.centre, glm::dvec2(atlas.radius), atlas.radius};
        forEach([&](Seen& seen) {
            const ImpostorPicture tree = camera.draw(seen.frame, atlas.frame, atlas.frame);
            const auto covered = std::ranges::count_if(tree.albedo, [](const auto& pixel) { return pixel[3] > 255 * kAlphaCut; });
            seen.covered = double(covered) / (kStep * kStep);
        });
        for (const auto& pixel : atlas.picture.albedo) m_opacities.push_back(pixel[3]);
    }

    /// Lets the opacities of some views fall, so that what is mixed of them covers as much as the tree from everywhere, and finds where to cut.
    void even(ImpostorAtlas& atlas) {
        constexpr int kRounds = 3;
        PerView shares;
        shares.fill(1);
        mix(atlas);
        for (int round = 0; round < kRounds; ++round) {
            atlas.alphaCut = bestCut();
            correct(shares, atlas);
            setOpacities(atlas, shares);
            mix(atlas);
        }
        atlas.alphaCut = bestCut();
    }

private:
    static constexpr int kDirections = 120, kStep = 2; ///< pixels: every other tells enough of what is mixed
    static constexpr int kBins = 1000;                 ///< of opacities
    static constexpr double kMinCut = 0.15, kMaxCut = 0.75;

    struct Seen {
        ImpostorFrame frame;
        double covered = 0;             ///< by the tree, of the pixels that are looked at
        std::vector<std::size_t> mixed; ///< how often an opacity is there
    };

    template <typename Work> void forEach(Work&& work) {
        parallelFor(
            m_seen.size(), 1,
            [&](std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i) work(m_seen[i]);
            },
            m_progress);
    }

    void mix(const ImpostorAtlas& atlas) {
        forEach([&](Seen& seen) {
            seen.mixed.assign(kBins + 1, 0);
            const ImpostorView& view = seen.frame.view;
            for (int y = 0; y < atlas.frame; y += kStep)
                for (int x = 0; x < atlas.frame; x += kStep) {
                    const glm::dvec2 place = 2.0 * (glm::dvec2(x, y) + kStep / 2.0) / double(atlas.frame) - 1.0;
                    const glm::dvec3 origin = place.x * view.right - place.y * view.up + 2.0 * view.towards;
                    ++seen.mixed[static_cast<std::size_t>(sampleAlong(atlas, origin, -view.towards).cover * kBins)];
                }
        });
    }

    /// Where from nowhere they cover much more or less than the tree.
    double bestCut() const {
        std::array<double, kDirections> mixed{};
        double best = kAlphaCut, least = 1e9;
        for (int bin = kBins; bin >= kMinCut * kBins; --bin) {
            double error = 0;
            for (std::size_t i = 0; i < m_seen.size(); ++i) {
                mixed[i] += double(m_seen[i].mixed[static_cast<std::size_t>(bin)]);
                error = std::max(error, std::abs(mixed[i] - m_seen[i].covered) / std::max(1.0, m_seen[i].covered));
            }
            if (bin <= kMaxCut * kBins && error < least) least = error, best = double(bin) / kBins;
        }
        return best;
    }

    /// Where one direction covers as much as the tree.
    static double cutOf(const Seen& seen) {
        double mixed = 0;
        for (int bin = kBins; bin > 0; --bin)
            if (mixed += double(seen.mixed[static_cast<std::size_t>(bin)]); mixed >= seen.covered) return double(bin) / kBins;
        return 1.0 / kBins;
    }

    /// A view's is the mean of what the directions want that show it.
    void correct(PerView& shares, const ImpostorAtlas& atlas) const {
        constexpr double kMaxChange = 2, kMinShare = 0.55;
        PerView sums{}, weights{};
        for (const Seen& seen : m_seen) {
            const double wanted = std::log(std::clamp(atlas.alphaCut / cutOf(seen), 1 / kMaxChange, kMaxChange));
            for (const CImpostorGrid::Share& share : atlas.grid.around(seen.frame.view.towards)) {
                const auto view = static_cast<std::size_t>(share.row * ImpostorAtlas::kAcross + share.column);
                sums[view] += share.weight * wanted;
                weights[view] += share.weight;
            }
        }
        for (std::size_t view = 0; view < shares.size(); ++view)
            if (weights[view] > 0) shares[view] *= std::exp(sums[view] / weights[view]);
        const double max = std::ranges::max(shares);
        for (double& share : shares) share = std::max(kMinShare, share / max);
    }

    void setOpacities(ImpostorAtlas& atlas, const PerView& shares) const {
        const auto side = static_cast<std::size_t>(atlas.picture.width), frame = static_cast<std::size_t>(atlas.frame);
        for (std::size_t i = 0; i < m_opacities.size(); ++i) {
            const double share = shares[i / side / frame * ImpostorAtlas::kAcross + i % side / frame];
            atlas.picture.albedo[i][3] = static_cast<std::uint8_t>(std::lround(share * m_opacities[i]));
        }
    }

    const CProgress& m_progress;
    std::array<Seen, kDirections> m_seen;
    std::vector<std::uint8_t> m_opacities; ///< as they were drawn
};
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
    CCoverage(camera, atlas, whole, progress).even(atlas);
    return atlas;
}

} // namespace stromar
