#pragma once
#include "stromar/params/ParamTable.h"
#include <QWidget>
#include <vector>

class QLabel;
class QMenu;

namespace stromar {

class CParamEditor;

/// One row of the panel: label, editor and, beside it, the variation of the value. The label resets on a double click;
/// the right button has the rest. Its tool tip draws what the value does.
class CParamRow : public QWidget {
    Q_OBJECT
public:
    explicit CParamRow(const ParamRef& ref, QWidget* parent = nullptr);

    /// The value and, if it has one, its variation.
    const std::vector<CParamEditor*>& editors() const { return m_editors; }
    const ParamRef& ref() const;
    /// Shows values without telling; a mark where they differ from `saved`; greyed when they do nothing.
    void show(const CParams& params, const CParams& saved);
    using QWidget::show;
    void setLocked(bool locked);
    bool locked() const { return m_locked; }
    /// Whether the value differs from the saved one.
    bool marked() const { return m_marked; }
    /// Whether every word is in the label, the key, the section or the name of the tab.
    bool matches(const QStringList& words, const QString& tab) const;
    int labelWidth() const;
    /// A longer label is cut; the tool tip has it.
    void setLabelWidth(int width);
    void setNarrow(bool narrow);

signals:
    void edited(const stromar::ParamRef& ref, const stromar::ParamValue& value, int gesture);
    /// Several values at once: one step. The text names it in the history.
    void assigned(const QString& text, const stromar::ParamValues& values);
    void released();
    void lineTouched(const stromar::ParamRef& ref, int line);
    void rangeHeld(const stromar::ParamRef& ref, double low, double high);
    void lockToggled(bool locked);

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void addEditor(CParamEditor* editor);
    void showToolTip(const QPoint& at);
    QString helpText() const;
    void assign(const QString& text, const CParams& from);
    void addPasteMenu(QMenu& menu);
    void copy() const;
    void reset();

    std::vector<CParamEditor*> m_editors;
    QWidget* m_mark;
    QLabel* m_label;
    CParams m_params, m_saved;
    QString m_inactive;
    bool m_locked = false, m_marked = false;
};

} // namespace stromar
