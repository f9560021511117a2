#pragma once
#include "stromar/params/ParamTable.h"
#include <QFrame>

namespace stromar {

/// Stands in the picture when the program starts: the ways to begin. It goes when one is taken, or is closed, and keeps to the
/// lower edge of the widget it lies on.
class CWelcomeCard : public QFrame {
    Q_OBJECT
public:
    explicit CWelcomeCard(QWidget* over);

    /// Whether the user has not yet closed it for good.
    static bool wanted();

    /// For good: it does not come again by itself.
    void finish();

signals:
    /// It covers so many pixels of the lower edge.
    void placed(int covered);
    void presetWanted(const QString& path);
    void allPresetsWanted();
    void fileWanted();
    void methodWanted(const stromar::ParamBlock& block);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeHead();
    QWidget* makePresets();
    QWidget* makeWays();
    void place();
};

} // namespace stromar
