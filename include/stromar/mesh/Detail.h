#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace stromar {

enum class Model { Simple, Full };

/// How finely a model is drawn: one row of the table of models and levels of detail.
struct Detail {
    std::string_view name; ///< for people
    Model model;
    int lod;                       ///< 0..3, of the full model
    std::array<int, 4> ringPoints; ///< points of a ring by generation; deeper ones use the last
    int smoothGenerations;         ///< the first so many get rings between their segments' ends
    int collarRings;               ///< between a parent's surface and a branch's own rings
    double leafShare;              ///< part of the leaves that is drawn; they grow to make up for it
    std::size_t leafBudget;        ///< and never more than so many
};

constexpr double kMostLeafGrowth = 2; ///< thinned leaves grow at most to this times their length

std::span<const Detail> detailTable();
/// lod 0..3; the simple model has only 0.
const Detail& detailOf(Model model, int lod = 0);

} // namespace stromar
