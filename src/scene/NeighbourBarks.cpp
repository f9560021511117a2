#include "stromar/scene/NeighbourBarks.h"
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

double meanRadius(const CGeneration& generation) {
    double sum = 0;
    for (const CStem& stem : generation.stems) sum += stem.radius;
    return sum / std::max(1.0, double(generation.stems.size()));
}

/// Over the whole range of VertexLook::thinness.
float thinnessOf(const CTree& tree, std::size_t generation) {
    return static_cast<float>(stromar::thinnessOf(meanRadius(tree.generation(generation)), tree.generation(0).stems[0].radius)) / 255;
}

/// From stems of one generation to those of another.
NeighbourBark between(const CTree& tree, std::size_t own, std::size_t other, Surface surface) {
    const float from = thinnessOf(tree, own), to = thinnessOf(tree, other);
    const bool apart = other > own ? to > from : to < from;
    return apart ? NeighbourBark{surface, from, 1 / (to - from)} : NeighbourBark{};
}
} // namespace

NeighbourBarks neighbourBarksOf(const TreeModel& model, Surface bark) {
    const CTree& tree = *model.tree;
    const std::size_t levels = std::min(tree.generationCount(), kBarks.size());
    if (levels == 0 || tree.generation(0).stems.empty()) return {};
    const auto first = static_cast<std::size_t>(std::ranges::find(kBarks, bark) - kBarks.begin());
    std::size_t last = first;
    while (last + 1 < levels && shownSurface(model.params, kBarks[last + 1]) == bark) ++last;
    NeighbourBarks barks;
    if (first > 0) barks[0] = between(tree, first, first - 1, shownSurface(model.params, kBarks[first - 1]));
    if (last + 1 < levels) barks[1] = between(tree, last, last + 1, kBarks[last + 1]);
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
