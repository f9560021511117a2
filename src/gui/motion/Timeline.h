#pragma once
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace stromar {

class CParamSlider;

/// The life of the tree under its picture: how old it is, played, stepped or dragged.
class CTimeline : public QWidget {
    Q_OBJECT
public:
    static constexpr double kLifeSeconds = 10; ///< of playing at speed 1

    explicit CTimeline(QWidget* parent = nullptr);

    double age() const { return m_age; } ///< 0..1
    /// As if it were dragged there.
    void setAge(double age);
    bool playing() const { return m_timer.isActive(); }
    /// From the beginning, when the tree is grown.
    void setPlaying(bool on);
    /// The tree of the last age can be seen: the next one may come. Playing waits for it.
    void shown() { m_waiting = false; }
    /// Whether the slider is in hand.
    bool held() const;
    void setLooping(bool on);

signals:
    void ageChanged(double age);
    void playingChanged(bool playing);
    void released();
    void recordWanted();

private:
    void advance();
    void moveTo(double age);
    void step(double by);
    double speed() const;
    QToolButton* addButton(const char* name, const QIcon& icon, const QString& help);

    CParamSlider* m_slider;
    QLabel* m_label;
    QToolButton* m_play;
    QToolButton* m_loop;
    QComboBox* m_speed;
    QTimer m_timer;
    QElapsedTimer m_clock;  ///< since the last step of playing
    QElapsedTimer m_asked;  ///< since the last age was told of
    double m_age = 1;
    bool m_waiting = false; ///< for the tree of the last age
};

} // namespace stromar
