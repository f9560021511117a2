#include "params/DefineSlider.h"
#include "params/ClampingBox.h"
#include "params/ParamSlider.h"
#include "window/QtText.h"
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr int kSteps = 100;
constexpr int kMaxDecimals = 6;

/// To whole steps of a power of ten, without a tail of digits.
double rounded(double value, double step) {
    const double perUnit = std::round(1 / step);
    return step < 1 ? std::round(value * perUnit) / perUnit : std::round(value / step) * step;
}
} // namespace

CDefineSlider::CDefineSlider(QWidget* parent)
    : QWidget(parent), m_label(new QLabel), m_bar(new CParamSlider(kSteps)), m_box(new CClampingBox<QDoubleSpinBox>) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(20, 0, 0, 0);
    m_label->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("contraction")));
    m_box->setKeyboardTracking(false);
    m_box->setRange(-1e9, 1e9);
    m_box->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("−000.0000")) + 24);
    m_bar->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(m_label);
    row->addWidget(m_bar, 1);
    row->addWidget(m_box);
    connect(m_bar, &QSlider::valueChanged, this, [this](int position) {
        const double raw = m_slider.low + (m_slider.high - m_slider.low) * position / m_bar->maximum();
        const bool fine = position % CParamSlider::kFinePerStep != 0;
        emit moved(rounded(raw, fine ? step() / 10 : step()));
    });
    connect(m_bar, &QSlider::sliderReleased, this, &CDefineSlider::released);
    connect(m_box, &QDoubleSpinBox::valueChanged, this, &CDefineSlider::moved);
}

/// Numbers one can remember: a power of ten, at most a hundredth of the range.
double CDefineSlider::step() const { return std::pow(10, std::floor(std::log10((m_slider.high - m_slider.low) / kSteps * 1.0001))); }

void CDefineSlider::show(const TextLanguage::Slider& slider) {
    m_slider = slider;
    m_label->setText(toQString(slider.name));
    m_label->setToolTip(toQString(slider.words));
    m_bar->setAccessibleName(toQString(slider.name));
    m_bar->setToolTip(toQString(slider.words));
    m_box->setAccessibleName(toQString(slider.name));
    const QSignalBlocker quietBar(m_bar), quietBox(m_box);
    const double share = (std::clamp(slider.value, slider.low, slider.high) - slider.low) / (slider.high - slider.low);
    if (!m_bar->isSliderDown()) m_bar->setValue(static_cast<int>(std::lround(share * m_bar->maximum())));
    m_box->setDecimals(std::clamp(static_cast<int>(-std::floor(std::log10(step()))) + 1, 0, kMaxDecimals));
    m_box->setSingleStep(step());
    m_box->setValue(slider.value);
}

bool CDefineSlider::held() const { return m_bar->isSliderDown(); }

} // namespace stromar
