#pragma once
#include "stromar/params/ParamTable.h"
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace stromar {

/// A point of a guide that can be dragged.
struct GuideHandle {
    const char* text; ///< marked for translation
    /// Distance from the axis and height, metres.
    glm::dvec2 (*place)(const CParams&, double treeHeight);
    /// Sets the values so that the handle comes as near as it can to a place.
    void (*drag)(CParams&, double treeHeight, const glm::dvec2& to);
};

/// What is drawn around the tree while values of its outline are edited.
struct Guide {
    /// Distance from the trunk's axis and height, metres, from bottom to top.
    std::vector<glm::dvec2> (*profile)(const CParams&, double treeHeight);
    std::span<const GuideHandle> handles;
    bool (*belongsTo)(const ParamRef&); ///< shown while such a value is in hand
    Group group{};                      ///< and while this tab is open
};

} // namespace stromar
