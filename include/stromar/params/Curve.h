#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stromar {

/// A value over a quantity: straight lines between control points, constant outside them.
class CCurve {
public:
    struct Point {
        double x, y;
        bool operator==(const Point&) const = default;
    };
    /// What is wrong with a text, and where in it the point begins that is.
    struct Fault {
        std::string text;
        std::size_t at;
    };

    static constexpr std::size_t kMaxPoints = 64;

    /// 0 everywhere.
    CCurve() : m_points{{0, 0}} {}
    /// At least one point, x rising.
    explicit CCurve(std::vector<Point> points);

    /// Reads "0:50, 3:40": control points x:y with rising x. Nothing, and `fault`, when the text is wrong.
    static std::optional<CCurve> parse(std::string_view text, Fault& fault);
    /// As parse() reads it: the same numbers to the last bit.
    std::string text() const;

    double at(double x) const;
    const std::vector<Point>& points() const { return m_points; }
    bool operator==(const CCurve&) const = default;

private:
    std::vector<Point> m_points;
};

} // namespace stromar
