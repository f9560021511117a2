#include "view/PictureDialog.h"
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>

namespace stromar {

namespace {
constexpr int kMaxPixels = 8192, kMaxFrames = 1000;
QString storedKey(const char* name) { return QStringLiteral("picture/") + QLatin1String(name); }

QSpinBox* makeSide(const char* name, int pixels) {
    auto* box = new QSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setRange(16, kMaxPixels);
    box->setSuffix(QStringLiteral(" px"));
    box->setValue(QSettings().value(storedKey(name), pixels).toInt());
    return box;
}
} // namespace

QString PictureOptions::fileOf(int frame) const {
    if (frames == 1) return path;
    const QFileInfo info(path);
    return QStringLiteral("%1/%2_%3.%4")
        .arg(info.path(), info.completeBaseName(), QStringLiteral("%1").arg(frame, 4, 10, QLatin1Char('0')),
             info.suffix());
}

CPictureDialog::CPictureDialog(const QSize& windowSize, QWidget* parent)
    : QDialog(parent), m_width(makeSide("width", windowSize.width())),
      m_height(makeSide("height", windowSize.height())), m_transparent(new QCheckBox(tr("&Transparent background"))),
      m_frames(new QSpinBox) {
    setWindowTitle(tr("Save a Picture"));
    m_transparent->setChecked(QSettings().value(storedKey("transparent")).toBool());
    m_frames->setObjectName(QStringLiteral("frames"));
    m_frames->setRange(1, kMaxFrames);
    m_frames->setSpecialValueText(tr("One picture"));
    m_frames->setSuffix(tr(" frames"));
    m_frames->setToolTip(tr("More than one: the tree turns once around, each frame a numbered PNG file"));
    auto* form = new QFormLayout(this);
    form->addRow(tr("&Width"), m_width);
    form->addRow(tr("&Height"), m_height);
    form->addRow(tr("T&urntable"), m_frames);
    form->addRow(QString(), m_transparent);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &CPictureDialog::chooseFile);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void CPictureDialog::chooseFile() {
    QFileDialog dialog(this, tr("Save a Picture"), QSettings().value(storedKey("folder")).toString(),
                       tr("Pictures (*.png *.jpg)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("png"));
    dialog.selectFile(QStringLiteral("tree.png"));
    if (dialog.exec() != QDialog::Accepted) return;
    m_path = dialog.selectedFiles().front();
    QSettings settings;
    settings.setValue(storedKey("folder"), QFileInfo(m_path).path());
    settings.setValue(storedKey("width"), m_width->value());
    settings.setValue(storedKey("height"), m_height->value());
    settings.setValue(storedKey("transparent"), m_transparent->isChecked());
    accept();
}

PictureOptions CPictureDialog::options() const {
    return {{m_width->value(), m_height->value()}, m_transparent->isChecked(), m_frames->value(), m_path};
}

} // namespace stromar
