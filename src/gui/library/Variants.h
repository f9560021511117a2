#pragma once
#include "stromar/params/ParamTable.h"
#include <QTimer>
#include <QWidget>
#include <array>
#include <filesystem>
#include <optional>

class QComboBox;
class QGridLayout;
class QListWidget;
class QSpinBox;
class QToolButton;

namespace stromar {

class CThumbnails;

/// Other trees of the same kind: nine seeds to choose from, the seeds that were liked, the tree at five ages, and random values.
class CVariants : public QWidget {
    Q_OBJECT
public:
    static constexpr int kSheet = 9;
    static constexpr std::array<double, 5> kAges{0.2, 0.4, 0.6, 0.8, 1};

    explicit CVariants(CThumbnails& thumbnails, QWidget* parent = nullptr);

    void showParams(const CParams& params, const std::filesystem::path& folder);
    /// Whether a person sees it: trees are grown only then. Qt takes docks behind another's tab for visible.
    void setShown(bool shown);
    const std::array<int, kSheet>& seeds() const { return m_seeds; }

signals:
    void seedChosen(int seed);
    void likedChanged(const QString& seeds);
    void ageChosen(double age);
    /// Move the values of these levels (nothing: all groups) by chance; `amount` 0..1.
    void randomiseWanted(const std::vector<stromar::ParamRef>& refs, double amount);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void throwSheet();
    bool stale() const { return m_stale || m_agesStale || m_likedStale; }
    void requestSheet();
    void requestLiked();
    void requestAges();
    void showThumbnail(const QString& id, const QImage& image);
    void setLiked(const std::vector<int>& seeds);
    void fillGroups();
    void randomise();
    QSize pictureSize() const;
    void layOut(QGridLayout& grid, std::span<QToolButton* const> cells, int most) const;
    QWidget* makeSheet();
    QWidget* makeLiked();
    QWidget* makeAges();
    QToolButton* makeCell(const QString& name);
    QWidget* makeRandomiser();

    CThumbnails& m_thumbnails;
    QGridLayout *m_sheetGrid = nullptr, *m_agesGrid = nullptr;
    std::array<QToolButton*, kSheet> m_cells{};
    std::array<int, kSheet> m_seeds{};
    std::array<QToolButton*, kAges.size()> m_ages{};
    QListWidget* m_liked = nullptr;
    QToolButton* m_like = nullptr;
    QComboBox* m_level = nullptr;
    QSpinBox* m_amount = nullptr;
    QTimer m_pause;
    const ParamBlock* m_block = nullptr;
    CParams m_params;
    std::filesystem::path m_folder;
    bool m_stale = true;      ///< the sheet
    bool m_agesStale = true, m_likedStale = true;
    bool m_shown = false;
};

/// The numbers of a list of seeds; what is no number is left out.
std::vector<int> seedsFrom(const std::string& text);

} // namespace stromar
