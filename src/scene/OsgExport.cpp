#include "stromar/scene/OsgExport.h"
#include "stromar/scene/OsgGeometry.h"
#include "stromar/texture/Opacity.h"
#include <algorithm>
#include <cfloat>
#include <osg/AlphaFunc>
#include <osg/Group>
#include <osg/LOD>
#include <osg/Material>
#include <osg/Texture2D>
#include <osgDB/Registry>

namespace stromar {

namespace {
osg::ref_ptr<osg::Texture2D> textureNamed(const std::string& file) {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->setFileName(file);
    image->setWriteHint(osg::Image::EXTERNAL_FILE);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    return texture;
}

/// Fixed-function state that every viewer of these files shows.
osg::ref_ptr<osg::StateSet> stateOf(const Material& look) {
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setName(look.name);
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setName(look.name);
    const glm::vec3 colour = look.texture.empty() ? look.colour : glm::vec3(1);
    material->setDiffuse(osg::Material::FRONT_AND_BACK, {colour.x, colour.y, colour.z, 1});
    material->setAmbient(osg::Material::FRONT_AND_BACK, {0.5f * colour.x, 0.5f * colour.y, 0.5f * colour.z, 1});
    state->setAttributeAndModes(material);
    if (!look.texture.empty()) state->setTextureAttributeAndModes(0, textureNamed(look.texture));
    if (look.cutOut) state->setAttributeAndModes(new osg::AlphaFunc(osg::AlphaFunc::GREATER, float(kAlphaCut)));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    return state;
}

using States = std::vector<osg::ref_ptr<osg::StateSet>>;

osg::ref_ptr<osg::Group> makeGroup(const ExportModel& model, const std::string& name, const Meshes& meshes,
                                   const States& states) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->setName(name);
    for (const auto& mesh : meshes) {
        osg::ref_ptr<osg::Geometry> geometry = makeGeometry(*mesh);
        geometry->setStateSet(states[model.materialIndex(*mesh)]);
        group->addChild(geometry);
    }
    return group;
}

/// Switches by the height on the screen, in pixels of an ordinary one.
osg::ref_ptr<osg::Node> makeNode(const ExportModel& model) {
    constexpr float kScreen = 1080;
    States states;
    for (const Material& look : model.materials) states.push_back(stateOf(look));
    if (model.coarser.empty()) return makeGroup(model, model.name, model.meshes, states);
    osg::ref_ptr<osg::LOD> root = new osg::LOD;
    root->setName(model.name);
    root->setRangeMode(osg::LOD::PIXEL_SIZE_ON_SCREEN);
    float high = FLT_MAX;
    for (std::size_t lod = 0; lod <= model.coarser.size(); ++lod) {
        const float low = kScreen * static_cast<float>(screenCoverage(lod, model.coarser.size() + 1));
        root->addChild(makeGroup(model, model.name + "_LOD" + std::to_string(lod),
                                 lod == 0 ? model.meshes : model.coarser[lod - 1], states),
                       low, high);
        high = low;
    }
    return root;
}
} // namespace

void writeOsg(const ExportModel& model, const std::filesystem::path& path, CFileSet& files) {
    const std::string ending = path.extension().string().substr(1);
    osgDB::ReaderWriter* writer = osgDB::Registry::instance()->getReaderWriterForExtension(ending);
    if (!writer) throw CError("OpenSceneGraph's plug-in for ." + ending + " is not installed");
    osg::ref_ptr<osgDB::Options> options = new osgDB::Options("precision 9 WriteImageHint=UseExternal");
    options->setPluginStringData("fileType", ending == "osgb" ? "Binary" : "Ascii");
    options->setPluginStringData("WriteImageHint", "UseExternal");
    std::ostream& out = files.create(path);
    const auto result = writer->writeNode(*makeNode(model), out, options.get());
    if (!result.success()) throw CError("OpenSceneGraph cannot write " + path.string() + ": " + result.message());
    // A writer that says it is done may have written nothing: no format takes less than two bytes a coordinate.
    if (files.bytes() + 65536 < 6 * model.vertexCount())
        throw CError("OpenSceneGraph wrote " + path.string() + " incompletely");
}

} // namespace stromar
