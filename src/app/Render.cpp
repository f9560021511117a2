#include "stromar/app/Render.h"
#include "stromar/app/Pictures.h"
#ifdef STROMAR_WITH_OSG
#include "stromar/scene/Headless.h"
#endif

namespace stromar {

namespace {
constexpr RenderView kViews[] = {
    {"front", 0, 4, 1, 0.5}, {"side", 90, 4, 1, 0.5}, {"top", 0, 90, 1, 0.5}, {"closeup", 25, 6, 0.28, 0.62}};
constexpr SeasonName kSeasons[] = {{"spring", 4.6}, {"summer", 7}, {"autumn", 10.1}, {"winter", 1}};
} // namespace

std::span<const RenderView> renderViews() { return kViews; }
std::span<const SeasonName> seasonNames() { return kSeasons; }

#ifdef STROMAR_WITH_OSG
namespace {
CCamera cameraOf(const RenderView& view, const osg::BoundingBox& all, double aspect) {
    const osg::Vec3d low(all._min), high(all._max);
    const osg::Vec3d half = (high - low) * (0.5 * view.part);
    const osg::Vec3d middle((low.x() + high.x()) / 2, (low.y() + high.y()) / 2,
                            low.z() + (high.z() - low.z()) * view.from);
    CCamera camera;
    camera.lookFrom(view.yaw, view.pitch);
    camera.frame(osg::BoundingBoxd(middle - half, middle + half), aspect);
    return camera;
}
} // namespace

Pixels renderPicture(const TreeModel& model, const std::filesystem::path& treeFolder, const RenderOptions& options,
                     const CProgress& progress) {
    makePictures(model, treeFolder, progress);
    CViewScene scene;
    const std::vector<ViewPart> parts = viewPartsOf(model, {}, progress);
    if (parts.empty() && model.age > 0) throw CError("the tree is empty, there is nothing to show");
    scene.show(parts);
    for (const ViewPart& part : parts) {
        const std::string file = textureOf(model, part.surface, treeFolder).string();
        const auto maps = readSurface(part.surface, file);
        if (!maps->problem.empty()) throw CError(maps->problem);
        scene.setSurface(part.surface, *maps);
    }
    ViewLook look;
    look.hour = options.hour;
    if (options.transparent) look.backdrop = Backdrop::Nothing;
    scene.setLook(look);
    CHeadlessPainter painter(scene, options.samples);
    const double aspect = double(options.width) / options.height;
    const osg::BoundingBox all = parts.empty() ? osg::BoundingBox(-1, -1, 0, 1, 1, 2) : scene.bounds(); // before its life there is air
    return painter.paint(cameraOf(kViews[options.view], all, aspect), options.width, options.height);
}
#else
Pixels renderPicture(const TreeModel&, const std::filesystem::path&, const RenderOptions&, const CProgress&) {
    throw CError("this program was built without OpenSceneGraph, which draws pictures");
}
#endif

} // namespace stromar
