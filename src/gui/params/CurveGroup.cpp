#include "params/CurveGroup.h"
#include "params/CurveEditor.h"
#include <algorithm>

namespace stromar {

namespace {
/// Seen on light and dark, and told apart without red and green.
constexpr QRgb kColours[] = {0xff2f7ed8, 0xffd8792f, 0xff3aa675, 0xffb54fc0, 0xffc9a227, 0xff6b7bd6, 0xffcf4a63};
} // namespace

CCurveGroup::CCurveGroup(std::vector<CCurveEditor*> curves, QObject* parent) : QObject(parent), m_curves(std::move(curves)) {
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        CCurveEditor* curve = m_curves[i];
        curve->setColour(QColor(kColours[i % std::size(kColours)]));
        connect(curve, &CCurveEditor::unfoldWanted, this, [this, curve] { unfold(curve); });
        connect(curve, &CCurveEditor::shown, this, &CCurveGroup::update);
        connect(curve, &CCurveEditor::edited, this, &CCurveGroup::update);
    }
    unfold(m_curves.front());
}

void CCurveGroup::unfold(const CCurveEditor* curve) {
    for (CCurveEditor* one : m_curves) one->setFolded(one != curve);
    update();
}

void CCurveGroup::update() {
    Range covered = m_curves.front()->info().useful;
    for (const CCurveEditor* one : m_curves)
        covered = {std::min(covered.min, one->info().useful.min), std::max(covered.max, one->info().useful.max)};
    for (CCurveEditor* curve : m_curves) {
        std::vector<CCurveEditor::Beside> others;
        for (const CCurveEditor* other : m_curves)
            if (other != curve && other->axis().label == curve->axis().label) others.push_back({other->curve(), other->colour()});
        curve->showBeside(std::move(others), covered);
    }
}

} // namespace stromar
