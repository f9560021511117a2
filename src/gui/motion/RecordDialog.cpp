#include "motion/RecordDialog.h"
#include "stromar/app/Motion.h"
#include "window/QtText.h"
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QStandardPaths>
#include <cmath>

namespace stromar {

namespace {
constexpr int kMaxPixels = 8192;
QString storedKey(const char* name) { return QStringLiteral("record/") + QLatin1String(name); }

template <typename Box, typename Value>
Box* makeNumber(const char* name, Value min, Value max, Value standard, const QString& suffix) {
    auto* box = new Box;
    box->setObjectName(QLatin1String(name));
    box->setRange(min, max);
    box->setSuffix(suffix);
    box->setValue(QSettings().value(storedKey(name), standard).template value<Value>());
    return box;
}
} // namespace

QString videoProgram() { return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")); }

int RecordOptions::frames() const { return std::max(1, static_cast<int>(std::lround(seconds * fps))); }

QString RecordOptions::fileOf(int frame) const {
    return video
               ? path
               : fromPath(framePath(toPath(path), static_cast<std::size_t>(frame), static_cast<std::size_t>(frames())));
}

CRecordDialog::CRecordDialog(const QSize& windowSize, bool windBlows, bool felled, QWidget* parent)
    : QDialog(parent), m_what(new QComboBox),
      m_width(makeNumber<QSpinBox>("width", 16, kMaxPixels, windowSize.width(), tr(" px"))),
      m_height(makeNumber<QSpinBox>("height", 16, kMaxPixels, windowSize.height(), tr(" px"))),
      m_fps(makeNumber<QSpinBox>("fps", 1, 120, 25, QString())),
      m_seconds(makeNumber<QDoubleSpinBox>("seconds", 0.1, 600.0, 6.0, tr(" s"))), m_kind(new QComboBox) {
    setWindowTitle(tr("Record"));
    m_what->setObjectName(QStringLiteral("what"));
    m_what->addItem(tr("Growth, up to the age that is shown"));
    m_what->addItem(tr("Wind, in a loop"));
    if (felled) m_what->addItem(tr("The fall"));
    m_what->setCurrentIndex(felled ? 2 : windBlows ? 1 : 0);
    m_kind->setObjectName(QStringLiteral("kind"));
    m_kind->addItem(tr("Numbered pictures (PNG)"));
    auto* form = new QFormLayout(this);
    form->addRow(tr("&What"), m_what);
    form->addRow(tr("Wid&th"), m_width);
    form->addRow(tr("&Height"), m_height);
    form->addRow(tr("&Length"), m_seconds);
    form->addRow(tr("&Frames per second"), m_fps);
    form->addRow(tr("&As"), m_kind);
    if (!videoProgram().isEmpty())
        m_kind->addItem(tr("Video (MP4)"));
    else {
        auto* missing = new QLabel(tr("For videos, install ffmpeg."));
        missing->setObjectName(QStringLiteral("noVideo"));
        form->addRow(QString(), missing);
    }
    m_kind->setCurrentIndex(std::min(QSettings().value(storedKey("kind")).toInt(), m_kind->count() - 1));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &CRecordDialog::chooseFile);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void CRecordDialog::chooseFile() {
    const bool video = m_kind->currentIndex() == 1;
    QFileDialog dialog(this, tr("Record"), QSettings().value(storedKey("folder")).toString(),
                       video ? tr("Videos (*.mp4)") : tr("Pictures (*.png)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(video ? QStringLiteral("mp4") : QStringLiteral("png"));
    dialog.selectFile(video ? QStringLiteral("tree.mp4") : QStringLiteral("tree.png"));
    if (dialog.exec() != QDialog::Accepted) return;
    m_path = dialog.selectedFiles().front();
    QSettings settings;
    settings.setValue(storedKey("folder"), QFileInfo(m_path).path());
    settings.setValue(storedKey("width"), m_width->value());
    settings.setValue(storedKey("height"), m_height->value());
    settings.setValue(storedKey("fps"), m_fps->value());
    settings.setValue(storedKey("seconds"), m_seconds->value());
    settings.setValue(storedKey("kind"), m_kind->currentIndex());
    accept();
}

RecordOptions CRecordDialog::options() const {
    return {static_cast<RecordOptions::What>(m_what->currentIndex()),
            {m_width->value(), m_height->value()},
            m_seconds->value(),
            m_fps->value(),
            m_kind->currentIndex() == 1,
            m_path};
}

} // namespace stromar
