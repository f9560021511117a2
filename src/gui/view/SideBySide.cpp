#include "view/SideBySide.h"
#include "view/LodDistance.h"
#include "view/Viewport.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "work/GrownView.h"
#include "stromar/app/Prediction.h"
#include "stromar/scene/Outline.h"
#include "stromar/util/Text.h"
#include <QLocale>
#include <algorithm>

namespace stromar {

namespace {
constexpr double kVertices = 1.2e6; // of each of the others, at most; coarse levels of detail save what is beyond
constexpr std::size_t kPoints = 2000; // of a part, which tell how far a tree reaches
constexpr std::size_t kOthers = 8;  // of other seeds
constexpr double kAges[] = {0.2, 0.4, 0.6, 0.8, 1};
constexpr double kMonths[] = {1, 4.5, 7, 10};

const Detail& detailFor(const CParams& params, const CProgress& progress) {
    for (int lod = 1; lod < 3; ++lod)
        if (predictSize(params, detailOf(Model::Full, lod), progress).vertices < kVertices) return detailOf(Model::Full, lod);
    return detailOf(Model::Full, 3);
}

const osg::Vec3d kAlong(1, 0, 0); // the row, seen from the front
} // namespace

CSideBySide::CSideBySide(CViewport& viewport, QObject* parent) : QObject(parent), m_viewport(viewport) {
    connect(this, &CSideBySide::grown, this, &CSideBySide::onGrown, Qt::QueuedConnection);
    m_thread = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

CSideBySide::~CSideBySide() {
    m_thread.request_stop();
    cancel();
    m_wake.notify_all();
    m_thread.join();
}

void CSideBySide::cancel() {
    const std::lock_guard lock(m_mutex);
    m_waiting.clear();
    m_progress.cancel();
}

void CSideBySide::setRow(Row row) {
    if (row == std::exchange(m_row, row)) return;
    cancel();
    m_frameNext = true;
    m_trees.clear();
    m_toCome = 0;
    if (m_view) follow(m_view, m_folder, m_limits);
}

void CSideBySide::follow(const std::shared_ptr<const ViewModel>& view, const std::filesystem::path& folder, const SizeLimits& limits) {
    m_view = view;
    m_folder = folder;
    m_limits = limits;
    const bool wasAlone = std::exchange(m_showsOthers, m_row != Row::Alone) == false;
    if (m_row == Row::Alone && wasAlone) return;
    if (view->model->detail->model != Model::Full && m_row != Row::Alone) return; // a value is being dragged
    std::vector<Tree> wanted = treesOf(*view->model);
    const bool other = m_row == Row::Levels && m_own < m_trees.size() && m_trees[m_own].detail != view->model->detail;
    if (wanted != m_trees || other) {
        cancel();
        m_trees = std::move(wanted);
        request();
    }
    arrange();
}

/// The row and, in m_own, the tree's place in it.
std::vector<CSideBySide::Tree> CSideBySide::treesOf(const TreeModel& model) const {
    switch (m_row) {
    case Row::Alone: break;
    case Row::Seeds: return seeds(model);
    case Row::Ages: return ages(model);
    case Row::Seasons: return seasons(model);
    case Row::Levels: return levels(model);
    }
    return {};
}

std::vector<CSideBySide::Tree> CSideBySide::seeds(const TreeModel& model) const {
    std::vector<Tree> trees;
    const auto add = [&](int seed) {
        Tree& tree = trees.emplace_back(Tree{model.params, model.age, QString::number(seed), "seed_" + std::to_string(seed)});
        tree.params.common.seed = seed;
    };
    for (std::size_t i = 0; i < std::min(kOthers, m_seeds.size()); ++i) {
        if (i == kOthers / 2) add(model.params.common.seed);
        add(m_seeds[i]);
    }
    return trees;
}

std::vector<CSideBySide::Tree> CSideBySide::ages(const TreeModel& model) const {
    std::vector<Tree> trees;
    const auto add = [&](double age) {
        const QString percent = QLocale::c().toString(100 * age, 'g', 3);
        trees.push_back({model.params, age, tr("Age %1 %").arg(QLocale().toString(100 * age, 'g', 3)), "age_" + percent.toStdString()});
    };
    for (const double age : kAges) add(age);
    if (std::ranges::find(trees, model.age, &Tree::age) == trees.end()) { // instead of the one that it is nearest to
        trees.erase(std::ranges::min_element(trees, {}, [&](const Tree& tree) { return std::abs(tree.age - model.age); }));
        add(model.age);
    }
    std::ranges::sort(trees, {}, &Tree::age);
    return trees;
}

std::vector<CSideBySide::Tree> CSideBySide::seasons(const TreeModel& model) const {
    std::vector<Tree> trees;
    const auto add = [&](double month) {
        const int number = std::clamp(static_cast<int>(month), 1, 12);
        Tree& tree = trees.emplace_back(Tree{model.params, model.age, QLocale().standaloneMonthName(number), "month_" + numberText(month)});
        tree.params.common.season = static_cast<decltype(tree.params.common.season)>(month);
    };
    for (const double month : kMonths) add(month);
    const double own = model.params.common.season;
    // The tree as it is stands for the season that it is nearest to.
    const auto distance = [&](const Tree& tree) {
        const double apart = std::abs(tree.params.common.season - own);
        return std::min(apart, 12 - apart);
    };
    Tree& nearest = *std::ranges::min_element(trees, {}, distance);
    nearest.params = model.params;
    nearest.name = "month_" + numberText(own);
    nearest.label = QLocale().standaloneMonthName(std::clamp(static_cast<int>(own), 1, 12));
    return trees;
}

std::vector<CSideBySide::Tree> CSideBySide::levels(const TreeModel& model) {
    std::vector<Tree> trees;
    for (const Detail& detail : detailTable()) {
        const QString name = detail.model == Model::Simple ? tr("Simple") : tr("LOD %1").arg(detail.lod); // there is little room
        trees.push_back({model.params, model.age, name, detail.model == Model::Simple ? "simple" : "LOD" + std::to_string(detail.lod), &detail});
    }
    std::ranges::stable_sort(trees, std::greater(), [](const Tree& tree) { return tree.detail->model == Model::Full; });
    return trees;
}

/// All but the tree in the window, which has grown.
void CSideBySide::request() {
    ++m_number;
    m_toCome = 0;
    const Tree shown{m_view->model->params, m_view->model->age, {}, {}, m_row == Row::Levels ? m_view->model->detail : nullptr};
    m_own = static_cast<std::size_t>(std::ranges::find(m_trees, shown) - m_trees.begin());
    SizeLimits each = m_limits;
    each.bytes = std::min(each.bytes, SizeLimits::defaultMemory()) / double(std::max<std::size_t>(1, m_trees.size()));
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < m_trees.size(); ++i)
        if (i != m_own) tasks.push_back({m_number, i, m_trees[i].params, m_trees[i].age, m_trees[i].detail, m_folder, each});
    m_toCome = tasks.size();
    {
        const std::lock_guard lock(m_mutex);
        m_waiting = std::move(tasks);
    }
    m_wake.notify_one();
}

std::vector<RowTree> CSideBySide::trees() const {
    std::vector<RowTree> all;
    for (std::size_t i = 0; i < m_trees.size(); ++i)
        if (const Tree& tree = m_trees[i]; tree.view || i == m_own)
            all.push_back({tree.params, tree.age, m_row == Row::Levels ? tree.detail : nullptr, tree.place, tree.name});
    for (RowTree& tree : all) std::ranges::replace(tree.name, '.', '_'); // behind a point programs look for an ending or a number
    return all;
}

void CSideBySide::onGrown(quint64 row, quint64 place, const std::shared_ptr<const ViewModel>& view) {
    if (row != m_number || place >= m_trees.size()) return;
    --m_toCome;
    m_trees[place].view = view;
    arrange();
}

/// With its triangles and the distance where a program changes to it.
QString CSideBySide::levelLabel(const QString& name, const TreeModel& model, double height) const {
    QStringList lines{name, tr("%1 triangles").arg(QLocale().toString(qulonglong(model.triangleCount())))};
    const double metres = lodDistance(*model.detail, height, m_viewport.camera());
    if (metres > 0) lines.append(tr("from %1").arg(lengthText(metres)));
    return lines.join(QLatin1Char('\n'));
}

/// From the tree in the window to both sides; those that are still to come take no room.
void CSideBySide::arrange() {
    std::vector<TreeBeside> others;
    auto& labels = m_viewport.overlay().model().labels;
    labels.clear();
    const auto label = [&](const Tree& tree, const ViewModel& view, const osg::Vec3& foot) {
        const double height = reachOf(view.parts, osg::Vec3d(0, 0, 1), kPoints).second;
        labels.emplace_back(osg::Vec3d(foot) + osg::Vec3d(0, 0, height), m_row == Row::Levels ? levelLabel(tree.label, *view.model, height) : tree.label);
    };
    if (m_own < m_trees.size()) label(m_trees[m_own], *m_view, {});
    const auto [ownLeft, ownRight] = reachOf(m_view->parts, kAlong, kPoints);
    for (const int side : {-1, 1}) {
        double edge = side < 0 ? ownLeft : ownRight, foot = 0;
        for (std::size_t i = m_own + static_cast<std::size_t>(side); i < m_trees.size(); i += static_cast<std::size_t>(side)) {
            Tree& tree = m_trees[i];
            if (!tree.view) continue;
            const auto [left, right] = reachOf(tree.view->parts, kAlong, kPoints);
            foot += distanceInRow(edge, side < 0 ? right : left, std::max(tree.view->model->tree->height(), left + right));
            edge = side < 0 ? left : right;
            tree.place = side * foot;
            others.push_back({tree.view->parts, tree.view->surfaces, osg::Vec3(kAlong * (side * foot))});
            label(tree, *tree.view, others.back().place);
        }
    }
    m_viewport.showBeside(others);
    if (m_frameNext) m_viewport.frame();
    m_frameNext = m_frameNext && m_toCome > 0;
}

void CSideBySide::work(const std::stop_token& stop) {
    for (;;) {
        Task task;
        CProgress progress;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, stop, [this] { return !m_waiting.empty(); });
            if (stop.stop_requested()) return;
            task = std::move(m_waiting.front());
            m_waiting.erase(m_waiting.begin());
            progress = m_progress = CProgress(1); // the tree in the window comes first
        }
        std::shared_ptr<const ViewModel> view;
        try {
            view = grownView(task.params, task.folder, task.age, task.detail ? *task.detail : detailFor(task.params, progress), task.limits, progress);
        } catch (const CCancelled&) {
            continue;
        } catch (const std::exception&) { // too large, or not to be read: its place stays empty
        }
        emit grown(task.row, task.place, view);
    }
}

} // namespace stromar
