#pragma once
#include "stromar/params/ParamTable.h"
#include <QTimer>
#include <QWidget>
#include <map>
#include <optional>
#include <vector>

class QAbstractButton;
class QLabel;
class QLineEdit;
class QMenu;
class QTabWidget;
class QVBoxLayout;

namespace stromar {

class CParamEditor;
class CParamRow;
struct ValueSet;

/// All values of a tree in tabs, made from the tables of its method. Knows nothing of trees or files.
class CParamPanel : public QWidget {
    Q_OBJECT
public:
    explicit CParamPanel(QWidget* parent = nullptr);

    /// Shows the values without telling; marks those that differ from `saved`. Values of another method get other tabs.
    void showParams(const CParams& params, const CParams& saved);
    CParamEditor* editor(const ParamRef& ref) const;
    CParamRow* row(const ParamRef& ref) const;
    QTabWidget& tabs() { return *m_tabs; }
    QLineEdit& filter() { return *m_filter; }
    /// Says that nothing was found.
    QLabel& nothing() { return *m_nothing; }
    /// Whether a slider is held.
    bool held() const;
    /// Whether randomising leaves the value alone.
    bool locked(const ParamRef& ref) const;
    /// Of this tree, by a name that stays the same; kept between runs. After its values are shown.
    void showLocksOf(const QString& tree);
    /// The locks as they are belong to this tree from now on; without a name they are forgotten with it.
    void keepLocksFor(const QString& tree);
    /// The tab of a group; `level` counts for Branches.
    int tabOf(Group group, int level = 1) const;
    /// Opens the tab of a generation of stems, or of the leaves.
    void showGeneration(int generation);
    void showLeaves();
    /// Opens the tab of a value and gives it the focus.
    void showParam(const ParamRef& ref);
    /// Opens the tab of the first curve, if there is one.
    void showCurves();
    /// Of all curves; folded or not.
    std::vector<CParamEditor*> curves() const;
    /// Opens the tab of a text and marks one of its lines.
    void showLine(const ParamRef& ref, int line);

    QSize sizeHint() const override;

signals:
    void edited(const stromar::ParamRef& ref, const stromar::ParamValue& value, int gesture);
    void assigned(const QString& text, const stromar::ParamValues& values);
    void released();
    /// The user wants to choose a file for this path.
    void pathWanted(const stromar::ParamRef& text);
    /// The user wants to change its recipe.
    void workshopWanted(const stromar::ParamRef& text);
    /// The cursor is in a line of a text; 0: away.
    void lineTouched(const stromar::ParamRef& ref, int line);
    /// A point of a curve is held that acts between these x, which are not included.
    void rangeHeld(const stromar::ParamRef& ref, double low, double high);
    /// A curve was unfolded.
    void curveUnfolded();
    /// The value under the mouse, else the one with the focus.
    void touched(const std::optional<stromar::ParamRef>& ref);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Rows under one heading that folds them away.
    struct Section {
        QAbstractButton* heading;
        int tab;
        std::vector<QWidget*> rows;
        std::vector<ParamRef> refs; ///< that are copied with it
    };

    void showBlock(const ParamBlock& block);
    void addTab(const ParamPage& page);
    void addSection(std::string_view title);
    void addRow(const ParamRef& ref);
    void addValues(QMenu& menu, const ValueSet& set);
    ValueSet setOfTab(int tab) const;
    ValueSet setOfSection(const Section& section) const;
    void addText(const ParamRef& ref);
    void groupCurves();
    void addLeafSection(const ParamPage& page);
    void placeLeafRows(const CParams& params);
    void move(CParamRow* row, Section& from, Section& to);
    Section& sectionOf(const QWidget* row);
    void alignLabels(const QWidget& page) const;
    void setNarrow(bool narrow);
    void finishTab();
    QWidget* makePathEditor(const ParamRef& ref, QLineEdit* line);
    QMenu* makeBuiltInMenu(const ParamRef& ref, QWidget* parent);
    void updateVisibility();
    void setLocked(const ParamRef& ref, bool locked);
    void updateTouched();

    const ParamBlock* m_block = nullptr;
    CParams m_params; ///< that are shown
    QLineEdit* m_filter;
    QLabel* m_nothing; ///< in place of the tabs
    QTabWidget* m_tabs;
    QVBoxLayout* m_page = nullptr;               ///< of the tab that is being filled
    std::vector<std::pair<Group, int>> m_groups; ///< by tab, with the level
    std::vector<Section> m_sections;
    std::map<CParamRow*, std::size_t> m_leafRows; ///< that may place leaves: the section they belong to else
    std::optional<std::size_t> m_leafSection;     ///< where they are then
    std::vector<CParamRow*> m_rows;
    std::vector<std::pair<ParamRef, QLineEdit*>> m_lines;
    CParamRow* m_hovered = nullptr;
    bool m_narrow = false;
    QString m_locksOf;
    int m_wide = 0; ///< pixels of this panel from which on rows need not be narrow
    QTimer m_touch; ///< the mouse crosses the gaps between rows
};

} // namespace stromar
