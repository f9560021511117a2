#pragma once
#include "stromar/app/ExportRow.h"
#include "work/TreeCreatorThread.h"
#include <QObject>
#include <condition_variable>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

namespace stromar {

class CViewport;

/// Trees of one kind in a row: the one in the window among others that differ in seed, age, season or level of detail. The others grow on a thread
/// of their own after the full model and stand still in the wind.
class CSideBySide : public QObject {
    Q_OBJECT
public:
    enum class Row { Alone, Seeds, Ages, Seasons, Levels };

    explicit CSideBySide(CViewport& viewport, QObject* parent);
    /// Cancels and waits.
    ~CSideBySide() override;

    void setRow(Row row);
    Row row() const { return m_row; }
    /// The seeds of a row, without the tree's own.
    void setSeeds(std::span<const int> seeds) { m_seeds.assign(seeds.begin(), seeds.end()); }
    /// After the viewport got a model of the tree. Others follow a full one; all together keep to the limits.
    void follow(const std::shared_ptr<const ViewModel>& view, const std::filesystem::path& folder, const SizeLimits& limits);
    /// All that stand there, from left to right, for files; empty when the tree is alone.
    std::vector<RowTree> trees() const;
    /// Whether some are still to come.
    bool busy() const { return m_toCome > 0; }

signals:
    void grown(quint64 row, quint64 place, std::shared_ptr<const stromar::ViewModel> view); ///< inside

private:
    /// One of a row.
    struct Tree {
        CParams params;
        double age = 1;
        QString label;
        std::string name; ///< in files
        const Detail* detail = nullptr; ///< null: what keeps it small
        std::shared_ptr<const ViewModel> view{};
        double place = 0; ///< of its foot, from the tree in the window
        bool operator==(const Tree& other) const { return params == other.params && age == other.age && detail == other.detail; }
    };
    struct Task {
        quint64 row, place;
        CParams params;
        double age;
        const Detail* detail;
        std::filesystem::path folder;
        SizeLimits limits;
    };
    std::vector<Tree> treesOf(const TreeModel& model) const;
    std::vector<Tree> seeds(const TreeModel& model) const;
    std::vector<Tree> ages(const TreeModel& model) const;
    std::vector<Tree> seasons(const TreeModel& model) const;
    static std::vector<Tree> levels(const TreeModel& model);
    void request();
    void onGrown(quint64 row, quint64 place, const std::shared_ptr<const ViewModel>& view);
    void arrange();
    QString levelLabel(const QString& name, const TreeModel& model, double height) const;
    void work(const std::stop_token& stop);
    void cancel();

    CViewport& m_viewport;
    Row m_row = Row::Alone;
    std::vector<int> m_seeds;
    std::shared_ptr<const ViewModel> m_view;
    std::filesystem::path m_folder;
    SizeLimits m_limits;
    std::vector<Tree> m_trees; ///< from left to right
    std::size_t m_own = 0;     ///< the place of the tree in the window
    bool m_frameNext = false, m_showsOthers = false;
    quint64 m_number = 0; ///< of the row
    std::size_t m_toCome = 0;
    std::mutex m_mutex; ///< guards the rest but the thread
    std::condition_variable_any m_wake;
    std::vector<Task> m_waiting;
    CProgress m_progress;
    std::jthread m_thread; ///< last: it stops first
};

} // namespace stromar
