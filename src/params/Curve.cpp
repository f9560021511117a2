#include "stromar/params/Curve.h"
#include "stromar/util/Text.h"
#include "stromar/util/Translatable.h"
#include <algorithm>
#include <cassert>

namespace stromar {

namespace {
/// `wrong` names the number of the point by %1 and the text by %2.
std::string faultOf(std::string_view wrong, std::size_t index, std::string_view point) {
    return translated(wrong, index + 1, trimmed(point));
}

/// A point and what is wrong with it.
std::string readPoint(std::string_view text, std::size_t index, CCurve::Point& point) {
    const std::size_t colon = text.find(':');
    if (trimmed(text).empty()) return translated(NC_("stromar", "point %1 is empty"), index + 1);
    if (colon == std::string_view::npos) return faultOf(NC_("stromar", "point %1 ('%2') is not x:y"), index, text);
    const auto x = parseNumber(trimmed(text.substr(0, colon))), y = parseNumber(trimmed(text.substr(colon + 1)));
    if (!x || !y)
        return faultOf(x ? NC_("stromar", "point %1 ('%2') has a y that is no number")
                         : NC_("stromar", "point %1 ('%2') has an x that is no number"),
                       index, text);
    point = {*x, *y};
    return {};
}
} // namespace

CCurve::CCurve(std::vector<Point> points) : m_points(std::move(points)) {
    assert(!m_points.empty());
    assert(std::ranges::adjacent_find(m_points, std::ranges::greater_equal{}, &Point::x) == m_points.end());
}

std::optional<CCurve> CCurve::parse(std::string_view text, Fault& fault) {
    std::vector<Point> points;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        const std::string_view piece = text.substr(begin, comma - begin);
        const std::size_t blanks = std::min(piece.find_first_not_of(" \t"), piece.size());
        Point point{};
        std::string wrong = readPoint(piece, points.size(), point);
        if (wrong.empty() && !points.empty() && point.x <= points.back().x)
            wrong = faultOf(NC_("stromar", "point %1 ('%2') must lie to the right of the point before it"),
                            points.size(), piece);
        if (wrong.empty() && points.size() == kMaxPoints)
            wrong = translated(NC_("stromar", "a curve has at most %1 points"), kMaxPoints);
        if (!wrong.empty()) {
            fault = {std::move(wrong), begin + blanks};
            return {};
        }
        points.push_back(point);
        begin = comma + 1;
    }
    return CCurve(std::move(points));
}

std::string CCurve::text() const {
    std::string all;
    for (const Point& point : m_points)
        all += (all.empty() ? "" : ", ") + numberText(point.x) + ":" + numberText(point.y);
    return all;
}

double CCurve::at(double x) const {
    const auto right = std::ranges::upper_bound(m_points, x, {}, &Point::x);
    if (right == m_points.begin()) return m_points.front().y;
    if (right == m_points.end()) return m_points.back().y;
    const Point &low = *(right - 1), &high = *right;
    return low.y + (high.y - low.y) * (x - low.x) / (high.x - low.x);
}

} // namespace stromar
