#include "library/Thumbnails.h"
#include "window/QtText.h"
#include "work/GrownView.h"
#include "stromar/app/Export.h"
#include "stromar/app/Prediction.h"
#include "stromar/params/TreeFile.h"
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QTimer>

namespace stromar {

namespace {
constexpr int kRestMs = 3000;          // from the last picture until its graphics memory is freed
constexpr int kLookVersion = 5;       // rises when the same tree is drawn differently
constexpr double kFewVertices = 4e5;  // up to here all leaves are drawn

/// Where the picture of such a tree is kept.
QString keptFile(const CParams& params, const SurfaceTextures& textures, const QSize& pixels) {
    QCryptographicHash hash(QCryptographicHash::Sha1);
    CParams seen = params; // words do not show
    seen.text.species = seen.text.author = seen.text.description = seen.text.likedSeeds = {};
    hash.addData(QByteArray::fromStdString(CTreeFile().text(seen)));
    for (const std::filesystem::path& picture : textures) {
        const QFileInfo info(fromPath(picture));
        hash.addData(QStringLiteral("%1 %2 %3")
                         .arg(fromPath(picture))
                         .arg(info.size())
                         .arg(info.lastModified().toMSecsSinceEpoch())
                         .toUtf8());
    }
    hash.addData(QStringLiteral("%1 %2x%3").arg(kLookVersion).arg(pixels.width()).arg(pixels.height()).toUtf8());
    const QDir folder(fromPath(pictureCache() / "thumbnails"));
    folder.mkpath(QStringLiteral("."));
    return folder.filePath(QString::fromLatin1(hash.result().toHex()) + QStringLiteral(".png"));
}

/// Coarser levels of detail are measured for long.
const Detail& detailFor(const CParams& params) {
    const Detail& full = detailOf(Model::Full);
    return predictSize(params, full).vertices < kFewVertices ? full : detailOf(Model::Simple);
}
} // namespace

CThumbnails::CThumbnails(QObject* parent) : QObject(parent) {
    qRegisterMetaType<std::shared_ptr<const ViewModel>>();
    connect(this, &CThumbnails::grown, this, &CThumbnails::draw, Qt::QueuedConnection);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, [this] { m_painter.rest(); });
    m_thread = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

CThumbnails::~CThumbnails() {
    m_thread.request_stop();
    {
        const std::lock_guard lock(m_mutex);
        m_progress.cancel();
    }
    m_wake.notify_all();
    m_thread.join();
}

void CThumbnails::request(const QString& id, const CParams& params, const std::filesystem::path& folder,
                          const QSize& pixels, Keep keep, double age) {
    Task task{++m_lastNumber, id, QString(), folder, params, pixels, age};
    if (keep == Keep::OnDisk) task.file = keptFile(params, texturesOf(params, folder), pixels);
    if (const QImage kept = task.file.isEmpty() ? QImage() : QImage(task.file); !kept.isNull()) {
        QTimer::singleShot(0, this, [this, id, kept] { emit ready(id, kept); });
        return;
    }
    m_drawing.push_back(task);
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.push_back(std::move(task));
    }
    m_wake.notify_one();
}

void CThumbnails::drop(const QString& idStart) {
    const auto dropped = [&](const Task& task) { return task.id.startsWith(idStart); };
    std::erase_if(m_drawing, dropped);
    const std::lock_guard lock(m_mutex);
    std::erase_if(m_waiting, dropped);
    if (m_growing.startsWith(idStart)) m_progress.cancel();
}

void CThumbnails::work(const std::stop_token& stop) {
    for (;;) {
        Task task;
        CProgress progress;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, stop, [this] { return !m_waiting.empty(); });
            if (stop.stop_requested()) return;
            task = std::move(m_waiting.front());
            m_waiting.pop_front();
            m_growing = task.id;
            m_progress = CProgress(1); // the tree in the window comes first
            progress = m_progress;
        }
        try {
            emit grown(task.number, grownView(task.params, task.folder, task.age, detailFor(task.params), {}, progress), {});
        } catch (const CCancelled&) {
            // Dropped, or the end.
        } catch (const std::exception& e) {
            emit grown(task.number, nullptr, errorText(e));
        }
        const std::lock_guard lock(m_mutex);
        m_growing.clear();
    }
}

void CThumbnails::draw(quint64 number, const std::shared_ptr<const ViewModel>& view, const QString& why) {
    const auto task = std::ranges::find(m_drawing, number, &Task::number);
    if (task == m_drawing.end()) return; // dropped
    const Task found = std::move(*task);
    m_drawing.erase(task);
    m_rest.start();
    if (!view) {
        emit failed(found.id, why);
        return;
    }
    const QImage image = m_painter.paint(*view, found.pixels, ViewLook());
    if (image.isNull()) {
        emit failed(found.id, tr("There is no OpenGL to draw it."));
        return;
    }
    if (!found.file.isEmpty()) image.save(found.file);
    emit ready(found.id, image);
}

} // namespace stromar
