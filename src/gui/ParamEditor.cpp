#include "ParamEditor.h"
#include "QtText.h"
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QPointer>
#include <QProxyStyle>
#include <QRandomGenerator>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr int kMostSeed = 9999; // what the dice throws: easy to tell others

int nextGesture() {
    static int last = 0;
    return ++last;
}

/// A click beside the handle takes it there, and the drag goes on.
class CJumpStyle : public QProxyStyle {
public:
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override {
        if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton;
        return QProxyStyle::styleHint(hint, option, widget, data);
    }
};

QStyle* jumpStyle() {
    static QPointer<QStyle> style;
    if (!style) {
        style = new CJumpStyle;
        style->setParent(qApp);
    }
    return style;
}

QString suffixOf(Unit unit) {
    if (unit == Unit::None) return {};
    return (unit == Unit::Degree ? QString() : QStringLiteral(" ")) + toQString(unitName(unit));
}
} // namespace

CParamEditor::CParamEditor(const ParamRef& ref, QWidget* parent) : QWidget(parent), m_ref(ref) {
    setObjectName(toQString(ref.key()));
    setToolTip(QStringLiteral("<p><b>%1</b> (%2)</p><p>%3</p>")
                   .arg(toQString(ref.info->label), toQString(ref.key()), toQString(ref.info->help).toHtmlEscaped()));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    if (ref.info->field == ParamInfo::Field(&GlobalParams::seed))
        addSeed();
    else if (ref.info->words.size() == 2)
        addSwitch();
    else if (!ref.info->words.empty())
        addChoice();
    else
        addSliderAndBox();
}

void CParamEditor::addChoice() {
    m_choice = new QComboBox;
    for (const std::string_view word : m_ref.info->words) m_choice->addItem(toQString(word));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    guardWheel(m_choice);
    static_cast<QHBoxLayout*>(layout())->addWidget(m_choice, 1);
    connect(m_choice, &QComboBox::currentIndexChanged, this, [this](int i) { emit edited(m_ref, i, 0); });
}

void CParamEditor::addSwitch() {
    m_switch = new QCheckBox;
    layout()->addWidget(m_switch);
    connect(m_switch, &QCheckBox::toggled, this, [this](bool on) { emit edited(m_ref, on ? 1 : 0, 0); });
}

void CParamEditor::addSeed() {
    auto* dice = new QToolButton;
    dice->setObjectName(QStringLiteral("dice"));
    dice->setIcon(QIcon(QStringLiteral(":/icons/dice.svg")));
    dice->setToolTip(tr("Another tree of the same kind"));
    dice->setAccessibleName(tr("Random seed"));
    layout()->addWidget(makeBox());
    layout()->addWidget(dice);
    static_cast<QHBoxLayout*>(layout())->addStretch(1);
    connect(dice, &QToolButton::clicked, this,
            [this] { emit edited(m_ref, QRandomGenerator::global()->bounded(kMostSeed + 1), 0); });
}

void CParamEditor::addSliderAndBox() {
    m_slider = new QSlider(Qt::Horizontal);
    const ParamInfo& p = *m_ref.info;
    m_slider->setStyle(jumpStyle());
    m_slider->setRange(0, static_cast<int>(std::lround((p.useful.max - p.useful.min) / p.step)));
    m_slider->setPageStep(std::max(1, m_slider->maximum() / 10));
    m_slider->setAccessibleName(toQString(p.label));
    guardWheel(m_slider);
    connect(m_slider, &QSlider::sliderReleased, this, [this] {
        m_gesture = 0;
        emit released();
    });
    connect(m_slider, &QSlider::valueChanged, this, &CParamEditor::onSlider);
    static_cast<QHBoxLayout*>(layout())->addWidget(m_slider, 1);
    layout()->addWidget(makeBox());
}

QAbstractSpinBox* CParamEditor::makeBox() {
    const ParamInfo& p = *m_ref.info;
    QAbstractSpinBox* box = nullptr;
    if (p.integer()) {
        m_whole = new QSpinBox;
        m_whole->setRange(static_cast<int>(p.range.min), static_cast<int>(p.range.max));
        m_whole->setSingleStep(static_cast<int>(p.step));
        connect(m_whole, &QSpinBox::valueChanged, this, [this](int v) { onBox(v); });
        box = m_whole;
    } else {
        m_real = new QDoubleSpinBox;
        m_real->setDecimals(p.decimals);
        m_real->setRange(p.range.min, p.range.max);
        m_real->setSingleStep(p.step);
        m_real->setSuffix(suffixOf(p.unit));
        connect(m_real, &QDoubleSpinBox::valueChanged, this, [this](double v) { onBox(v); });
        box = m_real;
    }
    box->setKeyboardTracking(false);
    box->setFixedWidth(86);
    box->setAccessibleName(toQString(p.label));
    guardWheel(box);
    return box;
}

void CParamEditor::guardWheel(QWidget* editor) {
    editor->setFocusPolicy(Qt::StrongFocus);
    editor->installEventFilter(this);
}

bool CParamEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore(); // the panel behind scrolls
        return true;
    }
    if (event->type() == QEvent::MouseButtonPress && watched == m_slider)
        m_gesture = nextGesture(); // before the handle jumps
    return QWidget::eventFilter(watched, event);
}

int CParamEditor::sliderPosition(double value) const {
    const Range& useful = m_ref.info->useful;
    const double share = (std::clamp(value, useful.min, useful.max) - useful.min) / (useful.max - useful.min);
    return static_cast<int>(std::lround(share * m_slider->maximum()));
}

double CParamEditor::sliderValue(int position) const {
    const ParamInfo& p = *m_ref.info;
    const double raw = p.useful.min + (p.useful.max - p.useful.min) * position / m_slider->maximum();
    const double digits = std::pow(10.0, p.decimals);
    const double onStep = std::round(std::round(raw / p.step) * p.step * digits) / digits; // numbers one can remember
    return std::clamp(onStep, p.useful.min, p.useful.max);
}

void CParamEditor::onSlider(int position) {
    const double value = sliderValue(position);
    showValue(value);
    emit edited(m_ref, value, m_gesture);
}

void CParamEditor::onBox(double value) {
    showValue(value);
    emit edited(m_ref, value, 0);
}

void CParamEditor::showValue(double value) {
    if (m_choice) {
        const QSignalBlocker quiet(m_choice);
        m_choice->setCurrentIndex(static_cast<int>(value));
    }
    if (m_switch) {
        const QSignalBlocker quiet(m_switch);
        m_switch->setChecked(value != 0);
    }
    if (m_slider && !m_slider->isSliderDown()) {
        const QSignalBlocker quiet(m_slider);
        m_slider->setValue(sliderPosition(value));
    }
    if (m_real) {
        const QSignalBlocker quiet(m_real);
        m_real->setValue(value);
    }
    if (m_whole) {
        const QSignalBlocker quiet(m_whole);
        m_whole->setValue(static_cast<int>(value));
    }
}

bool CParamEditor::held() const { return m_slider && m_slider->isSliderDown(); }

} // namespace stromar
