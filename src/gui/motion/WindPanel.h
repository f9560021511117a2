#pragma once
#include "stromar/tree/Wind.h"
#include <QWidget>
#include <functional>
#include <vector>

class QCheckBox;
class QLabel;
class QSlider;

namespace stromar {

class CParamSlider;

/// The wind over the tree in the window: a switch, presets, a slider for each row of a table; and the tree's own
/// flexibility. The wind belongs to the view and is kept between runs; the flexibility belongs to the tree.
class CWindPanel : public QWidget {
    Q_OBJECT
public:
    explicit CWindPanel(QWidget* parent = nullptr);

    bool blowing() const;
    void setBlowing(bool on);
    Wind wind() const;
    double direction() const; ///< degrees, as windDirection() has them
    void setDirection(double degrees);
    /// Of the document.
    void showFlexibility(double flexibility);
    bool held() const;

signals:
    void changed();
    void switched(bool on);
    void flexibilityEdited(double flexibility, int gesture);
    void released();

private:
    struct Row;
    struct Preset;
    static const Row kRows[];
    static const Preset kPresets[];

    void addRow(const Row& row);
    void switchOnWith(QSlider* slider);
    void addFlexibility();
    double value(std::size_t row) const;
    void setValue(std::size_t row, double value);

    QCheckBox* m_switch;
    std::vector<CParamSlider*> m_sliders; ///< by row
    CParamSlider* m_flexibility;
    QLabel* m_flexibilityLabel;
    int m_gesture = 0;
};

} // namespace stromar
