#include "stromar/app/Render.h"
#include "stromar/app/Pictures.h"
#ifdef STROMAR_WITH_OSG
#include "stromar/model/ModelSway.h"
#include "stromar/scene/Headless.h"
#include "stromar/scene/Outline.h"
#include <cmath>
#endif

namespace stromar {

namespace {
constexpr RenderView kViews[] = {
    {"front", 0, 4, 1, 0.5}, {"side", 90, 4, 1, 0.5}, {"top", 0, 90, 1, 0.5}, {"crown", 25, 5, 0.45, 0.72}, {"closeup", 25, 6, 0.28, 0.62}};
constexpr SeasonName kSeasons[] = {{"spring", 4.6}, {"summer", 7}, {"autumn", 10.1}, {"winter", 1}};
constexpr std::string_view kBackdrops[] = {"sky", "light", "dark", "none"}; // as Backdrop
} // namespace

std::span<const std::string_view> backdropNames() { return kBackdrops; }
std::span<const RenderView> renderViews() { return kViews; }
std::span<const SeasonName> seasonNames() { return kSeasons; }

#ifdef STROMAR_WITH_OSG
namespace {
constexpr double kFilmHeight = 24; // millimetres

/// Corners of the box, or all that is drawn, as the options frame it.
CCamera cameraOf(const RenderOptions& options, const osg::BoundingBox& all, const std::vector<osg::Vec3f>& points) {
    const RenderView& view = kViews[options.view];
    const double aspect = double(options.width) / options.height;
    CCamera camera;
    camera.lookFrom(options.from ? options.from->first : view.yaw, options.from ? options.from->second : view.pitch);
    if (options.focalLength > 0)
        camera.setFieldOfView(osg::RadiansToDegrees(2 * std::atan(kFilmHeight / 2 / options.focalLength)));
    if (options.fit && !points.empty()) {
        camera.fit(points, aspect);
        return camera;
    }
    const osg::Vec3d low(all._min), high(all._max);
    const osg::Vec3d half = (high - low) * (0.5 * view.part);
    const osg::Vec3d middle((low.x() + high.x()) / 2, (low.y() + high.y()) / 2,
                            low.z() + (high.z() - low.z()) * view.from);
    camera.frame(osg::BoundingBoxd(middle - half, middle + half), aspect);
    return camera;
}

using SurfaceFiles = std::array<std::string, kSurfaces.size()>;

/// The pictures of all surfaces that parts show, those that `shown` does not have yet; `take` is given each.
template <typename Take>
void readSurfaces(const RenderTree& tree, const std::vector<ViewPart>& parts, SurfaceFiles& shown, Take&& take) {
    for (const ViewPart& part : parts) {
        const std::string file = textureOf(*tree.model, part.surface, tree.folder).string();
        std::string& known = shown[static_cast<std::size_t>(part.surface)];
        if (known == file) continue;
        const auto maps = readSurface(part.surface, file);
        if (!maps->problem.empty()) throw CError(maps->problem);
        take(part.surface, maps);
        known = file;
    }
}

/// Paints one model after the other, from one place.
class CTreePainter {
public:
    CTreePainter(const std::filesystem::path& treeFolder, const RenderOptions& options)
        : m_folder(treeFolder), m_options(options) {
        ViewLook look;
        look.light = options.light;
        look.backdrop = static_cast<Backdrop>(options.backdrop);
        if (!options.backdropPicture.empty()) {
            look.backdrop = Backdrop::Picture;
            look.picture = readBackdrop(options.backdropPicture);
        }
        m_scene.setLook(look);
    }

    void show(const std::shared_ptr<const TreeModel>& model, const CProgress& progress) {
        makePictures(*model, m_folder, progress);
        m_parts = viewPartsOf(*model, m_parts, progress);
        if (m_parts.empty() && model->age > 0) throw CError("the tree is empty, there is nothing to show");
        m_scene.show(m_parts);
        readSurfaces({model, m_folder}, m_parts, m_shown,
                     [&](Surface surface, const auto& maps) { m_scene.setSurface(surface, *maps); });
    }
    /// To the right of the first, as the camera sees them.
    void showBeside(std::span<const RenderTree> trees, const CProgress& progress) {
        std::vector<TreeBeside> others;
        const osg::Vec3d along = cameraOf(m_options, {}, {}).right();
        double edge = reachOf(m_parts, along).second, before = 0;
        for (const RenderTree& tree : trees) {
            makePictures(*tree.model, tree.folder, progress);
            TreeBeside& other = others.emplace_back(TreeBeside{viewPartsOf(*tree.model, {}, progress), {}, {}});
            const auto [left, right] = reachOf(other.parts, along);
            const double foot = before + distanceInRow(edge, left, std::max(tree.model->tree->height(), left + right));
            other.place = osg::Vec3(along * foot);
            before = foot;
            edge = right;
            for (const osg::Vec3f& point : outlineOf(other.parts)) m_beside.push_back(point + other.place);
            SurfaceFiles shown;
            readSurfaces(tree, other.parts, shown,
                         [&](Surface surface, const auto& maps) { other.surfaces[static_cast<std::size_t>(surface)] = maps; });
        }
        m_scene.showBeside(others);
    }
    void frame() {
        const osg::BoundingBox air(-1, -1, 0, 1, 1, 2); // before the tree's life
        m_camera = cameraOf(m_options, m_parts.empty() ? air : m_scene.bounds(), fitted());
    }
    /// With room for a tree that falls.
    void frame(const CMovingModel& moving, const CProgress& progress) {
        osg::BoundingBox all = m_scene.bounds();
        std::vector<osg::Vec3f> points = fitted();
        if (moving.fallSeconds() > 0) {
            const auto last = moving.poseAt(moving.fallSeconds(), progress);
            for (std::size_t n = 0; n < last->rows.size(); n += 2) {
                points.emplace_back(last->rows[n].x, last->rows[n].y, std::max(0.f, last->rows[n].z));
                all.expandBy(points.back());
            }
        }
        m_camera = cameraOf(m_options, all, points);
    }
    void move(const CMovingModel& moving, double seconds, const CProgress& progress) {
        m_scene.setPose(moving.sway(), moving.poseAt(seconds, progress), seconds, moving.loop());
    }
    Pixels paint() {
        return m_painter.paint(m_camera, m_options.width, m_options.height);
    }

private:
    /// What has to be in the picture; nothing where a view decides.
    std::vector<osg::Vec3f> fitted() const {
        if (!m_options.fit) return {};
        std::vector<osg::Vec3f> points = outlineOf(m_parts);
        points.insert(points.end(), m_beside.begin(), m_beside.end());
        return points;
    }

    std::filesystem::path m_folder;
    const RenderOptions& m_options;
    CViewScene m_scene;
    CHeadlessPainter m_painter{m_scene, m_options.samples};
    CCamera m_camera;
    std::vector<ViewPart> m_parts;
    std::vector<osg::Vec3f> m_beside; ///< where the other trees have vertices
    SurfaceFiles m_shown;
};

/// As it is to be seen.
std::shared_ptr<const TreeModel> finished(const RenderTree& tree, const RenderOptions& options, const SizeLimits& limits, const CProgress& progress) {
    return displaced(tree.model, options.displacement, tree.folder, limits, progress);
}
} // namespace

Pixels renderPicture(std::span<const RenderTree> plain, const RenderOptions& options, const CProgress& progress) {
    std::vector<RenderTree> finishedTrees;
    for (const RenderTree& tree : plain) finishedTrees.push_back({finished(tree, options, SizeLimits(), progress), tree.folder});
    const std::span<const RenderTree> trees = finishedTrees;
    CTreePainter painter(trees.front().folder, options);
    painter.show(trees.front().model, progress);
    painter.showBeside(trees.subspan(1), progress);
    painter.frame();
    return painter.paint();
}

void renderMotion(CTreeCreator& creator, const CParams& params, const Detail& detail, const Motion& motion, double age,
                  const std::filesystem::path& treeFolder, const RenderOptions& options,
                  const std::function<void(std::size_t, const Pixels&)>& take, const CProgress& progress) {
    CTreePainter painter(treeFolder, options);
    const auto create = [&](double at) {
        creator.setAge(at);
        return finished({creator.create(params, detail, progress), treeFolder}, options, creator.limits(), progress);
    };
    const auto last = create(age);
    std::optional<CMovingModel> moving;
    if (motion.sways()) moving.emplace(last, motion, progress);
    painter.show(moving ? moving->sway()->model : last, progress);
    if (moving)
        painter.frame(*moving, progress);
    else
        painter.frame();
    const std::vector<Moment> moments = motion.moments(age, moving ? moving->fallSeconds() : 0);
    for (std::size_t i = 0; i < moments.size(); ++i) {
        progress.poll();
        if (moving)
            painter.move(*moving, moments[i].seconds, progress);
        else if (moments[i].age != age || i > 0)
            painter.show(create(moments[i].age), progress);
        take(i, painter.paint());
        progress.report(double(i + 1) / double(moments.size()));
    }
}
#else
Pixels renderPicture(std::span<const RenderTree>, const RenderOptions&, const CProgress&) {
    throw CError("this program was built without OpenSceneGraph, which draws pictures");
}
void renderMotion(CTreeCreator&, const CParams&, const Detail&, const Motion&, double, const std::filesystem::path&, const RenderOptions&,
                  const std::function<void(std::size_t, const Pixels&)>&, const CProgress&) {
    throw CError("this program was built without OpenSceneGraph, which draws pictures");
}
#endif

} // namespace stromar
