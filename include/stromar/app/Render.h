#pragma once
#include "stromar/app/DisplacedModel.h"
#include "stromar/app/Motion.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/model/Light.h"
#include "stromar/texture/Opacity.h"
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace stromar {

/// Where a picture is taken from.
struct RenderView {
    std::string_view name;
    double yaw, pitch; ///< degrees; yaw 0 the front, 90 the right
    double part;       ///< of the tree's height and width that fills the picture
    double from;       ///< height of the part's middle, 0 at the ground, 1 at the top
};
std::span<const RenderView> renderViews();

/// What is behind the tree.
std::span<const std::string_view> backdropNames();

/// A season by its name, for those who do not count months.
struct SeasonName {
    std::string_view name;
    double month;
};
std::span<const SeasonName> seasonNames();

struct RenderOptions {
    int width = 800, height = 800;
    int view = 0; ///< row of renderViews()
    int samples = 4;
    int backdrop = 0; ///< row of backdropNames()
    std::string backdropPicture{}; ///< a file in place of it: .png, .jpg, or a panorama, .hdr
    Light light{};
    std::optional<std::pair<double, double>> from; ///< yaw and pitch in place of the view's
    double focalLength = 0; ///< millimetres, of a picture 24 mm high; 0: that of the window
    Displacement displacement{0};
    bool fit = false;       ///< the whole tree just fills the picture
};

/// A tree in a picture, and the folder at which its paths start.
struct RenderTree {
    std::shared_ptr<const TreeModel> model;
    std::filesystem::path folder;
};

/// The picture that the viewport would show, without a window; several trees stand in a row, from left to right. Draws the trees'
/// recipes first, where they are new. Throws CError, which says what is missing, and CCancelled.
Pixels renderPicture(std::span<const RenderTree> trees, const RenderOptions& options, const CProgress& progress);
/// The pictures of a motion, one after the other, all seen from the same place; `take` is given each. Throws as renderPicture().
void renderMotion(CTreeCreator& creator, const CParams& params, const Detail& detail, const Motion& motion, double age,
                  const std::filesystem::path& treeFolder, const RenderOptions& options,
                  const std::function<void(std::size_t, const Pixels&)>& take, const CProgress& progress);

} // namespace stromar
