#include "motion/Recorder.h"
#include "stromar/app/Pictures.h"
#include "view/ImageFile.h"
#include "window/QtText.h"
#include <QCoreApplication>
#include <QFile>
#include <QMessageBox>
#include <QProcess>
#include <QProgressDialog>
#include <QTemporaryDir>
#include <future>

namespace stromar {

namespace {
constexpr std::chrono::milliseconds kTick{10};

/// The work of a thread, while the window stays alive.
template <typename Work>
auto whileAlive(Work&& work) {
    auto result = std::async(std::launch::async, std::forward<Work>(work));
    while (result.wait_for(kTick) != std::future_status::ready) QCoreApplication::processEvents();
    return result.get();
}
} // namespace

/// Makes the views of a motion, one after the other.
class CRecorder::CFrames {
public:
    CFrames(const RecordedTree& tree, const RecordOptions& options) : m_tree(tree), m_creator(true, tree.limits) {
        m_motion.frames = options.frames();
        m_motion.fps = options.fps;
        if (options.what == RecordOptions::What::Wind) m_motion.wind = tree.wind;
        if (options.what == RecordOptions::What::Fall) m_motion.felling = tree.felling;
    }

    void cancel() { m_progress.cancel(); }

    struct Frame {
        std::shared_ptr<const ViewModel> view;
        std::shared_ptr<const WindPose> pose; ///< null in still air
        double seconds, loop;
    };
    Frame make(std::size_t i) {
        if (!m_view) begin();
        const Moment& moment = m_moments[i];
        if (m_view->model->age != moment.age) grow(moment.age);
        Frame frame{m_view, nullptr, moment.seconds, m_motion.loopingWind().loop};
        if (m_moving) frame.pose = m_moving->poseAt(moment.seconds, m_progress);
        return frame;
    }

private:
    void begin() {
        grow(m_motion.sways() ? m_tree.age : m_motion.moments(m_tree.age).front().age);
        m_moments = m_motion.moments(m_tree.age, m_moving ? m_moving->fallSeconds() : 0);
    }

    void grow(double age) {
        m_creator.setAge(age);
        auto view = std::make_shared<ViewModel>();
        view->model = m_creator.create(m_tree.params, detailOf(Model::Full), m_progress);
        if (m_motion.sways()) {
            m_moving.emplace(view->model, m_motion, m_progress);
            view->sway = m_moving->sway();
            view->model = view->sway->model; // perhaps cut
        }
        view->parts = m_parts = viewPartsOf(*view->model, m_parts, m_progress);
        makePictures(*view->model, m_tree.folder, m_progress);
        for (const ViewPart& part : view->parts) {
            auto& maps = m_surfaces[static_cast<std::size_t>(part.surface)];
            if (!maps) maps = readSurface(part.surface, textureOf(*view->model, part.surface, m_tree.folder).string());
        }
        view->surfaces = m_surfaces;
        m_view = std::move(view);
    }

    const RecordedTree& m_tree;
    Motion m_motion;
    std::optional<CMovingModel> m_moving; ///< null while it grows
    std::vector<Moment> m_moments;        ///< of the frames
    CTreeCreator m_creator;
    CProgress m_progress;
    std::vector<ViewPart> m_parts;
    std::array<std::shared_ptr<const SurfaceMaps>, kSurfaces.size()> m_surfaces;
    std::shared_ptr<const ViewModel> m_view;
};

void CRecorder::record(const RecordedTree& tree, const RecordOptions& options) {
    if (m_busy) return;
    m_busy = true;
    const int frames = options.frames();
    QProgressDialog progress(tr("Recording"), tr("Cancel"), 0, frames + (options.video ? 1 : 0), &m_window);
    progress.setWindowModality(Qt::WindowModal);
    progress.setMinimumDuration(0);
    progress.setValue(0);
    try {
        const QTemporaryDir folder;
        const int written = writeFrames(
            tree, options, options.video ? folder.filePath(QStringLiteral("frame.png")) : options.path, progress);
        const bool cancelled = progress.wasCanceled();
        if (options.video && !cancelled)
            makeVideo(folder.filePath(QStringLiteral("frame_")), options, progress);
        if (cancelled)
            emit notice(options.video
                            ? tr("Recording cancelled; no file was changed")
                            : tr("Recording cancelled: %1 of %n frame(s) are saved", nullptr, frames).arg(written));
        else
            emit notice(options.video ? tr("Saved %1").arg(options.path) : tr("Saved %n frame(s)", nullptr, written));
    } catch (const std::exception& e) {
        progress.close();
        QMessageBox::critical(&m_window, tr("Cannot record"), errorText(e));
    }
    m_busy = false;
}

int CRecorder::writeFrames(const RecordedTree& tree, const RecordOptions& options, const QString& path,
                           QProgressDialog& progress) {
    CFrames frames(tree, options);
    const QObject listener; // goes before the frames do
    connect(&progress, &QProgressDialog::canceled, &listener, [&frames] { frames.cancel(); });
    COffscreenPainter painter;
    RecordOptions pictures = options;
    pictures.video = false;
    pictures.path = path;
    int written = 0;
    try {
        for (; written < options.frames() && !progress.wasCanceled(); ++written) {
            const auto frame =
                whileAlive([&frames, written] { return frames.make(static_cast<std::size_t>(written)); });
            const QImage image =
                painter.paint(*frame.view, options.size, tree.look, tree.camera, frame.pose, frame.seconds, frame.loop);
            const QString file = pictures.fileOf(written);
            if (image.isNull()) throw CError("there is no OpenGL to draw it");
            if (!writeImage(image, file)) throw CError(tr("%1 cannot be written.").arg(file).toStdString());
            progress.setValue(written + 1);
        }
    } catch (const CCancelled&) {
        // What is there stays.
    }
    return written;
}

/// Into a file beside the wanted one, which it replaces when all went well.
void CRecorder::makeVideo(const QString& namesBegin, const RecordOptions& options, QProgressDialog& progress) {
    progress.setLabelText(tr("Making the video"));
    const QString made = options.path + QStringLiteral(".part.mp4");
    const qsizetype width = std::max<qsizetype>(4, QString::number(options.frames()).size());
    const QString pattern = namesBegin + QStringLiteral("%0") + QString::number(width) + QStringLiteral("d.png");
    QProcess ffmpeg;
    ffmpeg.start(videoProgram(),
                 {QStringLiteral("-y"), QStringLiteral("-loglevel"), QStringLiteral("error"),
                  QStringLiteral("-framerate"), QString::number(options.fps), QStringLiteral("-i"), pattern,
                  QStringLiteral("-vf"), QStringLiteral("pad=ceil(iw/2)*2:ceil(ih/2)*2"), QStringLiteral("-pix_fmt"),
                  QStringLiteral("yuv420p"), made});
    while (!ffmpeg.waitForFinished(20)) {
        QCoreApplication::processEvents();
        if (progress.wasCanceled()) ffmpeg.kill();
        if (ffmpeg.state() == QProcess::NotRunning) break;
    }
    const bool good = ffmpeg.exitStatus() == QProcess::NormalExit && ffmpeg.exitCode() == 0;
    if (good) {
        QFile::remove(options.path);
        if (QFile::rename(made, options.path)) return;
    }
    QFile::remove(made);
    const QString why = QString::fromUtf8(ffmpeg.readAllStandardError()).trimmed();
    throw CError(tr("ffmpeg could not make the video. %1").arg(why).toStdString());
}

} // namespace stromar
