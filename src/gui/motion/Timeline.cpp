#include "motion/Timeline.h"
#include "params/ParamSlider.h"
#include <QComboBox>
#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr int kSteps = 200;    // of the slider
constexpr double kStep = 0.02; // of a button
constexpr int kTickMs = 16;
constexpr int kPatienceMs = 3000; // for a tree that does not come
constexpr double kSpeeds[] = {0.25, 0.5, 1, 2, 4};
constexpr int kUsualSpeed = 2;
constexpr int kNarrow = 160, kMiddling = 270, kWide = 400; // pixels

/// The style's own are black in every theme.
QIcon iconOf(const char* name) { return QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name))); }

int positionOf(double age) { return static_cast<int>(std::lround(age * kSteps * CParamSlider::kFinePerStep)); }
} // namespace

CTimeline::CTimeline(QWidget* parent)
    : QWidget(parent), m_slider(new CParamSlider(kSteps)), m_label(new QLabel), m_speed(new QComboBox) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 2, 6, 2);
    row->setSpacing(2);
    setMinimumWidth(kNarrow); // the picture says how narrow the window may be
    m_slider->setMinimumWidth(20);
    auto* back = addButton("timelineBack", iconOf("stepBack"), tr("A step back"));
    m_play = addButton("timelinePlay", iconOf("play"), tr("Play"));
    m_play->setCheckable(true);
    auto* forward = addButton("timelineForward", iconOf("stepForward"), tr("A step forward"));
    m_slider->setObjectName(QStringLiteral("age"));
    m_slider->setAccessibleName(tr("Age"));
    m_slider->setToolTip(tr("How old the tree is, or how far it has fallen"));
    m_slider->setValue(m_slider->maximum());
    row->addWidget(m_slider, 1);
    row->addWidget(m_label);
    m_label->setObjectName(QStringLiteral("ageText"));
    m_label->setMinimumWidth(
        m_label->fontMetrics().horizontalAdvance(tr("Age %1 %").arg(QLocale().toString(100.0, 'f', 1))) + 6);
    m_speed->setObjectName(QStringLiteral("timelineSpeed"));
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setToolTip(tr("How fast it is played"));
    m_speed->setFocusPolicy(Qt::StrongFocus);
    for (const double speed : kSpeeds) m_speed->addItem(QStringLiteral("%1×").arg(QLocale().toString(speed)), speed);
    m_speed->setCurrentIndex(kUsualSpeed);
    row->addWidget(m_speed);
    m_loop = addButton("timelineLoop", iconOf("loop"), tr("Begin anew at the end"));
    m_loop->setCheckable(true);
    auto* record = addButton("timelineRecord", iconOf("record"), tr("Save pictures or a video of it"));
    m_timer.setInterval(kTickMs);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &CTimeline::advance);
    connect(back, &QToolButton::clicked, this, [this] { step(-kStep); });
    connect(forward, &QToolButton::clicked, this, [this] { step(kStep); });
    connect(m_play, &QToolButton::toggled, this, &CTimeline::setPlaying);
    connect(record, &QToolButton::clicked, this, &CTimeline::recordWanted);
    connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
        setPlaying(false);
        moveTo(double(position) / m_slider->maximum());
    });
    connect(m_slider, &QSlider::sliderReleased, this, &CTimeline::released);
    tell();
}

QToolButton* CTimeline::addButton(const char* name, const QIcon& icon, const QString& help) {
    auto* button = new QToolButton;
    button->setObjectName(QLatin1String(name));
    button->setIcon(icon);
    button->setToolTip(help);
    button->setAccessibleName(help);
    button->setAutoRaise(true);
    static_cast<QHBoxLayout*>(layout())->addWidget(button);
    return button;
}

double CTimeline::speed() const { return m_speed->currentData().toDouble(); }

/// A narrow picture keeps the slider and the buttons that play it.
void CTimeline::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    for (QWidget* widget : {static_cast<QWidget*>(m_speed), static_cast<QWidget*>(m_loop)}) widget->setVisible(width() >= kWide);
    m_label->setVisible(width() >= kMiddling);
}

bool CTimeline::held() const { return m_slider->isSliderDown(); }

void CTimeline::setLooping(bool on) { m_loop->setChecked(on); }

void CTimeline::showFall(double seconds) {
    if (m_track != &m_fall) {
        setPlaying(false);
        m_fall.at = 0;
    }
    m_track = &m_fall;
    m_fall.seconds = seconds;
    m_waiting = false;
    tell();
}

void CTimeline::showLife() {
    if (m_track == &m_life) return;
    setPlaying(false);
    m_track = &m_life;
    tell();
}

void CTimeline::tell() {
    const QLocale numbers;
    m_label->setText(m_track == &m_life ? tr("Age %1 %").arg(numbers.toString(100 * m_life.at, 'f', 1))
                                        : tr("Fall %1 s").arg(numbers.toString(fallSeconds(), 'f', 1)));
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(positionOf(m_track->at));
}

void CTimeline::moveTo(double at) {
    const bool other = at != m_track->at;
    m_track->at = at;
    tell();
    if (!other) return;
    if (m_track == &m_fall) {
        emit fallMoved(fallSeconds());
        return;
    }
    m_waiting = true;
    m_asked.start();
    emit ageChanged(at);
}

void CTimeline::setAge(double age) {
    showLife();
    setPlaying(false);
    moveTo(std::clamp(age, 0.0, 1.0));
}

void CTimeline::step(double by) {
    setPlaying(false);
    moveTo(std::clamp(std::round((m_track->at + by) / kStep) * kStep, 0.0, 1.0));
}

void CTimeline::setPlaying(bool on) {
    if (on == playing()) return;
    m_play->setChecked(on);
    m_play->setIcon(iconOf(on ? "pause" : "play"));
    if (on) {
        m_clock.start();
        m_timer.start();
        emit playingChanged(true);
        if (m_track->at >= 1) moveTo(0);
    } else {
        m_timer.stop();
        emit playingChanged(false);
    }
}

void CTimeline::advance() {
    if (m_waiting && m_asked.elapsed() < kPatienceMs) return;
    double at = m_track->at + double(m_clock.restart()) / 1000 * speed() / std::max(1e-3, m_track->seconds);
    const bool loops = m_loop->isChecked();
    if (at > 1) at = loops && m_track->at >= 1 ? 0 : 1; // the end is seen too
    moveTo(at);
    if (at >= 1 && !loops) setPlaying(false);
}

} // namespace stromar
