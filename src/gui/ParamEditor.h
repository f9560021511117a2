#pragma once
#include "stromar/params/ParamTable.h"
#include <QWidget>

class QAbstractSpinBox;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSlider;
class QSpinBox;

namespace stromar {

/// The editor of one value, made from its row of the parameter table: slider and spin box, a choice, or a switch.
/// The wheel changes it only while it has the focus.
class CParamEditor : public QWidget {
    Q_OBJECT
public:
    explicit CParamEditor(const ParamRef& ref, QWidget* parent = nullptr);

    const ParamRef& ref() const { return m_ref; }
    /// Shows a value without telling.
    void showValue(double value);
    /// Whether the slider is held.
    bool held() const;

signals:
    /// The user set a value. All changes of one drag have the same positive gesture; 0 stands alone.
    void edited(const stromar::ParamRef& ref, double value, int gesture);
    void released();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addChoice();
    void addSwitch();
    void addSeed();
    void addSliderAndBox();
    QAbstractSpinBox* makeBox();
    void guardWheel(QWidget* editor);
    int sliderPosition(double value) const;
    double sliderValue(int position) const;
    void onBox(double value);
    void onSlider(int position);

    ParamRef m_ref;
    QComboBox* m_choice = nullptr;
    QCheckBox* m_switch = nullptr;
    QSlider* m_slider = nullptr;
    QDoubleSpinBox* m_real = nullptr;
    QSpinBox* m_whole = nullptr;
    int m_gesture = 0;
};

} // namespace stromar
