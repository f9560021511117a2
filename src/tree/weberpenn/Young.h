#pragma once
#include "Grown.h"
#include "stromar/util/Progress.h"

namespace stromar {

/// Moves what sits on a stem that is not where it will be: the crown of a palm travels with the tip of its trunk.
struct Carriage {
    glm::dmat3 turn = glm::dmat3(1.0);
    glm::dvec3 from{0}, to{0};

    glm::dvec3 place(const glm::dvec3& p) const { return turn * (p - from) + to; }
    Frame frame(const Frame& f) const { return turn * f; }
};

constexpr std::uint32_t kUnborn = ~0u; ///< in place of a stem

/// Stems of a grown generation at an age: those that are born, cut where their tips have come.
struct CYoungGeneration : CGeneration {
    std::shared_ptr<const CGrownGeneration> grown;
    std::vector<std::uint32_t> origin; ///< by stem: in the grown generation
    std::vector<Carriage> carriage;    ///< by stem
    double age = 1, grownHeight = 0;   ///< of the tree
};

/// The grown tree at an age between 0 and 1. Wood never moves along its parent: a younger stem is the grown one, cut.
/// Throws CCancelled.
std::vector<std::shared_ptr<const CYoungGeneration>> youngGenerations(const CParams& params, const CTree& grown, double age,
                                                                      const CProgress& progress);

} // namespace stromar
