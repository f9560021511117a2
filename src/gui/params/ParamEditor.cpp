#include "params/ParamEditor.h"
#include "params/ClampingBox.h"
#include "params/CodeEditor.h"
#include "params/CurveEditor.h"
#include "document/Gesture.h"
#include "params/LanguageEditor.h"
#include "params/ParamSlider.h"
#include "window/Keys.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr int kSliderWidth = 56, kNarrowSliderWidth = 40; // pixels, at least
constexpr int kBurstMs = 800; // changes that follow each other sooner are one step

/// Shift steps by the last digit that is shown; Ctrl by ten steps is the box's own.
class CFineSpinBox : public CClampingBox<QDoubleSpinBox> {
public:
    void stepBy(int steps) override {
        if (!(QGuiApplication::keyboardModifiers() & Qt::ShiftModifier)) return QDoubleSpinBox::stepBy(steps);
        setValue(value() + (steps > 0 ? 1 : -1) * std::pow(10, -decimals()));
    }
};

/// Whether a box holds letters that are not yet its value.
bool isTyping(QObject* editor) {
    const auto* line = editor->findChild<QLineEdit*>();
    return line && line->isModified();
}

QString suffixOf(Unit unit) {
    if (unit == Unit::Metre) return QStringLiteral(" ") + lengthUnit().name;
    return unit == Unit::None ? QString() : trText(unitName(unit));
}
} // namespace

CParamEditor::CParamEditor(const ParamRef& ref, Form form, QWidget* parent) : QWidget(parent), m_ref(ref) {
    setObjectName(toQString(ref.key()));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    switch (ref.info->kind()) {
    case ParamKind::Switch: addSwitch(); break;
    case ParamKind::Choice: addChoice(); break;
    case ParamKind::Curve: addCurve(); break;
    case ParamKind::Text: addBlock(); break;
    case ParamKind::Number: addNumber(form); break;
    }
}

void CParamEditor::addNumber(Form form) {
    if (m_ref.info->field == field<&CommonParams::seed>) return addSeed();
    if (form == Form::Whole) addSlider();
    layout()->addWidget(makeBox(form));
}

void CParamEditor::addChoice() {
    m_choice = new QComboBox;
    for (const std::string_view word : m_ref.info->words) m_choice->addItem(trText(word));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setAccessibleName(trText(m_ref.info->label));
    guardWheel(m_choice);
    static_cast<QHBoxLayout*>(layout())->addWidget(m_choice, 1);
    connect(m_choice, &QComboBox::currentIndexChanged, this, [this](int i) { emit edited(m_ref, double(i), 0); });
}

void CParamEditor::addSwitch() {
    m_switch = new QCheckBox;
    m_switch->setAccessibleName(trText(m_ref.info->label));
    layout()->addWidget(m_switch);
    static_cast<QHBoxLayout*>(layout())->addStretch(1);
    connect(m_switch, &QCheckBox::toggled, this, [this](bool on) { emit edited(m_ref, on ? 1.0 : 0.0, 0); });
}

void CParamEditor::addSeed() {
    auto* dice = new QToolButton;
    dice->setObjectName(QStringLiteral("dice"));
    dice->setIcon(QIcon(QStringLiteral(":/icons/dice.svg")));
    dice->setToolTip(tr("Another tree of the same kind"));
    dice->setAccessibleName(tr("Random seed"));
    layout()->addWidget(makeBox(Form::Whole));
    layout()->addWidget(dice);
    static_cast<QHBoxLayout*>(layout())->addStretch(1);
    connect(dice, &QToolButton::clicked, this, [this] { emit edited(m_ref, double(randomSeed()), 0); });
}

void CParamEditor::addCurve() {
    m_curve = new CCurveEditor(*m_ref.info);
    layout()->addWidget(m_curve);
    connect(m_curve, &CCurveEditor::edited, this,
            [this](const CCurve& curve, int gesture) { emit edited(m_ref, curve, gesture); });
    connect(m_curve, &CCurveEditor::released, this, &CParamEditor::released);
    connect(m_curve, &CCurveEditor::rangeHeld, this, [this](double low, double high) { emit rangeHeld(m_ref, low, high); });
}

/// The text counts when the focus goes elsewhere, or on Ctrl+Enter.
void CParamEditor::addBlock() {
    if (const TextLanguage* language = languageOf(*m_ref.info)) return addLanguage(*language);
    m_block = new QPlainTextEdit;
    m_block->setAccessibleName(trText(m_ref.info->label));
    m_block->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_block->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_block->setTabChangesFocus(true);
    m_block->setMinimumHeight(8 * fontMetrics().height());
    m_block->installEventFilter(this);
    layout()->addWidget(m_block);
}

void CParamEditor::addLanguage(const TextLanguage& language) {
    m_language = new CLanguageEditor(language);
    m_language->code().setAccessibleName(trText(m_ref.info->label));
    layout()->addWidget(m_language);
    connect(m_language, &CLanguageEditor::edited, this,
            [this](const QString& text, int gesture) { emit edited(m_ref, text.toStdString(), gesture); });
    connect(m_language, &CLanguageEditor::released, this, &CParamEditor::released);
    connect(m_language, &CLanguageEditor::lineTouched, this, [this](int line) { emit lineTouched(m_ref, line); });
}

void CParamEditor::showTree(const CParams& params) {
    if (m_language) m_language->showParams(params);
    if (m_curve) m_curve->setAxis(axisOf(*m_ref.info, params));
}

void CParamEditor::takeBlock() {
    if (!m_block->document()->isModified()) return;
    m_block->document()->setModified(false);
    emit edited(m_ref, m_block->toPlainText().toStdString(), 0);
}

void CParamEditor::addSlider() {
    const ParamInfo& p = *m_ref.info;
    m_slider = new CParamSlider(static_cast<int>(std::lround((p.useful.max - p.useful.min) / p.step)));
    m_slider->setAccessibleName(trText(p.label));
    m_slider->setMinimumWidth(kSliderWidth);
    guardWheel(m_slider);
    connect(m_slider, &QSlider::sliderReleased, this, [this] {
        m_gesture = 0;
        emit released();
    });
    connect(m_slider, &QSlider::valueChanged, this, &CParamEditor::onSlider);
    static_cast<QHBoxLayout*>(layout())->addWidget(m_slider, 1);
}

QAbstractSpinBox* CParamEditor::makeBox(Form form) {
    const ParamInfo& p = *m_ref.info;
    QAbstractSpinBox* box = nullptr;
    if (p.integer()) {
        m_whole = new CClampingBox<QSpinBox>;
        m_whole->setRange(static_cast<int>(p.range.min), static_cast<int>(p.range.max));
        m_whole->setSingleStep(static_cast<int>(p.step));
        connect(m_whole, &QSpinBox::valueChanged, this, [this](int v) { onBox(v); });
        box = m_whole;
    } else {
        m_real = new CFineSpinBox;
        m_perUnit = p.unit == Unit::Metre ? lengthUnit().perMetre : 1;
        m_real->setDecimals(p.decimals);
        m_real->setRange(p.range.min * m_perUnit, p.range.max * m_perUnit);
        m_real->setSingleStep(p.step);
        m_real->setSuffix(suffixOf(p.unit));
        connect(m_real, &QDoubleSpinBox::valueChanged, this, [this](double v) { onBox(v / m_perUnit); });
        box = m_real;
    }
    box->setKeyboardTracking(false);
    m_varies = form == Form::Variation;
    box->setAccessibleName(trText(p.label));
    guardWheel(box);
    return box;
}

QAbstractSpinBox* CParamEditor::box() const {
    return m_real ? static_cast<QAbstractSpinBox*>(m_real) : m_whole;
}

/// Without the buttons of its box, which the wheel and the arrow keys replace.
void CParamEditor::setNarrow(bool narrow) {
    if (m_slider) m_slider->setMinimumWidth(narrow ? kNarrowSliderWidth : kSliderWidth);
    if (!box()) return updateGeometry();
    box()->setButtonSymbols(narrow ? QAbstractSpinBox::NoButtons : QAbstractSpinBox::UpDownArrows);
    box()->setFixedWidth(fontMetrics().horizontalAdvance(narrow ? QStringLiteral("−000.00°") : QStringLiteral("−000.00 m")) + (narrow ? 10 : 24));
    updateGeometry(); // so that who measures knows at once
}

void CParamEditor::guardWheel(QWidget* editor) {
    editor->setFocusPolicy(Qt::StrongFocus);
    editor->installEventFilter(this);
    editor->installEventFilter(&m_wheel);
}

bool CParamEditor::eventFilter(QObject* watched, QEvent* event) {
    if (m_block && watched == m_block) {
        const auto* key = event->type() == QEvent::KeyPress ? static_cast<QKeyEvent*>(event) : nullptr;
        const bool taken = key && (key->modifiers() & Qt::ControlModifier) && (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter);
        if (taken || event->type() == QEvent::FocusOut) takeBlock();
        return taken;
    }
    if (event->type() == QEvent::ShortcutOverride && isUndo(*static_cast<QKeyEvent*>(event)) && !isTyping(watched)) {
        event->ignore(); // it is the document's
        return true;
    }
    if (event->type() == QEvent::MouseButtonPress && watched == m_slider)
        m_gesture = 0; // a drag is a gesture of its own
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
    // Numbers one can remember; between two steps only what the box can show.
    const bool between = position % CParamSlider::kFinePerStep != 0;
    const double digits = std::pow(10.0, p.decimals);
    const double onStep = between ? raw : std::round(raw / p.step) * p.step;
    return std::clamp(std::round(onStep * digits) / digits, p.useful.min, p.useful.max);
}

/// The running drag, or the running burst of keys or wheel.
int CParamEditor::gestureNow() {
    const bool held = m_slider && m_slider->isSliderDown();
    const bool burst = m_sinceChange.isValid() && m_sinceChange.elapsed() < kBurstMs;
    if (m_gesture == 0 || (!held && !burst)) m_gesture = nextGesture();
    m_sinceChange.start();
    return m_gesture;
}

void CParamEditor::onSlider(int position) {
    const double value = sliderValue(position);
    showNumber(value);
    emit edited(m_ref, value, gestureNow());
}

void CParamEditor::onBox(double value) {
    showNumber(value);
    emit edited(m_ref, value, gestureNow());
}

void CParamEditor::showValue(const ParamValue& value) {
    if (const auto* curve = std::get_if<CCurve>(&value)) return m_curve->showCurve(*curve);
    if (const auto* number = std::get_if<double>(&value)) return showNumber(*number);
    const QString text = toQString(std::get<std::string>(value));
    if (m_language) return m_language->showText(text);
    if (m_block->toPlainText() == text) return;
    m_block->setPlainText(text);
    m_block->document()->setModified(false);
}

void CParamEditor::showNumber(double value) {
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
        // Negative variations are not random: they grade or wind.
        if (m_varies) m_real->setPrefix(value < 0 ? QString() : QStringLiteral("± "));
        m_real->setValue(value * m_perUnit);
    }
    if (m_whole) {
        const QSignalBlocker quiet(m_whole);
        m_whole->setValue(static_cast<int>(value));
    }
}

bool CParamEditor::held() const { return (m_slider && m_slider->isSliderDown()) || (m_curve && m_curve->held()) || (m_language && m_language->held()); }

} // namespace stromar
