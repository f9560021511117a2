#pragma once
#include "motion/SwayMoment.h"
#include "motion/RecordDialog.h"
#include "stromar/app/Motion.h"
#include "stromar/scene/Camera.h"
#include "view/OffscreenPainter.h"
#include <QWidget>

class QProgressDialog;

namespace stromar {

/// The tree that is recorded, and how it is seen.
struct RecordedTree {
    CParams params;
    std::filesystem::path folder;
    double age = 1;
    Wind wind;
    std::optional<Felling> felling;
    SizeLimits limits;
    ViewLook look;
    CCamera camera;
};

/// Saves what moves as numbered pictures, or as a video. Each frame is grown on a thread and drawn on the GUI thread,
/// which stays alive; one recording at a time.
class CRecorder : public QObject {
    Q_OBJECT
public:
    explicit CRecorder(QWidget& window) : QObject(&window), m_window(window) {}

    /// Returns when it is done, failed or cancelled.
    void record(const RecordedTree& tree, const RecordOptions& options);
    bool busy() const { return m_busy; }

signals:
    void notice(const QString& text);

private:
    class CFrames;

    /// How many frames were written; throws CError.
    int writeFrames(const RecordedTree& tree, const RecordOptions& options, const QString& path,
                    QProgressDialog& progress);
    void makeVideo(const QString& namesBegin, const RecordOptions& options, QProgressDialog& progress);

    QWidget& m_window;
    bool m_busy = false;
};

} // namespace stromar
