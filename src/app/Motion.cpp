#include "stromar/app/Motion.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace stromar {

namespace {
constexpr std::size_t kFewestDigits = 4;
}

std::vector<Moment> Motion::moments(double age) const {
    if (frames == 0) return {{age, 0}};
    std::vector<Moment> all;
    const double loop = loopingWind().loop;
    for (int i = 0; i < frames; ++i)
        all.push_back(blows() ? Moment{age, i * loop / frames} : Moment{age * (i + 1) / frames, i / fps});
    return all;
}

Wind Motion::loopingWind() const {
    Wind looping = wind;
    looping.loop = frames == 0 ? 0 : seconds > 0 ? seconds : frames / fps;
    return looping;
}

std::filesystem::path framePath(const std::filesystem::path& path, std::size_t i, std::size_t count) {
    const std::size_t digits = std::max(kFewestDigits, std::to_string(count).size());
    std::string number = std::to_string(i + 1);
    number.insert(0, digits - number.size(), '0');
    return path.parent_path() / (path.stem().string() + "_" + number + path.extension().string());
}

glm::dvec3 windDirection(double degrees) {
    const double a = degrees * std::numbers::pi / 180;
    return {std::cos(a), std::sin(a), 0};
}

} // namespace stromar
