#include "view/LightPanel.h"
#include "params/ParamSlider.h"
#include "window/QtText.h"
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

QString valueText(const LightRow& row, double value) {
    const QLocale numbers;
    switch (row.kind) {
    case LightRow::Kind::Time: return timeText(value);
    case LightRow::Kind::Degrees: return QStringLiteral("%1°").arg(numbers.toString(value, 'f', 0));
    case LightRow::Kind::Share: return QStringLiteral("%1 %").arg(numbers.toString(100 * value, 'f', 0));
    case LightRow::Kind::Kelvin: return QStringLiteral("%1 K").arg(numbers.toString(value, 'f', 0));
    case LightRow::Kind::Stops: return CLightPanel::tr("%1 stops").arg(numbers.toString(value, 'f', 2));
    }
    return {};
}

QString settingKey(const LightRow& row) { return QStringLiteral("view/") + QLatin1String(row.key.data()); }
double standard(const LightRow& row) { return Light().*row.field; }
} // namespace

CLightPanel::CLightPanel(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    std::vector<std::function<void()>> resets;
    for (const LightRow& row : lightTable()) {
        auto* label = new QLabel;
        label->setWordWrap(true); // the dock may be narrow
        auto* slider = new CParamSlider(static_cast<int>(std::lround((row.useful.max - row.useful.min) / row.step)));
        slider->setObjectName(QLatin1String(row.key.data()));
        slider->setAccessibleName(trText(row.label));
        for (QWidget* widget : {static_cast<QWidget*>(label), static_cast<QWidget*>(slider)})
            widget->setToolTip(trText(row.help));
        const auto value = [slider, &row] { return row.useful.min + slider->value() * row.step / CParamSlider::kFinePerStep; };
        const auto move = [slider, &row](double to) {
            slider->setValue(static_cast<int>(std::lround((to - row.useful.min) / row.step * CParamSlider::kFinePerStep)));
        };
        const auto tell = [label, value, &row] {
            label->setText(QStringLiteral("%1: %2").arg(trText(row.label), valueText(row, value())));
        };
        move(QSettings().value(settingKey(row), standard(row)).toDouble());
        tell();
        connect(slider, &QSlider::valueChanged, this, [this, value, tell, &row] {
            tell();
            QSettings().setValue(settingKey(row), value());
            emit changed();
        });
        m_rows.emplace_back([value, &row](Light& light) { light.*row.field = value(); });
        resets.emplace_back([move, &row] { move(standard(row)); });
        column->addWidget(label);
        column->addWidget(slider);
    }
    auto* reset = new QPushButton(tr("Reset light"));
    reset->setObjectName(QStringLiteral("resetLight"));
    connect(reset, &QPushButton::clicked, this, [resets] {
        for (const auto& one : resets) one();
    });
    column->addWidget(reset);
    column->addStretch(1);
}

void CLightPanel::applyTo(ViewLook& look) const {
    for (const auto& row : m_rows) row(look.light);
}

} // namespace stromar
