#include "library/PresetBrowser.h"
#include "window/QtText.h"
#include "window/SearchField.h"
#include "library/Thumbnails.h"
#include "stromar/app/Export.h"
#include "stromar/params/TreeFile.h"
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QStandardPaths>
#include <QToolButton>
#include <algorithm>

namespace stromar {

namespace {
constexpr const char* kIdStart = "preset:";
constexpr int kPresetSize = 112;
enum Role { PathRole = Qt::UserRole, SearchRole, OwnRole };

/// Stands where a picture will be, or cannot be.
QIcon placeholder(const QPalette& palette, bool broken, qreal ratio) {
    QPixmap pixmap(QSize(kPresetSize, kPresetSize) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(palette.color(QPalette::Midlight));
    QPainter painter(&pixmap);
    painter.setPen(palette.color(QPalette::PlaceholderText));
    QFont large = painter.font();
    large.setPixelSize(34);
    painter.setFont(large);
    painter.drawText(QRect(0, 0, kPresetSize, kPresetSize), Qt::AlignCenter,
                     broken ? QStringLiteral("⚠") : QStringLiteral("…"));
    return QIcon(pixmap);
}
} // namespace

CPresetBrowser::CPresetBrowser(CThumbnails& thumbnails, QWidget* parent)
    : QWidget(parent), m_thumbnails(thumbnails), m_filter(new CSearchField(tr("Find a tree"))), m_folder(new QComboBox),
      m_nothing(new QLabel), m_list(new QListWidget) {
    m_nothing->setWordWrap(true);
    m_nothing->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    m_folder->addItems({tr("All"), tr("Stromar's"), tr("My own")});
    m_folder->setAccessibleName(tr("Folder of presets"));
    auto* save = new QToolButton;
    save->setText(tr("Save…"));
    save->setToolTip(tr("Keep the tree in the window as a preset of your own"));
    m_list->setViewMode(QListView::IconMode);
    m_list->setIconSize({kPresetSize, kPresetSize});
    m_list->setGridSize({kPresetSize + 16, kPresetSize + 2 * fontMetrics().height() + 10});
    m_list->setResizeMode(QListView::Adjust);
    m_list->setMovement(QListView::Static);
    m_list->setWordWrap(true);
    m_list->setUniformItemSizes(true);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setAccessibleName(tr("Presets"));
    auto* top = new QHBoxLayout;
    top->addWidget(m_folder, 1);
    top->addWidget(save);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->addWidget(m_filter);
    column->addLayout(top);
    column->addWidget(m_nothing, 1);
    column->addWidget(m_list, 1);
    setTabOrder(m_filter, m_list);
    connect(m_filter, &QLineEdit::textChanged, this, &CPresetBrowser::updateVisibility);
    connect(m_folder, &QComboBox::currentIndexChanged, this, &CPresetBrowser::updateVisibility);
    connect(save, &QToolButton::clicked, this, &CPresetBrowser::saveWanted);
    m_list->setCursor(Qt::PointingHandCursor);
    m_list->setMouseTracking(true); // the one under the mouse is marked
    connect(m_list, &QListWidget::itemClicked, this, &CPresetBrowser::choose);
    m_list->installEventFilter(this);
    connect(m_filter, &QLineEdit::returnPressed, this, [this] {
        choose(firstShown());
        m_list->setFocus(); // where the keys of the view act
    });
    m_filter->installEventFilter(this);
    connect(m_list, &QListWidget::customContextMenuRequested, this, &CPresetBrowser::showMenu);
    connect(&m_thumbnails, &CThumbnails::ready, this, &CPresetBrowser::showThumbnail);
    connect(&m_thumbnails, &CThumbnails::failed, this, [this](const QString& id, const QString& why) {
        QListWidgetItem* item =
            id.startsWith(QLatin1String(kIdStart)) ? itemOf(id.mid(qsizetype(strlen(kIdStart)))) : nullptr;
        if (!item) return;
        item->setIcon(placeholder(palette(), true, devicePixelRatioF()));
        item->setToolTip(why);
    });
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &CPresetBrowser::refresh);
}

QString CPresetBrowser::ownFolder() {
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/presets");
    QDir().mkpath(folder);
    return folder;
}

void CPresetBrowser::refresh() {
    m_thumbnails.drop(QLatin1String(kIdStart));
    m_list->clear();
    addFolder(fromPath(dataFolder() / "presets"), false);
    m_list->sortItems(); // by the names one sees; the user's own follow
    addFolder(ownFolder(), true);
    updateVisibility();
}

QString CPresetBrowser::nameOf(const QString& path) {
    const QString name = QFileInfo(path).completeBaseName().replace(QLatin1Char('_'), QLatin1Char(' '));
    try {
        const std::string species = CTreeFile::read(toPath(path)).params().text.species;
        return species.empty() ? name : toQString(species);
    } catch (const CError&) {
        return name;
    }
}

QString CPresetBrowser::shippedPicture(const QFileInfo& preset) {
    const QString picture = fromPath(dataFolder() / "docs" / "images" / "presets") + QLatin1Char('/') +
                            preset.completeBaseName() + QStringLiteral(".png");
    return QFileInfo::exists(picture) ? picture : QString();
}

void CPresetBrowser::addFolder(const QString& folder, bool own) {
    if (!m_watcher.directories().contains(folder)) m_watcher.addPath(folder);
    for (const QFileInfo& file : QDir(folder).entryInfoList({QStringLiteral("*.tree")}, QDir::Files, QDir::Name)) {
        auto* item = new QListWidgetItem(file.completeBaseName().replace(QLatin1Char('_'), QLatin1Char(' ')));
        item->setData(PathRole, file.absoluteFilePath());
        item->setData(OwnRole, own);
        item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
        m_list->addItem(item);
        try {
            const CTreeFile tree = CTreeFile::read(toPath(file.absoluteFilePath()));
            const TextParams& text = tree.params().text;
            if (!text.species.empty()) item->setText(toQString(text.species));
            item->setIcon(placeholder(palette(), false, devicePixelRatioF()));
            item->setToolTip(QStringLiteral("<p><b>%1</b></p><p>%2</p><p>%3</p>")
                                 .arg(toQString(text.species).toHtmlEscaped(),
                                      toQString(text.description).toHtmlEscaped(),
                                      tr("By %1").arg(toQString(text.author)).toHtmlEscaped()));
            item->setData(SearchRole, item->text() + QLatin1Char(' ') + file.fileName() + QLatin1Char(' ') +
                                          toQString(text.description) + QLatin1Char(' ') + toQString(text.author) +
                                          QLatin1Char(' ') + trText(tree.params().block().label));
            const QString made = own ? QString() : shippedPicture(file);
            if (!made.isEmpty())
                showThumbnail(QLatin1String(kIdStart) + file.absoluteFilePath(), QImage(made));
            else
                m_thumbnails.request(QLatin1String(kIdStart) + file.absoluteFilePath(), tree.params(), toPath(folder),
                                     QSize(kPresetSize, kPresetSize) * devicePixelRatioF(),
                                     CThumbnails::Keep::OnDisk);
        } catch (const std::exception& e) {
            item->setIcon(placeholder(palette(), true, devicePixelRatioF()));
            item->setToolTip(errorText(e).toHtmlEscaped());
            item->setData(SearchRole, file.fileName());
        }
    }
}

QListWidgetItem* CPresetBrowser::itemOf(const QString& path) const {
    for (int i = 0; i < m_list->count(); ++i)
        if (m_list->item(i)->data(PathRole).toString() == path) return m_list->item(i);
    return nullptr;
}

void CPresetBrowser::showThumbnail(const QString& id, const QImage& image) {
    if (!id.startsWith(QLatin1String(kIdStart))) return;
    QListWidgetItem* item = itemOf(id.mid(qsizetype(strlen(kIdStart))));
    if (!item) return;
    QPixmap pixmap = QPixmap::fromImage(image);
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    item->setIcon(QIcon(pixmap));
}

void CPresetBrowser::updateVisibility() {
    const QStringList words = m_filter->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    for (int i = 0; i < m_list->count(); ++i) {
        QListWidgetItem* item = m_list->item(i);
        const QString text = item->data(SearchRole).toString();
        const bool own = item->data(OwnRole).toBool();
        const bool inFolder = m_folder->currentIndex() == 0 || own == (m_folder->currentIndex() == 2);
        item->setHidden(!inFolder || !std::ranges::all_of(words, [&](const QString& word) {
            return text.contains(word, Qt::CaseInsensitive);
        }));
    }
    const bool nothing = !firstShown();
    m_list->setVisible(!nothing);
    m_nothing->setVisible(nothing);
    m_nothing->setText(words.isEmpty() ? tr("No presets yet: Save… keeps the tree in the window.")
                                       : tr("No preset is called “%1”.").arg(m_filter->text().trimmed()));
    const QListWidgetItem* current = m_list->currentItem();
    if (current ? current->isHidden() : !words.isEmpty()) m_list->setCurrentItem(firstShown());
}

QListWidgetItem* CPresetBrowser::firstShown() const {
    for (int i = 0; i < m_list->count(); ++i)
        if (!m_list->item(i)->isHidden()) return m_list->item(i);
    return nullptr;
}

void CPresetBrowser::choose(const QListWidgetItem* item) {
    if (item) emit chosen(item->data(PathRole).toString());
}

bool CPresetBrowser::eventFilter(QObject* watched, QEvent* event) {
    const int key = event->type() == QEvent::KeyPress ? static_cast<QKeyEvent*>(event)->key() : 0;
    if (watched == m_list && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
        choose(m_list->currentItem());
        return true;
    }
    if (watched != m_filter || key != Qt::Key_Down) return QWidget::eventFilter(watched, event);
    if (QListWidgetItem* first = firstShown()) m_list->setCurrentItem(first);
    m_list->setFocus();
    return true;
}

void CPresetBrowser::showMenu(const QPoint& at) {
    QListWidgetItem* item = m_list->itemAt(at);
    if (!item) return;
    QMenu menu;
    menu.addAction(tr("&Open"), this, [this, item] { choose(item); });
    if (item->data(OwnRole).toBool()) menu.addAction(tr("&Remove…"), this, [this, item] { removePreset(item); });
    menu.exec(m_list->mapToGlobal(at));
}

void CPresetBrowser::removePreset(QListWidgetItem* item) {
    const QString path = item->data(PathRole).toString();
    if (QMessageBox::question(this, tr("Remove a preset"), tr("Move “%1” to the waste bin?").arg(item->text())) !=
        QMessageBox::Yes)
        return;
    if (!QFile::moveToTrash(path))
        QMessageBox::warning(this, tr("Remove a preset"), tr("%1 cannot be removed.").arg(path));
    refresh();
}

} // namespace stromar
