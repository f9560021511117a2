#include "view/LightPanel.h"
#include "params/ParamSlider.h"
#include "window/QtText.h"
#include "stromar/util/Translatable.h"
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTime>
#include <QVBoxLayout>
#include <cmath>

namespace stromar {

namespace {
QString timeText(double hour) {
    const int minutes = static_cast<int>(std::lround(hour * 60));
    return QLocale().toString(QTime(minutes / 60 % 24, minutes % 60), QLocale::ShortFormat);
}
QString degreesText(double degrees) { return QStringLiteral("%1°").arg(QLocale().toString(degrees, 'f', 0)); }

/// One row of the table of lights.
struct LightRow {
    const char* key; ///< in the settings, and the slider's objectName
    const char* label;
    const char* help;
    double ViewLook::*field;
    double min, max, step;
    QString (*text)(double);
};
constexpr LightRow kRows[] = {
    {"hour", N_("Time of day"), N_("Where the sun stands: low and red in the morning and in the evening."),
     &ViewLook::hour, 5, 20, 0.25, timeText},
    {"sunTurn", N_("Sun direction"), N_("Turns the sun's way about the tree."), &ViewLook::sunTurn, -180, 180, 5,
     degreesText},
};

QString settingKey(const LightRow& row) { return QStringLiteral("view/") + QLatin1String(row.key); }
double standard(const LightRow& row) { return ViewLook().*row.field; }
} // namespace

CLightPanel::CLightPanel(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    std::vector<std::function<void()>> resets;
    for (const LightRow& row : kRows) {
        auto* label = new QLabel;
        auto* slider = new CParamSlider(static_cast<int>(std::lround((row.max - row.min) / row.step)));
        slider->setObjectName(QLatin1String(row.key));
        slider->setAccessibleName(trText(row.label));
        for (QWidget* widget : {static_cast<QWidget*>(label), static_cast<QWidget*>(slider)})
            widget->setToolTip(trText(row.help));
        const auto value = [slider, &row] { return row.min + slider->value() * row.step / CParamSlider::kFinePerStep; };
        const auto move = [slider, &row](double to) {
            slider->setValue(static_cast<int>(std::lround((to - row.min) / row.step * CParamSlider::kFinePerStep)));
        };
        const auto tell = [label, value, &row] {
            label->setText(QStringLiteral("%1: %2").arg(trText(row.label), row.text(value())));
        };
        move(QSettings().value(settingKey(row), standard(row)).toDouble());
        tell();
        connect(slider, &QSlider::valueChanged, this, [this, value, tell, &row] {
            tell();
            QSettings().setValue(settingKey(row), value());
            emit changed();
        });
        m_rows.emplace_back([value, &row](ViewLook& look) { look.*row.field = value(); });
        resets.emplace_back([move, &row] { move(standard(row)); });
        column->addWidget(label);
        column->addWidget(slider);
    }
    auto* reset = new QPushButton(tr("Usual light"));
    reset->setObjectName(QStringLiteral("usualLight"));
    connect(reset, &QPushButton::clicked, this, [resets] {
        for (const auto& one : resets) one();
    });
    column->addWidget(reset);
    column->addStretch(1);
}

void CLightPanel::applyTo(ViewLook& look) const {
    for (const auto& row : m_rows) row(look);
}

} // namespace stromar
