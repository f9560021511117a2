#pragma once
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace stromar {

class CParamSlider;

/// The life of the tree under its picture, or its fall: how old it is, or how long it has fallen; played, stepped or
/// dragged.
class CTimeline : public QWidget {
    Q_OBJECT
public:
    static constexpr double kLifeSeconds = 10; ///< of playing at speed 1

    explicit CTimeline(QWidget* parent = nullptr);

    double age() const { return m_life.at; } ///< 0..1
    /// From now on it runs over a fall of so many seconds, from its beginning; one that is shown already goes on where
    /// it is.
    void showFall(double seconds);
    void showLife();
    double fallSeconds() const { return m_fall.at * m_fall.seconds; }
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
    void fallMoved(double seconds);
    void playingChanged(bool playing);
    void released();
    void recordWanted();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void advance();
    /// What the slider runs over.
    struct Track {
        double at;      ///< 0..1
        double seconds; ///< of playing at speed 1
    };

    void moveTo(double at);
    void tell();
    void step(double by);
    double speed() const;
    QToolButton* addButton(const char* name, const QIcon& icon, const QString& help);

    CParamSlider* m_slider;
    QLabel* m_label;
    QToolButton* m_play;
    QToolButton* m_loop;
    QComboBox* m_speed;
    QTimer m_timer;
    QElapsedTimer m_clock; ///< since the last step of playing
    QElapsedTimer m_asked; ///< since the last age was told of
    Track m_life{1, kLifeSeconds}, m_fall{0, 1};
    Track* m_track = &m_life;
    bool m_waiting = false; ///< for the tree of the last age
};

} // namespace stromar
