#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <osg/Vec2d>
#include <span>
#include <vector>

namespace stromar {

/// One of several pictures of the same view, whose mean has smooth edges and soft shadows. The first is the plain one.
struct ViewPass {
    osg::Vec2d pixel{0, 0}; ///< shifted by so much, −0.5..0.5
    osg::Vec2d sun{0, 0};   ///< where on the sun's disc its light comes from, within the unit circle
    double pattern = 0;     ///< of the shadows' noise, 0..1
    /// At most so many of a kind of organ, enlarged to stand for all.
    std::size_t organVertices = std::numeric_limits<std::size_t>::max();
    bool standIn = false; ///< what CViewScene::setStandIn() got in place of the tree, in still air
    bool sunDisc = false; ///< of many, where shadows of thin wood need no help
    bool alone = true; ///< no mean of several: wood thinner than a pixel is drawn as wide as one, and fainter

    /// The i-th of `count`.
    static ViewPass of(int i, int count);
};

/// The mean of pictures of one size, byte by byte.
class CPictureMean {
public:
    static constexpr int kMost = 256; ///< pictures

    int count() const { return m_count; }
    void clear() { m_count = 0; }
    /// One of another size begins anew.
    void add(std::span<const std::uint8_t> bytes);
    /// Of one picture at least; as many bytes as each had.
    void write(std::span<std::uint8_t> bytes) const;

private:
    int m_count = 0;
    std::vector<std::uint16_t> m_sums;
};

} // namespace stromar
