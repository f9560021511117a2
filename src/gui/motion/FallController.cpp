#include "motion/FallController.h"
#include "motion/Timeline.h"
#include "view/Viewport.h"
#include "window/QtText.h"
#include "work/GrowthController.h"
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSettings>

namespace stromar {

CFallController::CFallController(CViewport& viewport, CTimeline& timeline, CGrowthController& growth, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_timeline(timeline), m_growth(growth) {
    connect(&m_timeline, &CTimeline::fallMoved, this, &CFallController::moveTo);
}

bool CFallController::askAndFell(QWidget* parent) {
    QDialog dialog(parent);
    dialog.setWindowTitle(tr("Fell the tree"));
    const auto number = [&](const char* name, double min, double max, const QString& suffix) {
        auto* box = new QDoubleSpinBox;
        box->setObjectName(QLatin1String(name));
        box->setRange(min, max);
        box->setDecimals(suffix == QStringLiteral("°") ? 0 : 2);
        box->setSuffix(suffix);
        box->setValue(QSettings().value(QStringLiteral("fell/") + QLatin1String(name)).toDouble());
        return box;
    };
    const double tall = m_view ? m_view->model->tree->height() : 10;
    auto* direction = number("fellDirection", -180, 180, QStringLiteral("°"));
    auto* height = number("fellHeight", 0, std::max(0.01, 0.9 * tall), tr(" m"));
    direction->setToolTip(tr("Where it falls to: 0 to the right, 90 away from the front"));
    height->setToolTip(tr("Of the cut above the ground; 0 fells it with its foot"));
    QFormLayout form(&dialog);
    form.addRow(tr("&Direction"), direction);
    form.addRow(tr("&Height of the cut"), height);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("&Fell"));
    form.addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    if (dialog.exec() != QDialog::Accepted) return false;
    for (const QDoubleSpinBox* box : {direction, height})
        QSettings().setValue(QStringLiteral("fell/") + box->objectName(), box->value());
    fell({direction->value(), height->value()});
    return true;
}

void CFallController::fell(const Felling& felling) {
    m_felling = felling;
    m_playNext = true;
    emit changed(true);
    m_growth.setSwaying(true); // a model that can fall comes, if it is not there
    if (m_view && m_view->sway) show(m_view);
}

void CFallController::raise() {
    if (!m_felling) return;
    m_felling.reset();
    m_fall.reset();
    m_cut.reset();
    m_timeline.showLife();
    if (m_view) m_viewport.show(m_view->parts);
    emit changed(false);
}

void CFallController::show(const std::shared_ptr<const ViewModel>& view) {
    m_view = view;
    if (!m_felling || !view->sway) return m_viewport.show(view->parts);
    m_fall.emplace(view->sway->table, *m_felling);
    m_cut = felled(view->sway, *m_fall);
    m_viewport.show(viewPartsOf(*m_cut->model, view->parts, CProgress()));
    m_timeline.showFall(m_fall->seconds());
    moveTo(m_timeline.fallSeconds());
    if (std::exchange(m_playNext, false)) m_timeline.setPlaying(true);
}

void CFallController::moveTo(double seconds) {
    if (!m_fall || !m_cut) return;
    auto pose = std::make_shared<WindPose>();
    m_fall->pose(seconds, *pose, CProgress());
    m_viewport.setPose(m_cut, pose, seconds, 0);
}

} // namespace stromar
