#pragma once
#include "stromar/params/ParamTable.h"
#include <osg/Vec2d>
#include <span>
#include <vector>

namespace stromar {

/// What is drawn around the tree while parameters of its outline are edited.
enum class Guide { None, Crown, Envelope };

/// The guide that belongs to a value.
Guide guideOf(const ParamRef& ref);

/// Distance from the trunk's axis and height, metres, from bottom to top.
std::vector<osg::Vec2d> guideProfile(Guide guide, const CParams& params, double scaleTree);

/// A point of a guide that can be dragged.
struct GuideHandle {
    Guide guide;
    const char* text; ///< marked for translation
    /// Distance from the axis and height, metres.
    osg::Vec2d (*place)(const CParams&, double scaleTree);
    /// Sets the values so that the handle comes as near as it can to a place.
    void (*drag)(CParams&, double scaleTree, const osg::Vec2d& to);
};

std::span<const GuideHandle> guideHandles();

} // namespace stromar
