#pragma once
#include "stromar/model/ModelSway.h"
#include "stromar/tree/Fall.h"
#include <filesystem>
#include <optional>
#include <vector>

namespace stromar {

/// A moment of a tree that moves.
struct Moment {
    double age;     ///< 0..1 of its life
    double seconds; ///< since the motion began
};

/// What moves a tree while pictures or files are made of it: it is felled; or the wind, in a loop; without either it
/// grows.
struct Motion {
    Wind wind;
    int frames = 0; ///< 0: one moment alone
    double fps = 25;
    double seconds = 0; ///< how long the wind's loop is; 0: as long as its frames

    std::optional<Felling> felling{};

    /// Whether the tree stays what it is, and its nodes move.
    bool sways() const { return felling || wind.strength > 0; }
    /// As many as there are to be made of a tree of an age. Growth ends at that age; a loop's next moment would be its
    /// first; the last of a fall, which takes so many seconds, shows the tree lying, as does a single one.
    std::vector<Moment> moments(double age, double fallSeconds = 0) const;
    /// The wind that repeats with the frames.
    Wind loopingWind() const;
};
constexpr int kMaxFrames = 100000;

/// A model that moves but does not grow.
class CMovingModel {
public:
    CMovingModel(const std::shared_ptr<const TreeModel>& model, const Motion& motion, const CProgress& progress);

    /// With its places; of a felled tree the trunk may be cut.
    const std::shared_ptr<const ModelSway>& sway() const { return m_sway; }
    double fallSeconds() const { return m_fall ? m_fall->seconds() : 0; }
    double loop() const { return m_wind.loop; }
    std::shared_ptr<const WindPose> poseAt(double seconds, const CProgress& progress) const;

private:
    std::shared_ptr<const ModelSway> m_sway;
    std::optional<CFall> m_fall;
    Wind m_wind;
};

/// "oak.png" as the i-th of so many: "oak_0001.png".
std::filesystem::path framePath(const std::filesystem::path& path, std::size_t i, std::size_t count);

} // namespace stromar
