#pragma once
#include "stromar/params/ParamTable.h"
#include <span>
#include <string_view>

namespace stromar {

/// What light a picture is taken in. It belongs to the view, not to the tree.
struct Light {
    double hour = 10;   ///< of the day, 0..24: where the sun stands
    double sunTurn = 0; ///< turns its way about the tree, degrees
    double sunStrength = 1, skyStrength = 1;
    double sunTemperature = 5500, skyTemperature = 6500; ///< kelvin: colours; these tint nothing
    double exposure = 0;                                 ///< stops

    bool operator==(const Light&) const = default;
};

/// One row of the table of lights: sliders of the window and flags of the command line are loops over it.
struct LightRow {
    enum class Kind { Time, Degrees, Share, Kelvin, Stops };

    std::string_view key;  ///< in the settings, and the slider's objectName
    std::string_view flag; ///< of the command line
    std::string_view label, help;
    double Light::*field;
    Kind kind;
    Range range;  ///< what is accepted
    Range useful; ///< what a slider reaches
    double step;
};
std::span<const LightRow> lightTable();

} // namespace stromar
