#pragma once
#include "document/Document.h"
#include "work/TreeCreatorThread.h"
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

namespace stromar {

class CMessageBar;

/// Grows the tree of a document: a simple model at every change, the full one when the hand rests. A tree that would
/// become too large is not grown; the bar asks what to do instead.
class CGrowthController : public QObject {
    Q_OBJECT
public:
    CGrowthController(CDocument& document, CMessageBar& bar, const SizeLimits& limits, QObject* parent = nullptr);

    /// After a change of the document.
    void follow();
    /// The full model waits for the hand to let go of everything.
    void setHeld(std::function<bool()> held) { m_held = std::move(held); }
    void handReleased() { m_pause.start(); }
    void growFull();
    /// How old the tree is, 0..1; it follows as after a change. While a life is played only the simple model does.
    void setAge(double age);
    double age() const { return m_age; }
    void setPlaying(bool on);
    /// Whether the trees that come can sway.
    void setSwaying(bool on);
    /// Everything from nothing.
    void generate();
    /// Whether something was growing.
    bool stop();
    /// Which model follows a change; the default is the simple one first, then the full one.
    void showOnly(Model model);
    /// Which level of detail the full model has, 0 the finest.
    void setLod(int lod);
    int lod() const { return m_lod; }

    void setThreads(int threads) { m_thread.setThreads(threads); }
    void setFullModelDelay(int milliseconds) { m_pause.setInterval(milliseconds); }
    /// Gigabytes; 0 is what the controller was made with.
    void setMaxMemory(int gigabytes);
    void setPictureCache(int megabytes) { m_thread.setPictureCache(1'000'000 * static_cast<std::uintmax_t>(megabytes)); }
    /// For the tree as it is: none where the user let a large one grow.
    SizeLimits limits() const;
    /// Share of the running work that is done, 0..1; nothing when idle.
    std::optional<double> progress() const { return m_thread.progress(); }

signals:
    void started();
    void created(const std::shared_ptr<const ViewModel>& view);
    void surfaceRead(Surface surface, const std::shared_ptr<const SurfaceMaps>& maps);
    void failed(const QString& why);
    void refused();

private:
    void request(Model model, bool anew = false);
    void requestFull();
    void onCreated(const std::shared_ptr<const ViewModel>& view);
    void onFailed(const QString& why);
    void onTooLarge(const TooLargeTree& tree);

    CDocument& m_document;
    CMessageBar& m_bar;
    std::function<bool()> m_held = [] { return false; };
    QTimer m_pause; ///< until the full model follows
    QTimer m_sound; ///< since a tree came: what was wrong before it is not any more
    std::optional<Model> m_only;
    double m_age = 1;
    bool m_playing = false, m_swaying = false;
    int m_lod = 0;
    Model m_last = Model::Simple; ///< that was asked for
    SizeLimits m_limits;
    double m_givenMemory; ///< bytes; the limit where the user sets none
    CParams m_allowed;    ///< may grow although they are large
    CTreeCreatorThread m_thread; ///< last: it stops before anything it reports to is gone
};

} // namespace stromar
