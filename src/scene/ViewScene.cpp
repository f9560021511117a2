#include "stromar/scene/ViewScene.h"
#include "Backdrop.h"
#include "Grass.h"
#include "Programs.h"
#include "Shaders.h"
#include "ShadowMap.h"
#include "SwayTables.h"
#include "TreeNode.h"
#include "Uniforms.h"
#include "stromar/model/Material.h"
#include "stromar/scene/Daylight.h"
#include "stromar/scene/OsgGeometry.h"
#include "stromar/scene/Outline.h"
#include "stromar/scene/SurfaceMaps.h"
#include "stromar/texture/Opacity.h"
#include <algorithm>
#include <cmath>
#include <osg/PolygonMode>
#include <osg/PolygonOffset>
#include <osg/Texture2D>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

namespace stromar {

namespace {
constexpr double kSunRadius = 0.012; // radians: the disc and the glow about it
constexpr double kThinnestWood = 0.65; // pixels, a radius: of tubes of three sides no row of pixels is without one
constexpr float kShadowRoom = 0.1f; // about a moving tree, of its size
constexpr std::size_t kOutlinePoints = 2000; // of a part
constexpr std::size_t kHides = 2000;         // leaves, the twigs behind them
constexpr int kBestShadow = 2048, kFastShadow = 1024; // pixels of a side

osg::ref_ptr<osg::Program> makeLitProgram(const char* looks) {
    return makeTreeProgram("tree", kTreeVertexShader, std::string(looks) + kLightFunctions + kCutOutFunctions + kTreeFragmentShader);
}

void styleWireframe(osg::StateSet* wireframe) {
    wireframe->setAttributeAndModes(makeTreeProgram("wires", kPlainVertexShader, kPlainFragmentShader));
    wireframe->addUniform(new osg::Uniform("colour", osg::Vec4(0.02f, 0.03f, 0.05f, 0.3f)));
    wireframe->setMode(GL_BLEND, osg::StateAttribute::ON);
    wireframe->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    wireframe->setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE));
    wireframe->setAttributeAndModes(new osg::PolygonOffset(-1, -1));
    wireframe->setMode(GL_POLYGON_OFFSET_LINE, osg::StateAttribute::ON);
}

void show(osg::Node& node, bool on) { node.setNodeMask(on ? ~0u : 0u); }

/// Every instance's place for each of its vertices.
SwayPlaces ofVertices(const SwayPlaces& instances, std::size_t vertices) {
    SwayPlaces all;
    all.reserve(instances.size() * vertices);
    for (const SwayPlace& place : instances) all.insert(all.end(), vertices, place);
    return all;
}
} // namespace

CViewScene::CViewScene()
    : m_root(new osg::Group), m_tree(new osg::Group), m_wireframe(new osg::Group), m_stand(new osg::Group),
      m_background(makeBackground()), m_reference(makeReference()), m_main(std::make_unique<CTreeNode>()),
      m_standIn(std::make_unique<CTreeNode>()), m_state(m_root->getOrCreateStateSet()) {
    m_stand->addChild(m_main->node());
    m_stand->addChild(m_standIn->node());
    m_standIn->node()->setNodeMask(0);
    setFloat(m_standIn->node()->getOrCreateStateSet(), "swaying", 0);
    m_shadows = std::make_unique<CShadowMap>(m_stand);
    m_shadows->addTo(m_state, kShadowUnit);
    m_swayTables = std::make_unique<CSwayTables>();
    m_swayTables->addTo(m_state, kSwayRowsUnit, kSwayStillUnit);
    m_person = makePerson(m_state->getOrCreateUniform("place", osg::Uniform::FLOAT_VEC3));
    m_tree->addChild(m_stand);
    m_wireframe->addChild(m_stand);
    m_root->addChild(m_shadows->camera());
    m_root->addChild(m_background);
    m_root->addChild(m_reference);
    m_grass = std::make_unique<CGrass>();
    m_root->addChild(m_grass->node());
    m_root->addChild(m_tree);
    m_root->addChild(m_wireframe);
    setInteger(m_state, "picture", kAlbedoUnit);
    setInteger(m_state, "relief", kReliefUnit);
    setInteger(m_state, "gloss", kGlossUnit);
    setInteger(m_state, "under", kUnderUnit);
    nameNeighbourPictures(*m_state);
    setNeighbours(*m_state, {});
    setFloat(m_state, "alphaCut", kAlphaCut);
    setFloat(m_state, "edgeSamples", 0);
    setFloat(m_state, "instanced", 0);
    setVector(m_state, "pass", {});
    setFloat(m_state, "thinnestWood", 0);
    setFloat(m_state, "halvings", 255.0 / VertexLook::kThinnessOfHalf);
    osg::StateSet* state = m_tree->getOrCreateStateSet();
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    styleWireframe(m_wireframe->getOrCreateStateSet());
    tint(ViewPart::kNone);
    setLook({});
    setQuality(1, 1);
    updateGround();
}

CViewScene::~CViewScene() = default;

/// The edited one, then those beside it.
std::vector<CTreeNode*> CViewScene::standing() const {
    std::vector<CTreeNode*> all{m_main.get()};
    for (const auto& other : m_others) all.push_back(other.get());
    return all;
}

/// With the simpler one that stands in for the first.
std::vector<CTreeNode*> CViewScene::trees() const {
    std::vector<CTreeNode*> all = standing();
    all.push_back(m_standIn.get());
    return all;
}

void CViewScene::setStandIn(const std::vector<ViewPart>& parts) {
    m_standInParts = parts;
    showStandIn();
}

void CViewScene::showStandIn() {
    std::vector<ViewPart> parts = m_standInParts;
    const bool hidden = m_look.leaves && std::ranges::any_of(parts, [](const ViewPart& part) {
                            return part.organs && part.organs->count() > kHides;
                        });
    int last = 0;
    for (const ViewPart& part : parts) last = std::max(last, part.generation);
    if (hidden && last > 0) std::erase_if(parts, [last](const ViewPart& part) { return part.generation == last; });
    m_standIn->show(parts, m_instancing);
    m_standIn->showLeaves(m_look.leaves);
    m_instancesAreNew = true;
}

bool CViewScene::hasStandIn() const { return !m_standIn->parts().empty(); }

void CViewScene::show(const std::vector<ViewPart>& parts, Shadows shadows) {
    m_shadowsBehind = shadows == Shadows::Kept;
    m_sway.reset();
    m_swayTables->setOff();
    m_main->show(parts, m_instancing);
    m_instancesAreNew = true;
    hangParts();
    updateGround();
}

void CViewScene::showBeside(const std::vector<TreeBeside>& others) {
    for (const auto& old : m_others) m_stand->removeChild(old->node());
    m_others.clear();
    for (const TreeBeside& other : others) {
        auto node = std::make_unique<CTreeNode>();
        node->standAt(other.place);
        node->show(other.parts, m_instancing);
        for (const Surface surface : kSurfaces)
            if (const auto& maps = other.surfaces[static_cast<std::size_t>(surface)]) node->setSurface(surface, *maps);
        setFloat(node->node()->getOrCreateStateSet(), "swaying", 0);
        node->showLeaves(m_look.leaves);
        node->smoothEdges(m_smooth);
        m_stand->addChild(node->node());
        m_others.push_back(std::move(node));
    }
    m_instancesAreNew = true;
    updateGround();
}

/// Gives all that is drawn its places on the axes of the swaying tree.
void CViewScene::hangParts() {
    for (std::size_t i = 0; i < m_main->parts().size(); ++i) {
        const ViewPart& part = m_main->parts()[i];
        osg::Geometry& drawn = m_main->drawn(i);
        if (!m_sway)
            setSwayPlaces(drawn, nullptr);
        else if (!part.organs)
            setSwayPlaces(drawn, m_sway->placesOf(*part.mesh));
        else if (m_instancing)
            setSwayPlaces(drawn, *m_sway->placesOf(*part.organs), m_sway->table->tree(), *part.organs);
        else
            setSwayPlaces(drawn, std::make_shared<SwayPlaces>(ofVertices(*m_sway->placesOf(*part.organs), part.organs->blade().points.size())));
    }
}

void CViewScene::setPose(const std::shared_ptr<const ModelSway>& sway, const std::shared_ptr<const WindPose>& pose, double seconds,
                         double loop, Shadows shadows) {
    if (sway != m_sway) {
        m_sway = sway;
        hangParts();
        m_swayTables->setStill(sway->table->still());
    }
    m_pose = {pose, seconds, loop};
    m_swayTables->setPose(*pose, seconds, loop);
    if (shadows == Shadows::Kept) return;
    aimAtPose();
    m_shadows->setStale();
}

/// Only where the tree has left what the shadows cover: an aim that moves with each pose makes their edges crawl.
void CViewScene::aimAtPose() {
    osg::BoundingBox box = bounds();
    for (std::size_t n = 0; n < m_pose.rows->rows.size(); n += 2) {
        const glm::vec4& node = m_pose.rows->rows[n];
        box.expandBy(node.x, node.y, std::max(0.f, node.z));
    }
    if (m_shadows->covers(box)) return;
    const osg::Vec3 room = (box._max - box._min) * kShadowRoom;
    aimShadows(osg::BoundingBox(box._min - room, box._max + room));
}

void CViewScene::aimShadows(const osg::BoundingBox& box) {
    osg::Vec3d sun(daylightAt(m_look.light).sun);
    osg::Vec3d across = sun ^ osg::Vec3d(0, 0, 1);
    if (across.normalize() == 0) across = osg::Vec3d(1, 0, 0);
    sun += (across * m_pass.sun.x() + (across ^ sun) * m_pass.sun.y()) * kSunRadius;
    sun.normalize();
    m_shadows->aim(box, osg::Vec3(sun));
}

void CViewScene::setPass(const ViewPass& pass, double pixel, double distance) {
    const double thinnest = pass.alone ? kThinnestWood * pixel : 0;
    setFloat(m_state, "thinnestWood", thinnest);
    for (CTreeNode* tree : trees()) tree->seeThrough(thinnest * distance);
    m_shadows->setLines(!pass.sunDisc);
    setVector(m_state, "pass", osg::Vec3(osg::Vec3d(pass.pixel.x(), pass.pixel.y(), pass.pattern)));
    const bool sameSun = pass.sun == m_pass.sun;
    m_pass = pass;
    if (m_instancing)
        for (CTreeNode* tree : trees()) tree->limitInstances(pass.organVertices);
    m_main->node()->setNodeMask(drawsStandIn() ? 0 : ~0u);
    m_standIn->node()->setNodeMask(drawsStandIn() ? ~0u : 0);
    if (pass.organVertices > m_shadowVertices || (m_shadowOfStandIn && !drawsStandIn())) m_shadows->setStale();
    if (!sameSun) aimShadows(m_shadows->aimedAt());
}

void CViewScene::endSway() {
    if (!m_sway) return;
    m_sway.reset();
    m_pose = {};
    hangParts();
    m_swayTables->setOff();
    updateLight();
}

namespace {
double trunkRadiusOf(const TreeModel& model) {
    const CTree& tree = *model.tree;
    return tree.generationCount() == 0 || tree.generation(0).stems.empty() ? 0 : tree.generation(0).stems[0].radius;
}

double meanRadiusOf(const CGeneration& generation) {
    double sum = 0;
    for (const CStem& stem : generation.stems) sum += stem.radius / 2; // they end in a tip
    return sum / std::max(1.0, double(generation.stems.size()));
}
} // namespace

std::vector<ViewPart> viewPartsOf(const TreeModel& model, const std::vector<ViewPart>& known,
                                  const CProgress& progress) {
    std::vector<ViewPart> parts;
    const auto add = [&](const auto& shown, auto ViewPart::*source, Surface surface, int generation, auto&& make) {
        progress.poll();
        const auto same = std::ranges::find(known, shown, source);
        ViewPart part = same != known.end() ? *same : ViewPart{make(), surface, generation};
        part.*source = shown;
        part.surface = surface;
        part.colourVariation = model.params.common.leafColourV;
        part.sunAndShade = isLeaf(surface) || surface == Surface::Twig ? model.params.common.leafSunShade : 0;
        if (isBark(surface)) {
            part.neighbours = neighbourBarksOf(model, surface);
            part.trunkRadius = trunkRadiusOf(model);
            part.meanRadius = meanRadiusOf(model.tree->generation(static_cast<std::size_t>(generation)));
        }
        parts.push_back(std::move(part));
    };
    model.visitMeshes(
        [&](const std::shared_ptr<const CMesh>& mesh, int generation) {
            add(mesh, &ViewPart::mesh, shownSurface(model.params, mesh->surface), generation, [&] { return makeViewGeometry(mesh); });
        },
        [&](const std::shared_ptr<const COrganMesh>& organs, int generation) {
            add(organs, &ViewPart::organs, organs->surface(), generation,
                [&] { return makeInstancedGeometry(organs, progress); });
        });
    return parts;
}

void CViewScene::setLook(const ViewLook& look) {
    const bool samePicture = look.picture == m_look.picture && look.backdrop == m_look.backdrop;
    const bool sameLight = look.light == m_look.light && look.leaves == m_look.leaves && samePicture;
    const bool otherLeaves = look.leaves != m_look.leaves;
    m_look = look;
    if (otherLeaves) showStandIn();
    if (look.picture && !samePicture) showBackdropPicture();
    setInteger(m_state, "backdrop", static_cast<int>(look.backdrop));
    setInteger(m_state, "view", static_cast<int>(look.shading));
    setFloat(m_state, "grid", look.ground);
    const auto mode = look.wireframe == Wireframe::Only ? osg::PolygonMode::LINE : osg::PolygonMode::FILL;
    m_tree->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, mode));
    stromar::show(*m_wireframe, look.wireframe == Wireframe::Over);
    stromar::show(*m_grass->node(), look.backdrop == Backdrop::Sky);
    for (CTreeNode* tree : trees()) tree->showLeaves(look.leaves);
    m_root->removeChild(m_person);
    if (look.ground) m_root->addChild(m_person); // only then does it take room
    showReference();
    if (!sameLight || !m_state->getUniform("sun")) updateLight();
}

void CViewScene::showBackdropPicture() {
    const BackdropPicture& picture = *m_look.picture;
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(picture.image);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, picture.panorama ? osg::Texture::LINEAR : osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, picture.panorama ? osg::Texture::REPEAT : osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    osg::StateSet* state = m_background->getOrCreateStateSet();
    state->setTextureAttributeAndModes(kBackdropUnit, texture);
    setInteger(state, "backdropPicture", kBackdropUnit);
    setFloat(state, "backdropAspect", picture.panorama ? 0 : double(picture.image->s()) / picture.image->t());
    setFloat(state, "backdropScale", picture.scale);
}

void CViewScene::showReference() {
    stromar::show(*m_reference, m_look.reference != nullptr);
    if (!m_look.reference) return;
    osg::Image& image = *m_look.reference->image;
    osg::StateSet* state = m_reference->getOrCreateStateSet();
    const auto* now = static_cast<const osg::Texture2D*>(state->getTextureAttribute(kAlbedoUnit, osg::StateAttribute::TEXTURE));
    if (!now || now->getImage() != &image) {
        osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(&image);
        texture->setResizeNonPowerOfTwoHint(false);
        state->setTextureAttributeAndModes(kAlbedoUnit, texture);
    }
    const double high = m_look.referenceHeight;
    state->getOrCreateUniform("size", osg::Uniform::FLOAT_VEC2)->set(osg::Vec2(osg::Vec2d(high * image.s() / image.t(), high)));
}

void CViewScene::tint(int generation) {
    m_tinted = generation;
    setFloat(m_state, "tinted", generation);
}

std::optional<ViewHit> CViewScene::pickSwayed(const osg::Vec3d& from, const osg::Vec3d& direction) const {
    const glm::dvec3 start(from.x(), from.y(), from.z()), ray(direction.x(), direction.y(), direction.z());
    std::optional<ViewHit> nearest;
    double distance = 0;
    for (const ViewPart& part : m_main->parts()) {
        if (!isBark(part.surface) && !m_look.leaves) continue;
        const auto mesh = swayedMesh(part);
        const auto met = meetMesh(*mesh, start, ray);
        if (!met || (nearest && met->distance >= distance)) continue;
        distance = met->distance;
        const Swayed there(m_sway->table->still(), *m_pose.rows, placeOf(part, mesh->indices[met->first]));
        const glm::vec3 point = there.stillPoint(glm::vec3(start + distance * ray));
        nearest = ViewHit{part.generation, osg::Vec3d(point.x, point.y, point.z)};
    }
    return nearest;
}

std::shared_ptr<const CMesh> CViewScene::swayedMesh(const ViewPart& part) const {
    const CProgress progress;
    if (part.mesh) return swayed(*part.mesh, *m_sway->placesOf(*part.mesh), *m_sway->table, *m_pose.rows, progress);
    return swayed(*part.organs, *m_sway->placesOf(*part.organs), *m_sway->table, *m_pose.rows, m_pose.seconds, m_pose.loop, progress);
}

/// Of a vertex of its swayedMesh().
SwayPlace CViewScene::placeOf(const ViewPart& part, std::uint32_t vertex) const {
    if (part.mesh) return (*m_sway->placesOf(*part.mesh))[vertex];
    return (*m_sway->placesOf(*part.organs))[vertex / part.organs->blade().points.size()];
}

std::optional<ViewHit> CViewScene::pick(const osg::Vec3d& from, const osg::Vec3d& direction) const {
    if (m_sway) return pickSwayed(from, direction);
    const double reach = (osg::Vec3d(bounds().center()) - from).length() + bounds().radius() + 1;
    osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
        new osgUtil::LineSegmentIntersector(from, from + direction * reach);
    ray->setIntersectionLimit(osgUtil::Intersector::LIMIT_NEAREST);
    osgUtil::IntersectionVisitor visitor(ray);
    visitor.setTraversalMask(~kInstancesMask);
    m_main->node()->accept(visitor);
    std::optional<ViewHit> nearest;
    double distance = 0;
    if (ray->containsIntersections()) {
        const auto hit = ray->getFirstIntersection();
        const auto part = std::ranges::find_if(m_main->parts(), [&](const ViewPart& p) { return p.geometry == hit.drawable; });
        if (part == m_main->parts().end()) return {};
        nearest = ViewHit{part->generation, hit.getWorldIntersectPoint()};
        distance = (nearest->point - from) * direction / direction.length2();
    }
    for (const ViewPart& part : m_main->parts()) {
        if (!part.organs || !m_look.leaves) continue;
        const auto met = part.organs->meet({from.x(), from.y(), from.z()}, {direction.x(), direction.y(), direction.z()});
        if (met.instance < 0 || (nearest && met.distance >= distance)) continue;
        nearest = ViewHit{part.generation, from + direction * met.distance};
        distance = met.distance;
    }
    return nearest;
}

void CViewScene::setSurface(Surface surface, const SurfaceMaps& maps) {
    if (surfaceOf(surface).cutOut) m_shadows->setStale();
    m_main->setSurface(surface, maps);
    m_standIn->setSurface(surface, maps);
}

void CViewScene::startContext(int samples, int passes, bool instancing) {
    m_shadows->setStale();
    if (instancing != m_instancing) {
        m_instancing = instancing;
        for (CTreeNode* tree : trees()) tree->show(std::vector(tree->parts()), instancing);
        hangParts();
    }
    m_instancesAreNew = true;
    setQuality(samples, passes);
}

void CViewScene::setQuality(int samples, int passes) {
    const bool best = samples * passes > 1;
    const char* looks = best ? kBestLooks : kFastLooks;
    m_tree->getOrCreateStateSet()->setAttributeAndModes(makeLitProgram(looks));
    m_background->getOrCreateStateSet()->setAttributeAndModes(makeBackgroundProgram(looks));
    m_grass->setLooks(looks);
    m_shadows->setSize(best ? kBestShadow : kFastShadow);
    setFloat(m_state, "edgeSamples", best ? samples : 0);
    m_smooth = best;
    for (CTreeNode* tree : trees()) tree->smoothEdges(best);
}

void CViewScene::finishFrame() {
    if (m_shadows->stale()) {
        m_shadowVertices = m_pass.organVertices;
        m_shadowOfStandIn = drawsStandIn();
    }
    m_shadows->setDrawn();
    if (!m_instancesAreNew || !m_look.leaves) return;
    for (CTreeNode* tree : trees()) tree->releaseInstances();
    m_instancesAreNew = false;
}

osg::BoundingBox CViewScene::bounds() const {
    osg::BoundingBox box;
    for (const CTreeNode* tree : standing()) box.expandBy(tree->bounds());
    return box;
}

std::vector<osg::Vec3f> CViewScene::outline() const {
    std::vector<osg::Vec3f> points;
    for (const CTreeNode* tree : standing())
        for (const osg::Vec3f& point : outlineOf(tree->parts(), kOutlinePoints)) points.push_back(point + tree->place());
    return points;
}

/// What stands on the ground, and the shade there.
void CViewScene::updateGround() {
    osg::BoundingBox box = bounds();
    if (!box.valid()) box = kNoTree;
    m_grass->setTree(box);
    setCrown(m_state, box);
    m_person->getChild(0)->dirtyBound();
    setVector(m_state, "place", osg::Vec3(osg::Vec3d(personAt().x(), personAt().y(), 0)));
    updateLight();
}

void CViewScene::updateLight() {
    Daylight light = daylightAt(m_look.light);
    if (const auto& picture = m_look.picture; m_look.backdrop == Backdrop::Picture && picture && picture->panorama) {
        const auto strength = static_cast<float>(m_look.light.skyStrength);
        light.zenith = picture->zenith * strength;
        light.haze = picture->haze * strength;
        light.ground = picture->ground * strength;
    }
    setVector(m_state, "sun", light.sun);
    setVector(m_state, "sunlight", light.sunlight);
    setVector(m_state, "zenith", light.zenith);
    setVector(m_state, "haze", light.haze);
    setVector(m_state, "bounce", light.ground);
    setFloat(m_state, "exposure", std::exp2(m_look.light.exposure));
    osg::BoundingBox box = bounds();
    if (!box.valid()) box = kNoTree;
    if (!m_shadowsBehind) aimShadows(box);
}

void CViewScene::renewShadows() {
    if (!m_shadowsBehind) return;
    m_shadowsBehind = false;
    updateLight();
}

osg::Vec3d CViewScene::personAt() const {
    const osg::BoundingBox box = bounds();
    return {box.valid() ? box.xMin() - 0.6 : -1.5, 0, kPersonHeight};
}

} // namespace stromar
