#include "stromar/scene/NeighbourBarks.h"
#include "stromar/model/BarkLevels.h"
#include "stromar/model/Material.h"
#include "stromar/scene/SurfaceMaps.h"
#include <algorithm>

namespace stromar {

namespace {
/// A picture of a neighbour: where its own surface has it, and where each of the neighbours shows it.
struct SharedPicture {
    unsigned own;
    struct {
        const char* name;
        unsigned unit;
    } shared[2];
};
constexpr SharedPicture kShared[] = {{kAlbedoUnit, {{"olderPicture", 7}, {"youngerPicture", 8}}},
                                     {kReliefUnit, {{"olderRelief", 9}, {"youngerRelief", 10}}},
                                     {kGlossUnit, {{"olderGloss", 11}, {"youngerGloss", 12}}}};

/// From stems of one level to those of another.
NeighbourBark between(const CBarkLevels& levels, std::size_t own, std::size_t other, Surface surface) {
    if (!levels.isApart(own, other)) return {};
    const float from = static_cast<float>(levels.thinness(own)) / 255, to = static_cast<float>(levels.thinness(other)) / 255;
    return {surface, from, 1 / (to - from)};
}
} // namespace

NeighbourBarks neighbourBarksOf(const TreeModel& model, Surface bark) {
    const CBarkLevels levels(*model.tree);
    if (levels.count() == 0) return {};
    const auto first = static_cast<std::size_t>(std::ranges::find(kBarks, bark) - kBarks.begin());
    std::size_t last = first;
    while (last + 1 < levels.count() && shownSurface(model.params, kBarks[last + 1]) == bark) ++last;
    NeighbourBarks barks;
    if (first > 0) barks[0] = between(levels, first, first - 1, shownSurface(model.params, kBarks[first - 1]));
    if (last + 1 < levels.count()) barks[1] = between(levels, last, last + 1, kBarks[last + 1]);
    return barks;
}

void setNeighbours(osg::StateSet& state, const NeighbourBarks& barks) {
    const auto set = [&](const char* name, float older, float younger) {
        state.getOrCreateUniform(name, osg::Uniform::FLOAT_VEC2)->set(osg::Vec2(older, younger));
    };
    set("neighbourFrom", barks[0].from, barks[1].from);
    set("neighbourRate", barks[0].rate, barks[1].rate);
}

void nameNeighbourPictures(osg::StateSet& state) {
    for (const SharedPicture& picture : kShared)
        for (const auto& shared : picture.shared)
            state.getOrCreateUniform(shared.name, osg::Uniform::INT)->set(static_cast<int>(shared.unit));
}

void shareSurface(osg::StateSet& state, std::size_t neighbour, const osg::StateSet& shown) {
    constexpr auto kTexture = osg::StateAttribute::TEXTURE;
    for (const SharedPicture& picture : kShared)
        if (const osg::StateAttribute* texture = shown.getTextureAttribute(picture.own, kTexture))
            state.setTextureAttributeAndModes(picture.shared[neighbour].unit, const_cast<osg::StateAttribute*>(texture));
}

} // namespace stromar
