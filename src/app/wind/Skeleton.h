#pragma once
#include "Arrangement.h"
#include "wind/StemChoice.h"
#include "stromar/app/Motion.h"
#include "stromar/model/ExportModel.h"

namespace stromar {

/// Joints for some of the stems, and clips that move them. A joint stands for its whole stem: a stiff piece in place of
/// an arc, which turns half as far.
class CSkeleton {
public:
    /// With `fall`, what is above its cut hangs on a joint at the hinge. All are of the same tree and outlive this.
    CSkeleton(const CWindTable& table, std::size_t count, const CFall* fall);

    /// Joint 0 is the ground; the stems' come last.
    int jointOf(std::uint32_t stem, const SwayPlace& place) const;
    std::vector<Joint> joints(const Arrangement& to) const;

    /// A loop. At most 6,000 keys.
    Clip wind(const Motion& motion, const Arrangement& to) const;
    /// Likewise.
    Clip fall(double fps, const Arrangement& to) const;
    /// Each stem as large as it is by then; those that wait for their parent's tip are seeds.
    Clip growth() const;

private:
    const WindStem& stemOf(std::size_t bone) const { return m_table.stems()[m_choice.leaders()[bone]]; }
    std::size_t jointCount() const { return m_choice.leaders().size() + m_roots; }
    bool stands(std::uint32_t stem) const;
    Clip emptyClip(const char* name) const;
    double maturity(const WindStem& stem, double age) const;

    const CWindTable& m_table;
    const CFall* m_fall;
    std::size_t m_roots; ///< joints in front of the stems'
    CStemChoice m_choice;
};

} // namespace stromar
