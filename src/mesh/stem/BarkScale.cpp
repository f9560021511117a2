#include "stem/BarkScale.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {

/// Of a segment whose radius changes other than evenly: parts looked at, how often each is halved, and what then passes for even.
constexpr int kParts = 4, kMostHalvings = 4;
constexpr double kEven = 0.01;

} // namespace

void CBarkScale::start(const CGeneration& generation, const CStem& stem, const CPath& path, const BarkJoint* joint, double until) {
    m_offset = glm::dvec2(0);
    m_bark = m_surface.barkOf(stem);
    m_pieces.clear();
    m_finest = stem.radius > 0 ? std::clamp(m_surface.minRadius() / stem.radius, kFinest, 1.0) : 1;
    std::vector<const CPath*> upwards{&path};
    while (upwards.back()->source >= 0)
        upwards.push_back(&generation.paths[stem.firstPath + static_cast<std::uint32_t>(upwards.back()->source)]);
    for (std::size_t i = upwards.size(); i-- > 0;)
        add(stem, generation.segmentsOf(*upwards[i]),
            i > 0 ? generation.segmentsOf(*upwards[i - 1]).front().start : until);
    if (!joint) return;
    m_joint = *joint;
    m_perMetre = perMetreAt(joint->until);
    m_offset = {joint->at.x - m_bark.around * joint->turn, alongLimb(joint->until) - ownAt(joint->until)};
}

double CBarkScale::perMetreAt(double along) const {
    const double step = 1e-3 * m_pieces.back().length;
    return (ownAt(along + step) - ownAt(along - step)) / (2 * step);
}

/// What it advances by goes over evenly.
double CBarkScale::alongLimb(double along) const {
    const double up = along - m_joint.from, whole = m_joint.until - m_joint.from;
    return m_joint.at.y + up * (m_joint.perMetre + (m_perMetre - m_joint.perMetre) * up / (2 * whole));
}

glm::dvec2 CBarkScale::onLimb(double turns, double along) const {
    const double share = (along - m_joint.from) / (m_joint.until - m_joint.from);
    return {m_joint.at.x + (turns - m_joint.turn) * (m_joint.around + share * (m_bark.around - m_joint.around)), alongLimb(along)};
}

void CBarkScale::add(const CStem& stem, std::span<const CSegment> segments, double until) {
    const double base = m_surface.growthOf(stem) * std::max(m_surface.minRadius(), stem.radius);
    const bool uneven = base > 0 && m_surface.uneven(stem);
    for (const CSegment& segment : segments) {
        if (segment.start >= until) return;
        const auto scaleAt = [&](double t) { return base > 0 ? m_surface.woodRadius(stem, segment, t) / base : 1; };
        const int parts = uneven ? kParts : 1;
        for (int i = 0; i < parts; ++i) {
            const double from = static_cast<double>(i) / parts, to = static_cast<double>(i + 1) / parts;
            addEven({from, to, scaleAt(from), scaleAt(to)}, segment, scaleAt, uneven ? kMostHalvings : 0);
        }
    }
}

template <class Scale>
void CBarkScale::addEven(const Part& part, const CSegment& segment, const Scale& scaleAt, int halvings) {
    if (halvings > 0) {
        const double middle = (part.from + part.to) / 2, scale = scaleAt(middle);
        if (std::abs(scale - (part.low + part.high) / 2) > kEven * std::max(scale, m_finest)) {
            addEven({part.from, middle, part.low, scale}, segment, scaleAt, halvings - 1);
            addEven({middle, part.to, scale, part.high}, segment, scaleAt, halvings - 1);
            return;
        }
    }
    const Piece* below = m_pieces.empty() ? nullptr : &m_pieces.back();
    const double repeats = below ? below->repeats + m_bark.perMetre * within(*below, 1) : 0;
    m_pieces.push_back({segment.start + part.from * segment.length, (part.to - part.from) * segment.length, repeats, part.low, part.high});
}

double CBarkScale::ownAt(double along) const {
    if (m_pieces.empty()) return m_bark.perMetre * along;
    const auto above = std::ranges::upper_bound(m_pieces, along, {}, &Piece::start);
    const Piece& piece = above == m_pieces.begin() ? *above : *(above - 1);
    return piece.repeats + m_bark.perMetre * within(piece, (along - piece.start) / piece.length);
}

/// The integral of the inverse of the radius, which runs evenly from end to end but where it is least.
double CBarkScale::within(const Piece& piece, double part) const {
    const double change = piece.high - piece.low, high = piece.low + part * change;
    const auto integral = [&](double from, double to) { // over a part where it is more
        const double low = piece.low + from * change, ratio = (piece.low + to * change) / low;
        return (to - from) / low * (std::abs(ratio - 1) < 1e-6 ? 1 : std::log(ratio) / (ratio - 1));
    };
    if (piece.low >= m_finest && high >= m_finest) return piece.length * integral(0, part);
    if (piece.low < m_finest && high < m_finest) return piece.length * part / m_finest;
    const double crossing = (m_finest - piece.low) / change;
    return piece.length * (piece.low < m_finest ? crossing / m_finest + integral(crossing, part)
                                               : integral(0, crossing) + (part - crossing) / m_finest);
}

} // namespace stromar
