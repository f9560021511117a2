#include "stromar/tree/lsystem/Turtle.h"
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

namespace stromar {

namespace {
constexpr double kRadians = std::numbers::pi / 180;
constexpr std::size_t kPoll = 65536; // modules

/// Position and frame of the turtle; what brackets keep.
struct Turtle {
    glm::dvec3 position{0};
    glm::dvec3 heading{0, 0, 1}, left{-1, 0, 0}, up{0, -1, 0};
    double width = 1; ///< units
    std::int32_t below = -1;

    /// The first vector towards the second, the second away from the first.
    static void turn(glm::dvec3& a, glm::dvec3& b, double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        const glm::dvec3 turned = c * a + s * b;
        b = c * b - s * a;
        a = turned;
    }
    void yaw(double angle) { turn(heading, left, angle); }
    void pitchDown(double angle) { turn(heading, up, -angle); }
    void rollRight(double angle) { turn(left, up, angle); }

    /// Left lies level (ABOP §2.2).
    void level() {
        const glm::dvec3 across = glm::cross(glm::dvec3(0, 0, 1), heading);
        const double length = glm::length(across);
        if (length < 1e-12) return;
        left = across / length;
        up = glm::cross(heading, left);
    }

    /// Turned towards a direction, the more the squarer it stands to it (ABOP §2.1).
    void bend(const glm::dvec3& towards, double strength) {
        const glm::dvec3 axis = glm::cross(heading, towards);
        const double size = glm::length(axis);
        if (size < 1e-12) return;
        for (glm::dvec3* v : {&heading, &left, &up}) *v = turned(*v, axis / size, strength * size);
    }

    Frame frame() const { return {up, -left, heading}; }
};

class CTurtleWalk {
public:
    /// `shares` by module; empty: all of every one.
    CTurtleWalk(const CWord& word, const std::vector<float>& shares, const TurtleParams& params)
        : m_word(word), m_shares(shares), m_params(params) {}

    TurtlePath walk(const CProgress& progress) {
        for (std::size_t i = 0; i < m_word.size(); ++i) {
            if (i % kPoll == 0) progress.poll();
            step(i);
        }
        return std::move(m_path);
    }

private:
    void step(std::size_t i) {
        const std::span<const double> numbers = m_word.numbers(i);
        const auto first = numbers.empty() ? std::optional<double>() : numbers[0];
        const double angle = first ? *first * kRadians : m_params.turn;
        switch (const Symbol symbol = m_word.symbol(i)) {
        case 'F':
        case 'f': return go(i, symbol == 'F', share(i) * first.value_or(1) * m_params.lengthUnit);
        case '+': return m_turtle.yaw(angle);
        case '-': return m_turtle.yaw(-angle);
        case '&': return m_turtle.pitchDown(angle);
        case '^': return m_turtle.pitchDown(-angle);
        case '/': return m_turtle.rollRight(angle);
        case '\\': return m_turtle.rollRight(-angle);
        case '|': return m_turtle.yaw(std::numbers::pi);
        case '$': return m_turtle.level();
        case '!': m_turtle.width = first ? share(i) * *first : m_turtle.width; return;
        case '[': m_stack.push_back(m_turtle); return;
        case ']':
            m_turtle = m_stack.back();
            m_stack.pop_back();
            return;
        case kLeafSymbol:
        case kBlossomSymbol:
        case kFruitSymbol: return grow(i, kOrgans[symbol - kLeafSymbol], numbers.empty() ? -1 : std::max(0.0, numbers[0]) * m_params.lengthUnit);
        default: return;
        }
    }

    double share(std::size_t i) const { return m_shares.empty() ? 1 : double(m_shares[i]); }

    void go(std::size_t i, bool draws, double length) {
        if (draws) {
            m_path.segments.push_back({m_turtle.position, m_turtle.frame(), length, m_turtle.width * m_params.widthUnit,
                                       m_turtle.below, static_cast<std::uint32_t>(i),
                                       static_cast<std::uint32_t>(m_stack.size())});
            m_turtle.below = static_cast<std::int32_t>(m_path.segments.size()) - 1;
        } else
            m_turtle.below = -1;
        m_turtle.position += length * m_turtle.heading;
        if (m_params.tropismBend != 0) m_turtle.bend(m_params.tropism, share(i) * m_params.tropismBend);
    }

    void grow(std::size_t i, Organ organ, double size) {
        m_path.organs.push_back({organ, m_turtle.position, m_turtle.frame(), size, share(i), m_turtle.below});
    }

    const CWord& m_word;
    const std::vector<float>& m_shares;
    const TurtleParams& m_params;
    Turtle m_turtle;
    std::vector<Turtle> m_stack;
    TurtlePath m_path;
};
} // namespace

TurtlePath interpret(const CWord& word, const TurtleParams& params, const CProgress& progress) {
    return CTurtleWalk(word, {}, params).walk(progress);
}

TurtlePath interpret(const GrowingWord& word, const TurtleParams& params, const CProgress& progress) {
    return CTurtleWalk(word.word, word.shares, params).walk(progress);
}

} // namespace stromar
