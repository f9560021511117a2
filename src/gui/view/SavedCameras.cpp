#include "view/SavedCameras.h"
#include "view/Viewport.h"
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>

namespace stromar {

namespace {
constexpr const char* kGroup = "cameras";
constexpr int kNumbers = 8; // of a camera: centre, distance, axes

QVariantList numbersOf(const CCamera& camera) {
    const osg::Vec3d& centre = camera.centre();
    const osg::Quat& axes = camera.axes();
    return {centre.x(), centre.y(), centre.z(), camera.distance(), axes.x(), axes.y(), axes.z(), axes.w()};
}

QStringList names() {
    QSettings settings;
    settings.beginGroup(QLatin1String(kGroup));
    return settings.childKeys();
}

/// Where slashes would make groups of their own.
QString keyOf(QString name) {
    return QStringLiteral("%1/%2").arg(QLatin1String(kGroup), name.replace(QLatin1Char('/'), QChar(0x2215)).replace(QLatin1Char('\\'), QChar(0x2216)));
}
} // namespace

CSavedCameras::CSavedCameras(CViewport& viewport, QObject* parent) : QObject(parent), m_viewport(viewport) {}

void CSavedCameras::addTo(QMenu& menu) {
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] { fill(menu); });
}

void CSavedCameras::fill(QMenu& menu) {
    menu.clear();
    const QStringList saved = names();
    for (const QString& name : saved) menu.addAction(name, this, [this, name] { goTo(name); });
    if (saved.isEmpty()) {
        menu.addAction(tr("None yet: Save Camera keeps one"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    QMenu* forgotten = menu.addMenu(tr("Remove"));
    for (const QString& name : saved) forgotten->addAction(name, this, [name] { forget(name); });
}

void CSavedCameras::save(QWidget* parent) {
    bool wanted = false;
    const QString suggestion = tr("Camera %1").arg(names().size() + 1);
    const QString name = QInputDialog::getText(parent, tr("Save Camera"), tr("Name of the view"), QLineEdit::Normal, suggestion, &wanted).trimmed();
    if (!wanted || name.isEmpty()) return;
    const bool taken = QSettings().contains(keyOf(name));
    if (taken && QMessageBox::question(parent, tr("Save Camera"), tr("There is a view called “%1” already. Replace it?").arg(name)) != QMessageBox::Yes) return;
    saveAs(name);
}

void CSavedCameras::saveAs(const QString& name) {
    const CCamera& camera = m_viewport.camera();
    QSettings().setValue(keyOf(name), QVariantList(numbersOf(camera)) << camera.orthographic());
}

void CSavedCameras::goTo(const QString& name) {
    const QVariantList saved = QSettings().value(keyOf(name)).toList();
    if (saved.size() <= kNumbers) return; // written by hand
    const auto number = [&](int i) { return saved[i].toDouble(); };
    CCamera camera = m_viewport.camera();
    camera.place({number(0), number(1), number(2)}, number(3), {number(4), number(5), number(6), number(7)});
    m_viewport.setCamera(camera);
    emit orthographicWanted(saved[kNumbers].toBool());
}

void CSavedCameras::forget(const QString& name) { QSettings().remove(keyOf(name)); }

} // namespace stromar
