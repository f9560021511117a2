// Loads a model through osgDB and prints what it found as JSON.
#include <iostream>
#include <nlohmann/json.hpp>
#include <osg/Geometry>
#include <osg/Material>
#include <osg/NodeVisitor>
#include <osg/Notify>
#include <osg/Texture2D>
#include <osg/Transform>
#include <osg/TriangleFunctor>
#include <osgDB/ReadFile>
#include <set>

namespace {
struct Triangles {
    std::vector<osg::Vec3> corners;
    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false) {
        if (a == b || b == c || c == a) return; // the joints of strips
        for (const osg::Vec3& p : {a, b, c}) corners.push_back(p);
    }
};

class CCollector : public osg::NodeVisitor {
public:
    CCollector() : NodeVisitor(TRAVERSE_ALL_CHILDREN) {}

    void apply(osg::Node& node) override {
        const std::string outer = m_material;
        look(node.getStateSet());
        traverse(node);
        m_material = outer;
    }
    void apply(osg::Drawable& drawable) override {
        const std::string outer = m_material;
        look(drawable.getStateSet());
        if (osg::Geometry* geometry = drawable.asGeometry()) add(*geometry);
        m_material = outer;
    }

    nlohmann::json result() const {
        const auto list = [](const osg::Vec3& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
        return {{"triangles", m_triangles},
                {"min", list(m_box._min)},
                {"max", list(m_box._max)},
                {"bark_volume", m_volume},
                {"materials", m_materials},
                {"textures", m_textures},
                {"maps", m_maps},
                {"normals", m_normals},
                {"colours", m_colours},
                {"attributes", m_attributes},
                {"transparent", m_transparent},
                {"tex_min", {m_texBox._min.x(), m_texBox._min.y()}},
                {"tex_max", {m_texBox._max.x(), m_texBox._max.y()}}};
    }

private:
    void look(osg::StateSet* state) {
        if (!state) return;
        if (const auto* material = dynamic_cast<osg::Material*>(state->getAttribute(osg::StateAttribute::MATERIAL))) {
            m_material = material->getName();
            m_materials.insert(m_material);
        }
        const auto* texture = dynamic_cast<osg::Texture*>(state->getTextureAttribute(0, osg::StateAttribute::TEXTURE));
        for (unsigned unit = 1; unit < state->getNumTextureAttributeLists(); ++unit) m_maps += state->getTextureAttribute(unit, osg::StateAttribute::TEXTURE) ? 1 : 0;
        m_transparent = m_transparent || state->getAttribute(osg::StateAttribute::ALPHAFUNC) || state->getAttribute(osg::StateAttribute::BLENDFUNC);
        if (texture && texture->getImage(0)) m_textures.insert(texture->getImage(0)->getFileName());
    }
    void add(osg::Geometry& geometry) {
        const osg::Matrix place = osg::computeLocalToWorld(getNodePath());
        osg::TriangleFunctor<Triangles> triangles;
        geometry.accept(triangles);
        m_triangles += triangles.corners.size() / 3;
        for (osg::Vec3& p : triangles.corners) m_box.expandBy(p = p * place);
        for (std::size_t i = 0; m_material == "bark" && i + 2 < triangles.corners.size(); i += 3) {
            const osg::Vec3d a(triangles.corners[i]), b(triangles.corners[i + 1]), c(triangles.corners[i + 2]);
            m_volume += a * (b ^ c) / 6;
        }
        m_normals = m_normals && geometry.getNormalArray() && geometry.getNormalArray()->getBinding() == osg::Array::BIND_PER_VERTEX;
        m_colours = m_colours || (geometry.getColorArray() && geometry.getColorArray()->getBinding() == osg::Array::BIND_PER_VERTEX);
        m_attributes += geometry.getNumVertexAttribArrays();
        if (const auto* coords = dynamic_cast<osg::Vec2Array*>(geometry.getTexCoordArray(0)))
            for (const osg::Vec2& t : *coords) m_texBox.expandBy(t.x(), t.y(), 0);
    }

    std::size_t m_triangles = 0, m_maps = 0, m_attributes = 0; ///< pictures beyond the first; what vertices carry besides
    bool m_normals = true, m_colours = false, m_transparent = false;
    osg::BoundingBox m_box, m_texBox;
    double m_volume = 0;
    std::string m_material;
    std::set<std::string> m_materials, m_textures;
};
} // namespace

int main(int argc, char** argv) {
    osg::setNotifyLevel(osg::WARN); // its readers print what they leave out among the numbers
    // Some readers make strips of what they read, which takes more than a minute for a tree and changes no triangle.
    const osg::ref_ptr<osgDB::Options> options = new osgDB::Options("noTriStripPolygons");
    const osg::ref_ptr<osg::Node> node = argc == 2 ? osgDB::readRefNodeFile(argv[1], options.get()) : nullptr;
    if (!node) return 1;
    CCollector collector;
    node->accept(collector);
    nlohmann::json result = collector.result();
    result["root"] = node->className();
    std::cout << result.dump(2) << "\n";
    return std::cout.flush() ? 0 : 1;
}
