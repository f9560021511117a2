#pragma once
#include <QObject>
#include <vector>

namespace stromar {

class CCurveEditor;

/// The curves of one section share a picture: one is unfolded and edited, the others that run over the same are drawn
/// behind it, each in a colour of its own.
class CCurveGroup : public QObject {
    Q_OBJECT
public:
    /// At least two; their owner owns the group.
    CCurveGroup(std::vector<CCurveEditor*> curves, QObject* parent);

    void unfold(const CCurveEditor* curve);

private:
    void update();

    std::vector<CCurveEditor*> m_curves;
};

} // namespace stromar
