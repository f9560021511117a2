#pragma once
#include "stromar/model/Light.h"
#include "stromar/model/ModelSway.h"
#include "stromar/scene/BackdropPicture.h"
#include "stromar/scene/NeighbourBarks.h"
#include "stromar/scene/SurfaceMaps.h"
#include "stromar/scene/ViewPass.h"
#include <array>
#include <memory>
#include <optional>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/Uniform>
#include <string>
#include <vector>

namespace stromar {

class CGrass;
class CShadowMap;
class CSwayTables;
class CTreeNode;

/// A mesh, or leaves as instances, ready to be drawn.
struct ViewPart {
    static constexpr int kLeaves = -1; ///< then −2 the blossoms, −3 the fruits
    static constexpr int kNone = -100;

    osg::ref_ptr<osg::Geometry> geometry;
    Surface surface;
    int generation = 0;                         ///< kLeaves for leaves
    std::shared_ptr<const CMesh> mesh{};        ///< what it shows: this
    std::shared_ptr<const COrganMesh> organs{}; ///< or these
    double colourVariation = 0;                 ///< of its leaves, 0..1
    double sunAndShade = 0;                     ///< likewise: how dark those inside the crown are
    NeighbourBarks neighbours{};                ///< of the bark of stems
    double trunkRadius = 0;                     ///< metres; of stems: VertexLook::thinness is relative to it
    double meanRadius = 0;                      ///< of these stems
};

/// What the model shows, ready for the viewport. Parts of `known` that show the same are taken over. Any thread. Throws
/// CCancelled.
std::vector<ViewPart> viewPartsOf(const TreeModel& model, const std::vector<ViewPart>& known, const CProgress& progress);

enum class Backdrop { Sky, Light, Dark, Nothing, Picture }; ///< Nothing: transparent
enum class Wireframe { Off, Only, Over };
enum class Shading { Lit, Material, Occlusion, Normals };

/// What is drawn beside the tree, and how.
struct ViewLook {
    Backdrop backdrop = Backdrop::Sky;
    std::shared_ptr<const BackdropPicture> picture{}; ///< of Backdrop::Picture: the trees' shadow falls on it, a panorama lights them
    Wireframe wireframe = Wireframe::Off;
    Shading shading = Shading::Lit;
    Light light{};
    /// A photograph of a real tree, upright behind the trees whatever is in between, its foot at the trunk's; null: none.
    std::shared_ptr<const BackdropPicture> reference{};
    double referenceHeight = 10; ///< metres that it is high
    bool leaves = true;  ///< and blossoms and fruits
    bool ground = false; ///< a grid of metres, and a person of 1.75 m beside the tree
    bool operator==(const ViewLook&) const = default;
};

/// A tree that stands beside the one that is edited, and does not sway.
struct TreeBeside {
    std::vector<ViewPart> parts;
    std::array<std::shared_ptr<const SurfaceMaps>, kSurfaces.size()> surfaces; ///< null: plain
    osg::Vec3 place;                                                           ///< of its foot
};

/// Where a ray meets the tree.
struct ViewHit {
    int generation; ///< kLeaves for leaves
    osg::Vec3d point; ///< of the tree in still air
};

/// What the viewport shows: the tree, the ground it stands on, the sky. All members: the thread that draws.
class CViewScene {
public:
    ~CViewScene();

    static constexpr double kPersonHeight = 1.75; ///< metres

    CViewScene();

    osg::Group* root() { return m_root; }
    enum class Shadows { New, Kept };
    /// Replaces the tree; parts that were shown before stay on the graphics card. Shadows may be those of the tree
    /// before until renewShadows(): a tree that changes many times a second saves half the drawing.
    void show(const std::vector<ViewPart>& parts, Shadows shadows = Shadows::New);
    void renewShadows();
    /// A simpler model of the tree that is shown, for passes that want one; nothing: there is none. Of a tree with leaves it is drawn
    /// without the twigs that bear most of them: they are most of its triangles, and hidden.
    void setStandIn(const std::vector<ViewPart>& parts);
    bool hasStandIn() const;
    /// The tree that is shown in a pose of the wind; `sway` is of its model. Shadows follow: at once, or with a later pose.
    void setPose(const std::shared_ptr<const ModelSway>& sway, const std::shared_ptr<const WindPose>& pose, double seconds, double loop,
                 Shadows shadows = Shadows::New);
    /// Still air.
    void endSway();
    void setSurface(Surface surface, const SurfaceMaps& maps);
    /// Replaces the trees beside it. Nobody picks them.
    void showBeside(const std::vector<TreeBeside>& others);
    void setLook(const ViewLook& look);
    const ViewLook& look() const { return m_look; }
    /// Colours one generation; ViewPart::kNone colours none.
    void tint(int generation);
    int tinted() const { return m_tinted; }
    osg::BoundingBox bounds() const; ///< of all trees
    /// Some thousands of points that all trees reach to.
    std::vector<osg::Vec3f> outline() const;
    /// For who draws: what lay on the graphics card is lost; a pixel has so many samples in each of so many passes. One
    /// sample in all stands for drawing by the processor: lesser looks. Without `instancing`, which OpenGL 3.3 has, leaves get vertices of their
    /// own.
    void startContext(int samples, int passes, bool instancing);
    /// For who draws: before each frame. `pixel`: its size at a distance of 1 m, metres; the tree is about so far away.
    void setPass(const ViewPass& pass, double pixel, double distance);
    /// After it.
    void finishFrame();
    /// Where the person of the ground stands; z is the top of the head.
    osg::Vec3d personAt() const;
    /// The nearest visible triangle along a ray, where the wind has it. Cost: every triangle near it; in the wind, every one.
    std::optional<ViewHit> pick(const osg::Vec3d& from, const osg::Vec3d& direction) const;

private:
    void setQuality(int samples, int passes);
    std::vector<CTreeNode*> standing() const;
    std::vector<CTreeNode*> trees() const;
    bool drawsStandIn() const { return m_pass.standIn && hasStandIn() && !m_sway; }
    void updateGround();
    void showBackdropPicture();
    void showReference();
    void updateLight();
    void hangParts();
    void showStandIn();
    void aimAtPose();
    void aimShadows(const osg::BoundingBox& box);
    std::shared_ptr<const CMesh> swayedMesh(const ViewPart& part) const;
    SwayPlace placeOf(const ViewPart& part, std::uint32_t vertex) const;
    std::optional<ViewHit> pickSwayed(const osg::Vec3d& from, const osg::Vec3d& direction) const;

    osg::ref_ptr<osg::Group> m_root, m_tree, m_wireframe, m_person, m_stand; ///< m_stand: all trees
    osg::ref_ptr<osg::Geometry> m_background, m_reference;
    std::unique_ptr<CTreeNode> m_main, m_standIn;
    std::vector<ViewPart> m_standInParts; ///< all of them
    std::vector<std::unique_ptr<CTreeNode>> m_others;
    std::unique_ptr<CGrass> m_grass;
    std::unique_ptr<CShadowMap> m_shadows;
    osg::ref_ptr<osg::StateSet> m_state; ///< of everything
    std::unique_ptr<CSwayTables> m_swayTables;
    std::shared_ptr<const ModelSway> m_sway; ///< of the model that is shown; null in still air
    struct {
        std::shared_ptr<const WindPose> rows;
        double seconds = 0, loop = 0;
    } m_pose;
    bool m_instancing = true, m_smooth = false;
    bool m_instancesAreNew = false; ///< not yet drawn: the graphics card has no copy
    ViewLook m_look;
    ViewPass m_pass;
    bool m_shadowsBehind = false; ///< they are those of an older tree
    std::size_t m_shadowVertices = 0; ///< of a kind of organ, at most, when they were drawn
    bool m_shadowOfStandIn = false;
    int m_tinted = ViewPart::kNone;
};

} // namespace stromar
