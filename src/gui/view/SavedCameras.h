#pragma once
#include <QObject>
#include <QString>

class QMenu;
class QWidget;

namespace stromar {

class CViewport;

/// Views of trees under names, kept between runs.
class CSavedCameras : public QObject {
    Q_OBJECT
public:
    CSavedCameras(CViewport& viewport, QObject* parent);

    /// A menu that shows and forgets them; filled each time that it opens.
    void addTo(QMenu& menu);
    /// Asks for a name.
    void save(QWidget* parent);
    /// Under a name, in place of one that has it.
    void saveAs(const QString& name);

signals:
    void orthographicWanted(bool on);

private:
    void fill(QMenu& menu);
    void goTo(const QString& name);
    static void forget(const QString& name);

    CViewport& m_viewport;
};

} // namespace stromar
