#include "work/ExportDialog.h"
#include "window/QtText.h"
#include "window/WrappedLabel.h"
#include "stromar/app/Export.h"
#include "stromar/app/ExportRow.h"
#include "stromar/util/Translatable.h"
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>

namespace stromar {

namespace {
constexpr int kMargins = 60, kBelow = 230, kFrame = 50; // pixels: around the rows, below them, of the window
constexpr const char *kEngineKey = "export/for", *kFormatKey = "export/format", *kFolderKey = "export/folder";

QString keyOf(const ExportChoice& choice) { return QStringLiteral("export/") + toQString(choice.key); }
} // namespace

CExportDialog::CExportDialog(const QString& name, double fullVertices, std::size_t rowTrees, QWidget* parent)
    : QDialog(parent), m_fullVertices(fullVertices), m_rowTrees(rowTrees), m_trees(new QComboBox), m_engine(new QComboBox), m_format(new QComboBox), m_notes(new CWrappedLabel), m_path(new QLineEdit),
      m_losses(new CWrappedLabel), m_size(new QLabel), m_conflict(new CWrappedLabel) {
    setWindowTitle(tr("Export"));
    auto* rows = new QWidget;
    auto* form = new QFormLayout(rows);
    addTrees(*form);
    addEngines(*form);
    addFormats(*form);
    for (const ExportChoice& choice : exportChoices()) addChoice(choice, *form);
    auto* below = new QFormLayout; // always in sight
    addPlace(*below, name);
    below->addRow(tr("Lost in this format"), m_losses);
    below->addRow(tr("Size, about"), m_size);
    m_conflict->setObjectName(QStringLiteral("conflict"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &CExportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* scroll = new QScrollArea; // small screens have no room for all
    scroll->setWidget(rows);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* whole = new QVBoxLayout(this);
    whole->addWidget(scroll, 1);
    whole->addLayout(below);
    whole->addWidget(m_conflict);
    whole->addWidget(buttons);
    setMinimumWidth(520);
    update();
    const QSize wanted = rows->sizeHint();
    scroll->setMinimumWidth(rows->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    resize(std::max(560, wanted.width() + kMargins), std::min(wanted.height() + kBelow, screen()->availableGeometry().height() - kFrame));
}

QString CExportDialog::path() const { return QDir::fromNativeSeparators(m_path->text().trimmed()); }

const Format& CExportDialog::format() const {
    return formatTable()[static_cast<std::size_t>(std::max(0, m_format->currentIndex()))];
}

/// Where several stand side by side: whether all are wanted.
void CExportDialog::addTrees(QFormLayout& form) {
    m_trees->setObjectName(QStringLiteral("trees"));
    m_trees->setParent(this);
    m_trees->addItem(tr("This tree alone"));
    m_trees->setVisible(m_rowTrees > 1);
    if (m_rowTrees < 2) return;
    m_trees->addItem(tr("All %1 side by side, as one scene").arg(m_rowTrees));
    m_trees->setCurrentIndex(1);
    connect(m_trees, &QComboBox::currentIndexChanged, this, &CExportDialog::update);
    form.addRow(tr("Trees"), m_trees);
}

bool CExportDialog::wantsRow() const { return m_trees->currentIndex() == 1; }

/// Which program the tree is for: one choice for all rows below.
void CExportDialog::addEngines(QFormLayout& form) {
    m_engine->setObjectName(QStringLiteral("engine"));
    m_engine->addItem(tr("No program in particular"));
    for (const Engine& engine : engineTable()) m_engine->addItem(trText(engine.label), toQString(engine.key));
    m_engine->setCurrentIndex(std::max(0, m_engine->findData(QSettings().value(QLatin1String(kEngineKey)))));
    connect(m_engine, &QComboBox::activated, this, &CExportDialog::takeEngine);
    auto* row = new QHBoxLayout;
    row->addWidget(m_engine, 1);
    const auto add = [&](const char* name, const QString& text, void (CExportDialog::*run)()) {
        auto* button = new QPushButton(text);
        button->setObjectName(QLatin1String(name));
        button->setAutoDefault(false);
        connect(button, &QPushButton::clicked, this, run);
        row->addWidget(button);
    };
    add("loadSettings", tr("Load…"), &CExportDialog::loadSettings);
    add("saveSettings", tr("Save…"), &CExportDialog::saveSettings);
    form.addRow(tr("For"), row);
    m_notes->setObjectName(QStringLiteral("notes"));
    form.addRow(m_notes);
}

void CExportDialog::takeEngine(int index) {
    take(index == 0 ? ExportSettings() : settingsFor(engineTable()[static_cast<std::size_t>(index) - 1]));
}

void CExportDialog::take(const ExportSettings& settings) {
    m_engine->setCurrentIndex(std::max(0, m_engine->findData(toQString(settings.engine))));
    m_options = settings.options;
    for (const auto& show : m_show) show();
    if (!settings.ending.empty()) m_format->setCurrentIndex(m_format->findData(toQString(settings.ending)));
    update();
}

void CExportDialog::loadSettings() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Load Export Settings"), {}, tr("Export settings (*.export)"));
    if (file.isEmpty()) return;
    try {
        take(readSettings(toPath(file)));
    } catch (const CError& e) {
        QMessageBox::critical(this, tr("Cannot load the settings"), errorText(e));
    }
}

void CExportDialog::saveSettings() {
    QFileDialog dialog(this, tr("Save Export Settings"), {}, tr("Export settings (*.export)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("export"));
    if (dialog.exec() != QDialog::Accepted) return;
    try {
        const ExportSettings settings{m_engine->currentData().toString().toStdString(), std::string(format().ending), m_options};
        writeFile(toPath(dialog.selectedFiles().front()), settingsText(settings));
    } catch (const CError& e) {
        QMessageBox::critical(this, tr("Cannot save the settings"), errorText(e));
    }
}

void CExportDialog::addFormats(QFormLayout& form) {
    m_format->setObjectName(QStringLiteral("format"));
    for (const Format& format : formatTable())
        m_format->addItem(QStringLiteral("%1 (%2)").arg(trText(format.name), toQString(format.ending)),
                          toQString(format.ending));
    m_format->setCurrentIndex(std::max(0, m_format->findData(QSettings().value(QLatin1String(kFormatKey)))));
    connect(m_format, &QComboBox::currentIndexChanged, this, [this] {
        const QFileInfo old(path());
        m_path->setText(QDir(old.path()).filePath(old.completeBaseName()) + m_format->currentData().toString());
        update();
    });
    form.addRow(tr("Format"), m_format);
}

/// An editor for a row of the table, with the value of the last time.
void CExportDialog::addChoice(const ExportChoice& choice, QFormLayout& form) {
    QWidget* editor = nullptr;
    const QVariant last = QSettings().value(keyOf(choice));
    if (choice.number) {
        auto* box = new QDoubleSpinBox;
        box->setDecimals(4);
        box->setRange(choice.range.min, choice.range.max);
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        box->setValue(last.isValid() ? last.toDouble() : m_options.*choice.number);
        m_options.*choice.number = box->value();
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, &choice](double value) {
            m_options.*choice.number = value;
            update();
        });
        m_show.emplace_back([this, box, &choice] { box->setValue(m_options.*choice.number); });
        editor = box;
    } else if (choice.words.empty()) {
        auto* box = new QSpinBox;
        box->setRange(static_cast<int>(choice.range.min), static_cast<int>(choice.range.max));
        box->setSpecialValueText(trText(choice.whenZero));
        box->setValue(last.isValid() ? last.toInt() : m_options.*choice.field);
        m_options.*choice.field = box->value();
        connect(box, &QSpinBox::valueChanged, this, [this, &choice](int value) {
            m_options.*choice.field = value;
            update();
        });
        m_show.emplace_back([this, box, &choice] { box->setValue(m_options.*choice.field); });
        editor = box;
    } else {
        auto* box = new QComboBox;
        for (const std::string_view name : choice.names) box->addItem(trText(name));
        box->setCurrentIndex(std::clamp(last.isValid() ? last.toInt() : m_options.*choice.field, 0, box->count() - 1));
        m_options.*choice.field = box->currentIndex();
        connect(box, &QComboBox::currentIndexChanged, this, [this, &choice](int value) {
            m_options.*choice.field = value;
            update();
        });
        m_show.emplace_back([this, box, &choice] { box->setCurrentIndex(m_options.*choice.field); });
        editor = box;
    }
    editor->setObjectName(toQString(choice.key));
    editor->setToolTip(trText(choice.help));
    form.addRow(trText(choice.label), editor);
}

void CExportDialog::addPlace(QFormLayout& form, const QString& name) {
    const QString folder = QSettings().value(QLatin1String(kFolderKey), QDir::homePath()).toString();
    m_path->setObjectName(QStringLiteral("path"));
    m_path->setText(QDir(folder).filePath(name) + m_format->currentData().toString());
    auto* button = new QPushButton(tr("Browse…"));
    connect(button, &QPushButton::clicked, this, &CExportDialog::browse);
    connect(m_path, &QLineEdit::textChanged, this, &CExportDialog::onPath);
    auto* row = new QHBoxLayout;
    row->addWidget(m_path);
    row->addWidget(button);
    form.addRow(tr("File"), row);
}

void CExportDialog::browse() {
    const QString chosen = QFileDialog::getSaveFileName(this, tr("Where to export"), path(), {}, nullptr,
                                                        QFileDialog::DontConfirmOverwrite);
    if (chosen.isEmpty()) return;
    m_path->setText(chosen);
    if (const Format* format = formatOf(toPath(chosen)))
        m_format->setCurrentIndex(m_format->findData(toQString(format->ending)));
    else
        m_path->setText(chosen + m_format->currentData().toString());
}

/// Who types another format's ending wants that format.
void CExportDialog::onPath() {
    if (const Format* typed = formatOf(toPath(path()))) {
        const QSignalBlocker quiet(m_format);
        m_format->setCurrentIndex(m_format->findData(toQString(typed->ending)));
    }
    update();
}

void CExportDialog::update() {
    if (!m_export) return;
    const std::string_view conflict = wantsRow() ? rowConflictOf(m_options, format()) : conflictOf(m_options, format());
    const bool wrongEnding = formatOf(toPath(path())) != &format();
    const Engine* engine = engineNamed(m_engine->currentData().toString().toStdString());
    const std::string_view advice = adviceOn(m_options, format());
    m_notes->setText(!advice.empty() ? trText(advice) : engine ? trText(engine->notes) : QString());
    m_notes->setVisible(!m_notes->text().isEmpty());
    m_losses->setText(toQString(lossesOf(format())));
    const QString size = QLocale().formattedDataSize(static_cast<qint64>(estimatedBytes(m_fullVertices * double(wantsRow() ? m_rowTrees : 1), m_options, format())));
    m_size->setText(m_options.displacement > 0 ? tr("%1, and what displacement adds").arg(size) : size);
    m_conflict->setText(!conflict.empty() ? toQString(translated(conflict, format().ending))
                        : wrongEnding     ? tr("The file's name has to end in %1").arg(toQString(format().ending))
                                          : QString());
    for (const ExportChoice& choice : exportChoices())
        if (choice.counts) findChild<QWidget*>(toQString(choice.key))->setEnabled(choice.counts(m_options));
    m_export->setEnabled(m_conflict->text().isEmpty());
}

void CExportDialog::accept() {
    const QFileInfo file(path());
    if (file.exists() &&
        QMessageBox::question(this, tr("Export"), tr("%1 is there already. Replace it?").arg(file.fileName())) !=
            QMessageBox::Yes)
        return;
    QSettings settings;
    settings.setValue(QLatin1String(kEngineKey), m_engine->currentData());
    settings.setValue(QLatin1String(kFormatKey), m_format->currentData());
    if (file.absoluteDir().exists()) settings.setValue(QLatin1String(kFolderKey), file.absolutePath());
    for (const ExportChoice& choice : exportChoices())
        settings.setValue(keyOf(choice),
                          choice.number ? QVariant(m_options.*choice.number) : QVariant(m_options.*choice.field));
    QDialog::accept();
}

} // namespace stromar
