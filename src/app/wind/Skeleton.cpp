#include "wind/Skeleton.h"
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr double kClipSeconds = 5;    // of the wind, where nothing else was asked for
constexpr double kClipStrength = 0.5; // likewise
constexpr double kGrowthSeconds = 10;
constexpr int kGrowthKeys = 60, kMaxKeys = 6000; // of a clip
constexpr double kSeed = 1e-3;                   // the scale of what is not yet there

int keysOf(double seconds, double fps) {
    return static_cast<int>(std::clamp(std::round(seconds * fps), 2.0, double(kMaxKeys)));
}

void turn(Clip& clip, std::size_t joint, const glm::dvec3& by, const Arrangement& to) {
    const glm::vec3 axis = to.direction(glm::vec3(by));
    const float angle = glm::length(axis);
    const float part = angle > 0 ? std::sin(angle / 2) / angle : 0;
    clip.turns[joint].push_back(glm::vec4(part * axis, std::cos(angle / 2)));
}
} // namespace

CSkeleton::CSkeleton(const CWindTable& table, std::size_t count, const CFall* fall)
    : m_table(table), m_fall(fall), m_roots(fall ? 2 : 1),
      m_choice(table, count, [this](std::uint32_t stem) { return !stands(stem); }) {}

/// Whether a felling leaves it where it is.
bool CSkeleton::stands(std::uint32_t stem) const {
    const WindStem& own = m_table.stems()[stem];
    return m_fall && own.parent >= 0 && !m_fall->falls(own.firstNode);
}

int CSkeleton::jointOf(std::uint32_t stem, const SwayPlace& place) const {
    if (m_fall && (stands(stem) || !m_fall->falls(place.index()))) return 0;
    return m_choice.leaderOf(stem) + static_cast<int>(m_roots); // none: the root before them
}

std::vector<Joint> CSkeleton::joints(const Arrangement& to) const {
    std::vector<Joint> all{{"ground", -1, glm::vec3(0)}};
    if (m_fall) all.push_back({"hinge", 0, to.point(glm::vec3(m_fall->hinge()))});
    for (std::size_t b = 0; b < m_choice.leaders().size(); ++b) {
        const WindStem& stem = stemOf(b);
        all.push_back({"stem_" + std::to_string(stem.generation) + "_" + std::to_string(stem.stem),
                       m_choice.leaderBelow(b) + static_cast<int>(m_roots), to.point(glm::vec3(stem.base))});
    }
    return all;
}

Clip CSkeleton::emptyClip(const char* name) const {
    return {name, {}, std::vector<std::vector<glm::vec4>>(jointCount()), {}};
}

Clip CSkeleton::wind(const Motion& motion, const Arrangement& to) const {
    Wind wind = motion.wind;
    if (wind.strength == 0) wind.strength = kClipStrength;
    wind.loop = motion.frames > 0 ? motion.loopingWind().loop : motion.seconds > 0 ? motion.seconds : kClipSeconds;
    const int keys = keysOf(wind.loop, motion.fps);
    Clip clip = emptyClip("wind");
    for (int k = 0; k <= keys; ++k) {
        clip.seconds.push_back(static_cast<float>(wind.loop * k / keys));
        for (std::size_t b = 0; b < m_choice.leaders().size(); ++b)
            turn(clip, b + m_roots, m_table.pushOn(stemOf(b), wind, wind.loop * (k % keys) / keys).turn / 2.0, to);
    }
    return clip;
}

Clip CSkeleton::fall(double fps, const Arrangement& to) const {
    Clip clip = emptyClip("fall");
    const int keys = keysOf(m_fall->seconds(), fps);
    for (int k = 0; k <= keys; ++k) {
        const double seconds = m_fall->seconds() * k / keys;
        clip.seconds.push_back(static_cast<float>(seconds));
        turn(clip, 1, m_fall->angleAt(seconds) * m_fall->axis(), to);
        for (std::size_t b = 0; b < m_choice.leaders().size(); ++b)
            turn(clip, b + m_roots, m_fall->pushAt(stemOf(b), seconds).turn / 2.0, to);
    }
    return clip;
}

Clip CSkeleton::growth() const {
    Clip clip{"growth", {}, {}, std::vector<std::vector<float>>(jointCount())};
    for (int k = 0; k <= kGrowthKeys; ++k) {
        const double age = double(k) / kGrowthKeys;
        clip.seconds.push_back(static_cast<float>(kGrowthSeconds * age));
        for (std::size_t b = 0; b < m_choice.leaders().size(); ++b) {
            const int below = m_choice.leaderBelow(b);
            const double whole = below < 0 ? 1 : maturity(stemOf(static_cast<std::size_t>(below)), age);
            clip.scales[b + m_roots].push_back(static_cast<float>(maturity(stemOf(b), age) / whole));
        }
    }
    return clip;
}

/// How long a stem is by now, as a part of what it will be.
double CSkeleton::maturity(const WindStem& stem, double age) const {
    const double birth = m_table.tree().generation(stem.generation).stems[stem.stem].birth;
    if (age >= 1) return 1;
    if (age <= birth) return kSeed;
    const double left = (1 - age) / (1 - birth);
    return std::max(kSeed, 1 - left * left * left);
}

} // namespace stromar
