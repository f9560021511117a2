#pragma once
#include "stromar/mesh/twig/CutOut.h"
#include "stromar/mesh/twig/Twig.h"
#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace stromar {

/// What the card of a twig shows at a place, from the front, as its picture does.
class CTwigMask {
public:
    explicit CTwigMask(const Twig& twig);

    static constexpr int kSide = CCutOut::kSide;

    struct Texel {
        glm::vec3 normal{0}; ///< right, along, to the viewer; nothing: there is a gap
        bool back = false;   ///< of a leaf
        bool wood = false;
    };
    /// Normals are the mean over 2^level texels each way, as in smaller pictures.
    Texel at(const glm::vec2& texCoord, int level) const;
    /// Whether there is a leaf or wood.
    bool shows(const glm::vec2& texCoord) const;
    /// Where there is, softer in smaller pictures.
    const CCutOut& cutOut() const { return m_cutOut; }

private:
    static constexpr int kLevels = 8;

    template <typename Visit> static void draw(const CMesh& mesh, const Twig& twig, Visit&& visit);
    void drawLeaves(const Twig& twig, std::vector<float>& depths);
    void drawWood(const Twig& twig, std::vector<float>& depths);
    void drawOutline();
    void averageNormals();

    std::vector<Texel> m_texels;
    CCutOut m_cutOut;
    std::array<std::vector<glm::vec3>, kLevels> m_means; ///< of normals, by level
};

} // namespace stromar
