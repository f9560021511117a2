#include "stromar/params/ParamTable.h"
#include "CommonTable.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>

namespace stromar {

namespace {
std::vector<const ParamBlock*>& knownBlocks() {
    static std::vector<const ParamBlock*> blocks{&weberPennBlock()};
    return blocks;
}

/// The rows of one page, in the order of their tables.
std::vector<ParamRef> refsOf(const ParamBlock& block, const Group& group, int level) {
    std::vector<ParamRef> refs;
    enum class Only { All, Pictures, Words };
    const auto add = [&](std::span<const ParamInfo> rows, Only only = Only::All) {
        for (const ParamInfo& p : rows) {
            if (only != Only::All && p.picture() != (only == Only::Pictures)) continue;
            const bool ofLevel = p.perLevel() && level >= p.firstLevel && (group == Group::Trunk || p.group == group);
            const bool ofTree = !p.perLevel() && p.group == group;
            if (ofLevel || ofTree) refs.push_back({&p, p.perLevel() ? level : 0});
        }
    };
    add(commonTexts(), Only::Pictures);
    add(block.rows);
    add(commonNumbers());
    add(commonTexts(), Only::Words);
    return refs;
}

/// Rows of one section stand together, where its first does.
void gatherSections(std::vector<ParamRef>& refs) {
    std::vector<std::string_view> sections;
    for (const ParamRef& ref : refs)
        if (std::ranges::find(sections, ref.info->section) == sections.end()) sections.push_back(ref.info->section);
    std::ranges::stable_sort(refs, {}, [&](const ParamRef& ref) {
        return std::ranges::find(sections, ref.info->section) - sections.begin();
    });
}

/// All that is asked of a method's table again and again.
struct Layout {
    std::vector<ParamPage> pages;
    std::vector<ParamRef> all, numbers;

    explicit Layout(const ParamBlock& block) {
        for (const Group& group : block.groups) addPages(block, group);
        for (const ParamPage& page : pages) all.insert(all.end(), page.rows.begin(), page.rows.end());
        std::ranges::copy_if(all, std::back_inserter(numbers), [](const ParamRef& ref) { return ref.info->numeric(); });
    }

private:
    void addPages(const ParamBlock& block, const Group& group) {
        const bool levels = std::ranges::any_of(
            block.rows, [&](const ParamInfo& p) { return p.perLevel() && p.group == group; });
        for (int level = levels ? 1 : 0; level < (levels ? kParamLevels : 1); ++level) {
            ParamPage page{group, level, refsOf(block, group, level)};
            gatherSections(page.rows);
            if (!page.rows.empty()) pages.push_back(std::move(page));
        }
    }
};

const Layout& layoutOf(const ParamBlock& block) {
    static std::mutex mutex;
    static std::map<const ParamBlock*, std::unique_ptr<const Layout>> layouts;
    const std::lock_guard lock(mutex);
    std::unique_ptr<const Layout>& layout = layouts[&block];
    if (!layout) layout = std::make_unique<const Layout>(block);
    return *layout;
}

/// A curve inside the row's ranges.
CCurve clamped(const ParamInfo& info, const CCurve& curve) {
    std::vector<CCurve::Point> points;
    for (const auto& [x, y] : curve.points()) {
        const CCurve::Point point{std::clamp(x, info.over.min, info.over.max), std::clamp(y, info.range.min, info.range.max)};
        if (!points.empty() && point.x <= points.back().x)
            points.back().y = point.y;
        else
            points.push_back(point);
    }
    return CCurve(std::move(points));
}

double clamped(const ParamInfo& info, double value) {
    const double allowed = std::clamp(value, info.range.min, info.range.max);
    return info.integer() ? std::round(allowed) : allowed;
}
} // namespace

CParams::CParams() : CParams(weberPennBlock()) {}

CParams::CParams(const ParamBlock& block) : m_block(&block), m_values(block.make()) {
    for (const ParamRef& ref : allParams(block)) ref.setValue(*this, defaultOf(ref, block));
    text.species = "default";
}

bool CParams::operator==(const CParams& other) const {
    return m_block == other.m_block && common == other.common && text == other.text &&
           m_block->equal(m_values, other.m_values);
}

double ParamInfo::get(const CParams& params, int level) const {
    const void* place = field.at(params, level);
    switch (field.type) {
    case ParamField::Type::Integer: return *static_cast<const int*>(place);
    case ParamField::Type::Angle: return static_cast<const Degrees*>(place)->value;
    default: assert(numeric()); return *static_cast<const double*>(place);
    }
}

bool ParamInfo::set(CParams& params, double value, int level) const {
    const double allowed = clamped(*this, value);
    void* place = const_cast<void*>(field.at(params, level));
    switch (field.type) {
    case ParamField::Type::Integer: *static_cast<int*>(place) = static_cast<int>(allowed); break;
    case ParamField::Type::Angle: static_cast<Degrees*>(place)->value = allowed; break;
    default: assert(numeric()); *static_cast<double*>(place) = allowed;
    }
    return allowed == value;
}

std::string ParamInfo::keyOf(int level) const {
    return (perLevel() ? std::to_string(level) : std::string()) + std::string(key);
}

ParamValue ParamRef::value(const CParams& params) const {
    switch (info->kind()) {
    case ParamKind::Curve: return curve(params);
    case ParamKind::Text: return text(params);
    default: return get(params);
    }
}

bool ParamRef::differs(const CParams& a, const CParams& b) const {
    switch (info->kind()) {
    case ParamKind::Curve: return curve(a) != curve(b);
    case ParamKind::Text: return text(a) != text(b);
    default: return get(a) != get(b);
    }
}

bool ParamRef::setValue(CParams& params, const ParamValue& value) const {
    void* place = const_cast<void*>(info->field.at(params, level));
    if (const auto* number = std::get_if<double>(&value)) return set(params, *number);
    if (const auto* words = std::get_if<std::string>(&value)) {
        assert(info->kind() == ParamKind::Text);
        *static_cast<std::string*>(place) = *words;
        return true;
    }
    assert(info->kind() == ParamKind::Curve);
    const CCurve& wanted = std::get<CCurve>(value);
    CCurve allowed = clamped(*info, wanted);
    const bool same = allowed == wanted;
    *static_cast<CCurve*>(place) = std::move(allowed);
    return same;
}

std::span<const ParamBlock* const> paramBlocks() { return knownBlocks(); }

void registerBlock(const ParamBlock& block) {
    if (std::ranges::find(knownBlocks(), &block) == knownBlocks().end()) knownBlocks().push_back(&block);
}

const ParamBlock* blockNamed(std::string_view method) {
    const auto found = std::ranges::find(knownBlocks(), method, &ParamBlock::method);
    return found == knownBlocks().end() ? nullptr : *found;
}

std::span<const ParamPage> pagesOf(const ParamBlock& block) { return layoutOf(block).pages; }
std::span<const ParamRef> allParams(const ParamBlock& block) { return layoutOf(block).all; }
std::span<const ParamRef> numberParams(const ParamBlock& block) { return layoutOf(block).numbers; }

std::vector<const ParamInfo*> rowsOf(const ParamBlock& block) {
    std::vector<const ParamInfo*> rows;
    for (const std::span<const ParamInfo> table : {commonTexts(), block.rows, commonNumbers()})
        for (const ParamInfo& row : table) rows.push_back(&row);
    return rows;
}

ParamValue defaultOf(const ParamRef& ref, const ParamBlock& block) {
    const ParamInfo& info = *ref.info;
    if (info.kind() == ParamKind::Text) return std::string(info.defaultText);
    if (info.kind() == ParamKind::Curve) {
        CCurve::Fault fault;
        const auto curve = CCurve::parse(info.defaultText, fault);
        assert(curve);
        return *curve;
    }
    const auto own = std::ranges::find(block.commonDefaults, info.key, &CommonDefault::key);
    if (own != block.commonDefaults.end() && !info.perLevel()) return own->value;
    return info.defaults[static_cast<std::size_t>(info.perLevel() ? ref.level : 0)];
}

const ParamInfo* variationOf(const ParamInfo& info) {
    const auto isVariation = [&](const ParamInfo* p) {
        return p->perLevel() == info.perLevel() && p->key.size() == info.key.size() + 1 && p->key.starts_with(info.key) &&
               p->key.ends_with('V') && p->numeric();
    };
    for (const ParamBlock* block : knownBlocks()) {
        const std::vector<const ParamInfo*> rows = rowsOf(*block);
        if (std::ranges::find(rows, &info) == rows.end()) continue;
        if (const auto found = std::ranges::find_if(rows, isVariation); found != rows.end()) return *found;
    }
    return nullptr;
}

std::string_view inactiveReason(const ParamRef& ref, const CParams& params) {
    const ParamBlock& block = params.block();
    const std::string_view why = block.inactive ? block.inactive(ref, params) : std::string_view();
    if (!why.empty() || !ref.info->inactive) return why;
    return ref.info->inactive(params, ref.level);
}

bool hasBlossoms(const CParams& params) {
    return params.common.blossoms > 0 || (params.block().hasBlossoms && params.block().hasBlossoms(params));
}

bool hasFruits(const CParams& params) {
    return params.common.fruits > 0 || (params.block().hasFruits && params.block().hasFruits(params));
}

std::string_view unitName(Unit unit) {
    constexpr std::string_view kNames[] = {"", "m", "°"};
    return kNames[static_cast<std::size_t>(unit)];
}

} // namespace stromar
