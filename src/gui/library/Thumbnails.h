#pragma once
#include "view/OffscreenPainter.h"
#include "work/TreeCreatorThread.h"
#include <QTimer>
#include <QImage>
#include <QObject>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace stromar {

/// Small pictures of trees: grown one after another on a thread of their own, drawn between events on the GUI thread,
/// kept on the disk by what they show.
class CThumbnails : public QObject {
    Q_OBJECT
public:
    explicit CThumbnails(QObject* parent = nullptr);
    /// Cancels and waits.
    ~CThumbnails() override;

    enum class Keep { No, OnDisk };

    /// ready() or failed() follows; `id` comes back with it. Pictures that lie on the disk come first.
    void request(const QString& id, const CParams& params, const std::filesystem::path& folder, const QSize& pixels,
                 Keep keep, double age = 1);
    /// Whether pictures are still to come.
    bool busy() const { return !m_drawing.empty(); }
    /// Forgets what was asked for with ids that start with this.
    void drop(const QString& idStart);

signals:
    void ready(const QString& id, const QImage& image);
    void failed(const QString& id, const QString& why);
    void grown(quint64 number, std::shared_ptr<const stromar::ViewModel> view, const QString& why); ///< inside

private:
    struct Task {
        quint64 number;
        QString id, file; ///< without a file the picture is not kept
        std::filesystem::path folder; ///< that the paths of pictures start at
        CParams params;
        QSize pixels;
        double age;
    };
    void work(const std::stop_token& stop);
    void draw(quint64 number, const std::shared_ptr<const ViewModel>& view, const QString& why);

    COffscreenPainter m_painter;
    QTimer m_rest; ///< since the last picture
    std::deque<Task> m_drawing; ///< grown or growing, to be drawn; GUI thread
    quint64 m_lastNumber = 0;
    std::mutex m_mutex; ///< guards the rest but the thread
    std::condition_variable_any m_wake;
    std::deque<Task> m_waiting;
    QString m_growing; ///< id
    CProgress m_progress;
    std::jthread m_thread; ///< last: it stops first
};

} // namespace stromar
