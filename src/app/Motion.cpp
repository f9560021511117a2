#include "stromar/app/Motion.h"
#include <algorithm>
#include <cmath>
#include <string>

namespace stromar {

namespace {
constexpr std::size_t kFewestDigits = 4;
}

std::vector<Moment> Motion::moments(double age, double fallSeconds) const {
    if (frames == 0) return {{age, felling ? fallSeconds : 0}};
    std::vector<Moment> all;
    const double loop = loopingWind().loop;
    for (int i = 0; i < frames; ++i)
        if (felling)
            all.push_back({age, fallSeconds * (i + 1) / frames});
        else
            all.push_back(sways() ? Moment{age, i * loop / frames} : Moment{age * (i + 1) / frames, i / fps});
    return all;
}

Wind Motion::loopingWind() const {
    Wind looping = wind;
    looping.loop = frames == 0 || felling ? 0 : seconds > 0 ? seconds : frames / fps;
    return looping;
}

CMovingModel::CMovingModel(const std::shared_ptr<const TreeModel>& model, const Motion& motion,
                           const CProgress& progress)
    : m_sway(swayOf(model, nullptr, progress)), m_wind(motion.loopingWind()) {
    if (!motion.felling) return;
    m_fall.emplace(m_sway->table, *motion.felling);
    m_sway = felled(m_sway, *m_fall);
}

std::shared_ptr<const WindPose> CMovingModel::poseAt(double seconds, const CProgress& progress) const {
    auto pose = std::make_shared<WindPose>();
    if (m_fall)
        m_fall->pose(seconds, *pose, progress);
    else
        m_sway->table->pose(m_wind, seconds, *pose, progress);
    return pose;
}

std::filesystem::path framePath(const std::filesystem::path& path, std::size_t i, std::size_t count) {
    const std::size_t digits = std::max(kFewestDigits, std::to_string(count).size());
    std::string number = std::to_string(i + 1);
    number.insert(0, digits - number.size(), '0');
    return path.parent_path() / (path.stem().string() + "_" + number + path.extension().string());
}

} // namespace stromar
