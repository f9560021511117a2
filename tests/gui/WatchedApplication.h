#pragma once
#include "library/Thumbnails.h"
#include "view/RestPicture.h"
#include <QApplication>
#include <QEvent>
#include <QString>
#include <QTimer>
#include <ctime>

namespace stromar::test {

/// Tells how long the event loop was busy with one event at most, drawing apart: in time of the thread's processor, so that what else
/// runs on the machine does not count.
class CWatchedApplication : public QApplication {
public:
    using QApplication::QApplication;

    void restart() {
        m_worst = 0;
        m_what.clear();
    }
    /// Whether a view that rests becomes smooth, which takes most of the time of a test that does not look at it.
    static void refine(bool on) { static_cast<CWatchedApplication*>(qApp)->m_refining = on; }
    double worstMilliseconds() const { return m_worst; }
    const QString& what() const { return m_what; }

    bool notify(QObject* receiver, QEvent* event) override {
        if (auto* timer = qobject_cast<QTimer*>(receiver); timer && !m_refining && isOfRestPicture(*timer, *event)) {
            timer->stop();
            return true;
        }
        if (m_depth > 0) {
            if (!draws(*receiver, *event)) return QApplication::notify(receiver, event);
            const double start = now(); // inside another event
            const bool done = QApplication::notify(receiver, event);
            m_drawn += now() - start;
            return done;
        }
        const QEvent::Type type = event->type(); // before the receiver may be gone
        const QString name = QString::fromLatin1(receiver->metaObject()->className()) + QLatin1Char(' ') + receiver->objectName();
        const bool drawing = draws(*receiver, *event);
        m_drawn = 0;
        ++m_depth;
        const double start = now();
        const bool done = QApplication::notify(receiver, event);
        const double took = now() - start - m_drawn;
        --m_depth;
        if (!drawing && took > m_worst) {
            m_worst = took;
            m_what = QStringLiteral("%1, event %2").arg(name).arg(type);
        }
        return done;
    }

private:
    static bool isOfRestPicture(const QObject& receiver, const QEvent& event) {
        return event.type() == QEvent::Timer && qobject_cast<const CRestPicture*>(receiver.parent());
    }
    static bool draws(const QObject& receiver, const QEvent& event) {
        return event.type() == QEvent::Paint || event.type() == QEvent::UpdateRequest || event.type() == QEvent::Expose ||
               isOfRestPicture(receiver, event) ||
               (event.type() == QEvent::MetaCall && qobject_cast<const CThumbnails*>(&receiver)); // which has been grown on a thread
    }
    static double now() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
    }

    double m_worst = 0, m_drawn = 0;
    QString m_what;
    int m_depth = 0;
    bool m_refining = false;
};

} // namespace stromar::test
