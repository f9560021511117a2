#pragma once
#include "stromar/app/Pictures.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/scene/ViewScene.h"
#include <QThread>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

namespace stromar {

/// A model ready for the viewport.
struct ViewModel {
    std::shared_ptr<const TreeModel> model;
    std::vector<ViewPart> parts;
    std::shared_ptr<const ModelSway> sway{}; ///< where it is asked for
    std::array<std::shared_ptr<const SurfaceMaps>, kSurfaces.size()> surfaces{}; ///< of those it has; where they are asked for
};

/// A tree that was not grown because of its size.
struct TooLargeTree {
    CParams params;
    Prediction size;
    std::optional<std::pair<ParamRef, double>> fits; ///< a value, and what it has to be for the tree to be small enough
};

/// Creates trees away from the GUI thread. One slot: a newer request replaces the waiting one and cancels the running
/// one. Results arrive as queued signals.
class CTreeCreatorThread : public QThread {
    Q_OBJECT
public:
    explicit CTreeCreatorThread(std::unique_ptr<CTreeCreator> creator, QObject* parent = nullptr);
    /// Cancels what runs and waits for it to stop.
    ~CTreeCreatorThread() override;

    struct Request {
        CParams params;
        std::filesystem::path folder; ///< that the paths of pictures start at
        const Detail* detail;
        SizeLimits limits{}; ///< the tree is not grown when its full model may become larger
        bool anew = false;   ///< forgets what was made before
        double age = 1;      ///< 0..1 of the tree's life
        bool sways = false;  ///< in the wind
    };
    /// Any thread; returns at once.
    void request(Request request);
    /// Gives up what runs and what waits.
    void cancel();
    /// Processors for the next trees; 0 takes all.
    void setThreads(int threads);
    /// Bytes that drawn pictures may take on the disk: the oldest go when there is nothing to do. 0: as many as they like.
    void setPictureCache(std::uintmax_t bytes) { m_pictureCache = bytes; }
    /// Share of the running work that is done, 0..1; nothing when idle.
    std::optional<double> progress() const;

signals:
    void created(std::shared_ptr<const stromar::ViewModel> view);
    /// A surface of the last tree has other pictures than before. Those of recipes come after their tree, first in small.
    void surfaceRead(Surface surface, std::shared_ptr<const stromar::SurfaceMaps> maps);
    void failed(const QString& why);
    void tooLarge(std::shared_ptr<const stromar::TooLargeTree> tree);

protected:
    void run() override;

private:
    using Clock = std::chrono::steady_clock;

    std::optional<Request> nextRequest();
    std::shared_ptr<const ViewModel> create(const Request& request, const CProgress& progress);
    void readSurfaces(const Request& request);
    void makeTwigs(const TreeModel& model, const std::filesystem::path& folder, const CProgress& progress);
    bool mayFinish() const;
    void freeMemory();
    TooLargeTree refusedTree(const Request& request, const Prediction& size) const;

    std::unique_ptr<CTreeCreator> m_creator; // this and the next: run() only
    std::vector<ViewPart> m_parts; ///< of the last model
    std::shared_ptr<const ModelSway> m_sway; ///< of the last model that sways
    const Detail* m_shown = nullptr; ///< of the last model
    CParams m_fitting;               ///< the last values that were not too large
    SurfaceTextures m_read;        ///< the pictures that were told of last
    std::atomic<std::uintmax_t> m_pictureCache = 0;

    mutable std::mutex m_mutex; // std: ThreadSanitizer cannot see QMutex. Guards all below.
    std::condition_variable m_wake;
    std::optional<Request> m_wanted;
    std::optional<CProgress> m_running;
    int m_threads = 0;
    bool m_runningSimple = false;
    Clock::time_point m_lastResult;
    bool m_quit = false;
};

} // namespace stromar

Q_DECLARE_METATYPE(std::shared_ptr<const stromar::ViewModel>)
Q_DECLARE_METATYPE(std::shared_ptr<const stromar::SurfaceMaps>)
Q_DECLARE_METATYPE(std::shared_ptr<const stromar::TooLargeTree>)
Q_DECLARE_METATYPE(stromar::Surface)
