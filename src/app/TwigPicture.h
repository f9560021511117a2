#pragma once
#include "stromar/mesh/twig/Twig.h"
#include "stromar/texture/TextureMaps.h"
#include <array>
#include <filesystem>

namespace stromar {

/// What a picture of a twig is made of.
struct TwigSource {
    std::array<std::filesystem::path, kLeafKinds> leaves; ///< pictures, by kind
    std::filesystem::path bark; ///< picture; of a bark that is no PNG only `plainBark` is seen
    glm::vec3 plainBark;              ///< 0..1
    std::filesystem::path blossom;    ///< picture
    double sunAndShade = 0;           ///< LeafSunShade
};

/// Other twigs, sources and sizes give others, and so do newer files of the same name. Measures how the crown looks, if nobody has. Throws CCancelled.
std::uint64_t twigHash(const Twig& twig, const TwigSource& source, const CProgress& progress);

/// Draws a twig with all maps. Some tenths of a second; uses one thread. Throws CError when the leaf's picture cannot
/// be read, and CCancelled.
TextureMaps drawTwig(const Twig& twig, const TwigSource& source, const CProgress& progress);

} // namespace stromar
