#include "stromar/model/Light.h"
#include "stromar/util/Translatable.h"

namespace stromar {

namespace {
using Kind = LightRow::Kind;

// clang-format off
constexpr LightRow kRows[] = {
    {"hour", "--hour", N_("Time of day"), N_("Where the sun stands: low and red in the morning and in the evening."),
     &Light::hour, Kind::Time, {0, 24}, {5, 20}, 0.25},
    {"sunTurn", "--sun-direction", N_("Sun direction"), N_("Turns the sun's way about the tree."),
     &Light::sunTurn, Kind::Degrees, {-360, 360}, {-180, 180}, 5},
    {"sunStrength", "--sun-strength", N_("Sun strength"), N_("0 is an overcast day without shadows, 1 a clear one."),
     &Light::sunStrength, Kind::Share, {0, 10}, {0, 2}, 0.05},
    {"sunTemperature", "--sun-temperature", N_("Sun colour"), N_("The colour of its light: low is warm and red, high is cold and blue."),
     &Light::sunTemperature, Kind::Kelvin, {1500, 20000}, {2500, 9500}, 100},
    {"skyStrength", "--sky-strength", N_("Sky strength"), N_("How bright the sky is: what lights the shadows."),
     &Light::skyStrength, Kind::Share, {0, 10}, {0, 2}, 0.05},
    {"skyTemperature", "--sky-temperature", N_("Sky colour"), N_("The colour of the sky: low is warm, high is blue."),
     &Light::skyTemperature, Kind::Kelvin, {1500, 20000}, {2500, 12500}, 100},
    {"exposure", "--exposure", N_("Exposure"), N_("Makes the whole picture brighter or darker: each stop doubles the light."),
     &Light::exposure, Kind::Stops, {-10, 10}, {-3, 3}, 0.25},
};
// clang-format on
} // namespace

std::span<const LightRow> lightTable() { return kRows; }

} // namespace stromar
