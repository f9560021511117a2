#include "motion/WindPanel.h"
#include "document/Gesture.h"
#include "params/ParamSlider.h"
#include "stromar/app/Motion.h"
#include "stromar/params/ParamText.h"
#include "stromar/util/Translatable.h"
#include "window/QtText.h"
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

namespace stromar {

namespace {
QString numberOf(double value) { return QLocale().toString(value, 'f', 2); }
QString degreesOf(double value) { return QStringLiteral("%1°").arg(QLocale().toString(value, 'f', 0)); }
QString percentOf(double value) { return QStringLiteral("%1 %").arg(QLocale().toString(100 * value, 'f', 0)); }

enum WindRow : std::size_t { kStrength, kDirection, kGusts };
constexpr double kFlexibilityStep = 0.05;
constexpr int kPanelWidth = 100; // pixels
} // namespace

/// One row of the table of what the wind is.
struct CWindPanel::Row {
    const char* key; ///< in the settings, and the slider's objectName
    const char* label;
    const char* help;
    double min, max, step, standard;
    QString (*text)(double);
};
const CWindPanel::Row CWindPanel::kRows[] = {
    {"windStrength", N_("Strength"), N_("1 is a strong gale, 22 m/s; beyond it is a storm."), 0, 2, 0.02, 0.45,
     numberOf},
    {"windDirection", N_("Direction"), N_("Where it blows to; the arrow in the picture can be dragged too."), -180, 180,
     5, 0, degreesOf},
    {"windGusts", N_("Gusts"), N_("How much of the strength comes and goes."), 0, 1, 0.05, 0.4, percentOf},
};

struct CWindPanel::Preset {
    const char* name;
    const char* label;
    double strength, gusts;
};
const CWindPanel::Preset CWindPanel::kPresets[] = {
    {"breeze", N_("Breeze"), 0.18, 0.3}, {"wind", N_("Wind"), 0.45, 0.4}, {"gale", N_("Gale"), 1, 0.5}};

CWindPanel::CWindPanel(QWidget* parent) : QWidget(parent), m_switch(new QCheckBox(tr("S&way in the wind"))) {
    setMinimumWidth(kPanelWidth); // other docks say how narrow the column may be
    auto* column = new QVBoxLayout(this);
    m_switch->setObjectName(QStringLiteral("windSwitch"));
    column->addWidget(m_switch);
    auto* presets = new QHBoxLayout;
    for (const Preset& preset : kPresets) {
        auto* button = new QPushButton(trText(preset.label));
        button->setObjectName(QStringLiteral("preset:") + QLatin1String(preset.name));
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        connect(button, &QPushButton::clicked, this, [this, &preset] {
            setValue(kStrength, preset.strength);
            setValue(kGusts, preset.gusts);
            setBlowing(true);
        });
        presets->addWidget(button, 1);
    }
    column->addLayout(presets);
    for (const Row& row : kRows) addRow(row);
    addFlexibility();
    column->addStretch(1);
    connect(m_switch, &QCheckBox::toggled, this, &CWindPanel::switched);
}

void CWindPanel::addRow(const Row& row) {
    auto* label = new QLabel;
    auto* slider = new CParamSlider(static_cast<int>(std::lround((row.max - row.min) / row.step)));
    const std::size_t index = m_sliders.size();
    m_sliders.push_back(slider);
    slider->setObjectName(QLatin1String(row.key));
    slider->setAccessibleName(trText(row.label));
    for (QWidget* widget : {static_cast<QWidget*>(label), static_cast<QWidget*>(slider)})
        widget->setToolTip(trText(row.help));
    const QString key = QStringLiteral("view/") + QLatin1String(row.key);
    const auto tell = [this, label, index, &row] {
        label->setText(QStringLiteral("%1: %2").arg(trText(row.label), row.text(value(index))));
    };
    setValue(index, QSettings().value(key, row.standard).toDouble());
    tell();
    connect(slider, &QSlider::valueChanged, this, [this, tell, key, index] {
        tell();
        QSettings().setValue(key, value(index));
        emit changed();
    });
    switchOnWith(slider);
    layout()->addWidget(label);
    layout()->addWidget(slider);
}

/// What a hand moves is to be seen.
void CWindPanel::switchOnWith(QSlider* slider) {
    connect(slider, &QSlider::actionTriggered, this, [this] { setBlowing(true); });
}

void CWindPanel::addFlexibility() {
    const ParamRef ref = *findParam("Flexibility");
    m_flexibilityLabel = new QLabel;
    m_flexibilityLabel->setWordWrap(true);
    m_flexibility =
        new CParamSlider(static_cast<int>(std::lround((ref.info->range.max - ref.info->range.min) / kFlexibilityStep)));
    m_flexibility->setObjectName(QStringLiteral("windFlexibility"));
    m_flexibility->setAccessibleName(trText(ref.info->label));
    for (QWidget* widget : {static_cast<QWidget*>(m_flexibilityLabel), static_cast<QWidget*>(m_flexibility)})
        widget->setToolTip(trText(ref.info->help));
    connect(m_flexibility, &QSlider::sliderPressed, this, [this] { m_gesture = nextGesture(); });
    connect(m_flexibility, &QSlider::sliderReleased, this, [this] {
        m_gesture = 0;
        emit released();
    });
    connect(m_flexibility, &QSlider::valueChanged, this, [this](int position) {
        emit flexibilityEdited(position * kFlexibilityStep / CParamSlider::kFinePerStep, m_gesture);
    });
    switchOnWith(m_flexibility);
    layout()->addWidget(m_flexibilityLabel);
    layout()->addWidget(m_flexibility);
}

void CWindPanel::showFlexibility(double flexibility) {
    const QSignalBlocker quiet(m_flexibility);
    m_flexibility->setValue(static_cast<int>(std::lround(flexibility / kFlexibilityStep * CParamSlider::kFinePerStep)));
    m_flexibilityLabel->setText(tr("Flexibility: %1").arg(numberOf(flexibility)));
}

bool CWindPanel::held() const { return m_flexibility->isSliderDown(); }

double CWindPanel::value(std::size_t row) const {
    return kRows[row].min + m_sliders[row]->value() * kRows[row].step / CParamSlider::kFinePerStep;
}

void CWindPanel::setValue(std::size_t row, double value) {
    m_sliders[row]->setValue(
        static_cast<int>(std::lround((value - kRows[row].min) / kRows[row].step * CParamSlider::kFinePerStep)));
}

bool CWindPanel::blowing() const { return m_switch->isChecked(); }
void CWindPanel::setBlowing(bool on) { m_switch->setChecked(on); }
double CWindPanel::direction() const { return value(kDirection); }

void CWindPanel::setDirection(double degrees) { setValue(kDirection, std::remainder(degrees, 360)); }

Wind CWindPanel::wind() const {
    return {.direction = windDirection(direction()), .strength = value(kStrength), .gusts = value(kGusts)};
}

} // namespace stromar
