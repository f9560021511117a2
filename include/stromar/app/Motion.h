#pragma once
#include "stromar/tree/Wind.h"
#include <filesystem>
#include <vector>

namespace stromar {

/// A moment of a tree that moves.
struct Moment {
    double age;     ///< 0..1 of its life
    double seconds; ///< since the motion began
};

/// What moves a tree while pictures or files are made of it: the wind, in a loop; without wind it grows.
struct Motion {
    Wind wind;
    int frames = 0; ///< 0: one moment alone
    double fps = 25;
    double seconds = 0; ///< how long the wind's loop is; 0: as long as its frames

    bool blows() const { return wind.strength > 0; }
    /// As many as there are to be made of a tree of an age. Growth ends at that age; a loop's next moment would be its first.
    std::vector<Moment> moments(double age) const;
    /// The wind that repeats with the frames.
    Wind loopingWind() const;
};
constexpr int kMaxFrames = 100000;

/// "oak.png" as the i-th of so many: "oak_0001.png".
std::filesystem::path framePath(const std::filesystem::path& path, std::size_t i, std::size_t count);

/// A horizontal direction: degrees from x, counter-clockwise seen from above.
glm::dvec3 windDirection(double degrees);

} // namespace stromar
