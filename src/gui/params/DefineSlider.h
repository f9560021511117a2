#pragma once
#include "stromar/app/TextLanguage.h"
#include <QWidget>

class QDoubleSpinBox;
class QLabel;

namespace stromar {

class CParamSlider;

/// A slider and a box for a number that a text defines.
class CDefineSlider : public QWidget {
    Q_OBJECT
public:
    explicit CDefineSlider(QWidget* parent = nullptr);

    /// Without telling.
    void show(const TextLanguage::Slider& slider);
    using QWidget::show;
    const std::string& name() const { return m_slider.name; }
    bool held() const;

signals:
    void moved(double value);
    void released();

private:
    double step() const;

    TextLanguage::Slider m_slider{};
    QLabel* m_label;
    CParamSlider* m_bar;
    QDoubleSpinBox* m_box;
};

} // namespace stromar
