#include "work/TreeCreatorThread.h"
#include "window/QtText.h"
#include "stromar/app/Methods.h"
#include "stromar/texture/Draw.h"
#include <algorithm>

namespace stromar {

namespace {
/// When steps follow each other faster than trees grow, cancelling each would show nothing at all: a simple model may
/// finish when the last picture is older than this.
constexpr std::chrono::milliseconds kPictureAge{120};
constexpr std::chrono::seconds kIdle{2};
} // namespace

CTreeCreatorThread::CTreeCreatorThread(std::unique_ptr<CTreeCreator> creator, QObject* parent)
    : QThread(parent), m_creator(std::move(creator)), m_lastResult(Clock::now()) {
    qRegisterMetaType<std::shared_ptr<const ViewModel>>();
    qRegisterMetaType<std::shared_ptr<const SurfaceMaps>>();
    qRegisterMetaType<std::shared_ptr<const TooLargeTree>>();
    qRegisterMetaType<Surface>();
    start();
}

CTreeCreatorThread::~CTreeCreatorThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_quit = true;
        if (m_running) m_running->cancel();
    }
    m_wake.notify_one();
    wait();
}

void CTreeCreatorThread::request(Request request) {
    {
        const std::lock_guard lock(m_mutex);
        request.anew = request.anew || (m_wanted && m_wanted->anew);
        m_wanted = std::move(request);
        if (m_running && !mayFinish()) m_running->cancel();
    }
    m_wake.notify_one();
}

void CTreeCreatorThread::cancel() {
    const std::lock_guard lock(m_mutex);
    m_wanted.reset();
    if (m_running) m_running->cancel();
}

void CTreeCreatorThread::setThreads(int threads) {
    const std::lock_guard lock(m_mutex);
    m_threads = threads;
}

bool CTreeCreatorThread::mayFinish() const { return m_runningSimple && Clock::now() - m_lastResult > kPictureAge; }

std::optional<double> CTreeCreatorThread::progress() const {
    const std::lock_guard lock(m_mutex);
    return m_running ? std::optional(m_running->done()) : std::nullopt;
}

std::optional<CTreeCreatorThread::Request> CTreeCreatorThread::nextRequest() {
    std::unique_lock lock(m_mutex);
    m_running.reset();
    const auto awake = [this] { return m_wanted || m_quit; };
    if (!m_wake.wait_for(lock, kIdle, awake)) {
        lock.unlock();
        freeMemory();
        lock.lock();
        m_wake.wait(lock, awake);
    }
    if (m_quit) return {};
    std::optional<Request> request = std::move(m_wanted);
    m_wanted.reset();
    m_running = CProgress(m_threads);
    m_runningSimple = request->detail->model == Model::Simple;
    return request;
}

/// When one value alone makes the tree too large, the nearest that does not is on offer, else the least change that helps.
TooLargeTree CTreeCreatorThread::refusedTree(const Request& request, const Prediction& size) const {
    TooLargeTree tree{request.params, size, {}};
    std::vector<ParamRef> changed;
    for (const ParamRef& ref : allParams(tree.params.block()))
        if (&m_fitting.block() == &tree.params.block() && ref.differs(tree.params, m_fitting)) changed.push_back(ref);
    if (changed.size() == 1 && changed.front().info->numeric())
        tree.fits = {changed.front(), nearestThatFits(tree.params, changed.front(), changed.front().get(m_fitting),
                                                      detailOf(Model::Full), request.limits)};
    else if (methodOf(tree.params).boundIsQuick)
        tree.fits = leastChangeThatFits(tree.params, detailOf(Model::Full), request.limits, CProgress());
    return tree;
}

/// While the hand rests, only what is shown is kept.
void CTreeCreatorThread::freeMemory() {
    if (m_shown) m_creator->forgetOthers(*m_shown);
    if (const std::uintmax_t most = m_pictureCache) trimPictureCache(most);
}

void CTreeCreatorThread::run() {
    while (const std::optional<Request> request = nextRequest()) {
        CProgress progress;
        {
            const std::lock_guard lock(m_mutex);
            progress = *m_running;
        }
        try {
            const auto view = create(*request, progress);
            {
                const std::lock_guard lock(m_mutex);
                m_lastResult = Clock::now();
                m_runningSimple = false; // what follows may be cancelled, at once where a request waits
                if (m_wanted) m_running->cancel();
            }
            emit created(view);
            // The tree does not wait for its bark. Leaves in small follow a dragged month: no newer step cancels them.
            readSurfaces(*request);
            makePictures(request->params, CProgress(progress.threads()), PictureQuality::Preview);
            readSurfaces(*request);
            makePictures(request->params, progress);
            readSurfaces(*request);
            makeTwigs(*view->model, request->folder, progress);
        } catch (const CCancelled&) {
            // The next request says what to do instead.
        } catch (const CTooLarge& e) {
            emit tooLarge(std::make_shared<const TooLargeTree>(refusedTree(*request, e.size())));
        } catch (const std::exception& e) {
            emit failed(errorText(e));
        }
    }
}

/// Tells of the pictures that are there and were not told of: of a recipe's the whole one, else the small one.
void CTreeCreatorThread::readSurfaces(const Request& request) {
    const auto isThere = [](const std::filesystem::path& file) {
        std::error_code problem;
        return std::filesystem::exists(file, problem);
    };
    for (const Surface surface : kSurfaces) {
        if (!hasSurface(request.params, surface)) continue;
        std::filesystem::path& read = m_read[static_cast<std::size_t>(surface)];
        std::filesystem::path wanted = textureOf(request.params, surface, request.folder);
        const bool drawn = isRecipe(pictureOf(request.params, surface));
        if (drawn && !isThere(wanted)) wanted = textureOf(request.params, surface, {}, PictureQuality::Preview);
        if (wanted == read || (drawn && !isThere(wanted))) continue;
        read = wanted;
        emit surfaceRead(surface, readSurface(surface, wanted.string()));
    }
}

/// The picture of the twigs on cards, which only coarse levels of detail have.
void CTreeCreatorThread::makeTwigs(const TreeModel& model, const std::filesystem::path& folder, const CProgress& progress) {
    if (!model.cards) return;
    stromar::makePictures(model, folder, progress);
    std::filesystem::path& read = m_read[static_cast<std::size_t>(Surface::Twig)];
    const std::filesystem::path file = textureOf(model, Surface::Twig, folder, progress);
    if (file == std::exchange(read, file)) return;
    emit surfaceRead(Surface::Twig, readSurface(Surface::Twig, file.string()));
}

std::shared_ptr<const ViewModel> CTreeCreatorThread::create(const Request& request, const CProgress& progress) {
    if (request.anew) m_creator->forget();
    refuseTooLarge(request.params, detailOf(Model::Full), request.limits, progress); // also where the simple one would fit
    m_creator->setLimits(request.limits);
    m_creator->setAge(request.age);
    m_fitting = request.params;
    auto view = std::make_shared<ViewModel>();
    view->model = m_creator->create(request.params, *request.detail, progress);
    if (view->model->twig) view->model->twig->looks->get(progress); // cards are not seen for long without the picture that needs it
    m_shown = request.detail;
    m_parts = view->parts = viewPartsOf(*view->model, m_parts, progress);
    m_sway = view->sway = request.sways ? swayOf(view->model, m_sway.get(), progress) : nullptr;
    return view;
}

} // namespace stromar
