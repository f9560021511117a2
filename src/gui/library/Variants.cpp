#include "library/Variants.h"
#include "document/Gesture.h"
#include "window/QtText.h"
#include "library/Thumbnails.h"
#include "stromar/util/Text.h"
#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <sstream>

namespace stromar {

namespace {
constexpr int kPictureSize = 128, kLikedSize = 64, kLeastCell = 84; // pixels
constexpr int kPauseMs = 700; // after a change of the tree
constexpr const char* kSheetId = "seed:";
constexpr const char* kLikedId = "liked:";
constexpr const char* kAgeId = "age:";

QString titleOf(const ParamRef& ref) { return groupTitle(ref.group(), ref.level); }
} // namespace

std::vector<int> seedsFrom(const std::string& text) {
    std::vector<int> seeds;
    std::istringstream words(text);
    for (std::string word; words >> word;)
        if (const auto number = parseNumber(word); number && *number == static_cast<int>(*number))
            seeds.push_back(static_cast<int>(*number));
    return seeds;
}

CVariants::CVariants(CThumbnails& thumbnails, QWidget* parent) : QWidget(parent), m_thumbnails(thumbnails) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(makeSheet());
    column->addWidget(makeLiked());
    column->addWidget(makeAges());
    column->addWidget(makeRandomiser());
    column->addStretch(1);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseMs);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        requestSheet();
        requestLiked();
        requestAges();
    });
    connect(&m_thumbnails, &CThumbnails::ready, this, &CVariants::showThumbnail);
    throwSheet();
}

QToolButton* CVariants::makeCell(const QString& name) {
    auto* cell = new QToolButton;
    cell->setObjectName(name);
    cell->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    cell->setIconSize({36, 36});
    cell->setAutoRaise(true);
    cell->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // the room decides, not the picture
    return cell;
}

QWidget* CVariants::makeSheet() {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    m_sheetGrid = new QGridLayout;
    m_sheetGrid->setSpacing(3);
    for (int i = 0; i < kSheet; ++i) {
        QToolButton* cell = makeCell(QStringLiteral("seed%1").arg(i));
        connect(cell, &QToolButton::clicked, this, [this, i] { emit seedChosen(m_seeds[std::size_t(i)]); });
        m_cells[std::size_t(i)] = cell;
    }
    auto* more = new QPushButton(QIcon(QStringLiteral(":/icons/dice.svg")), tr("&Nine Others"));
    more->setToolTip(tr("Throw nine other seeds"));
    connect(more, &QPushButton::clicked, this, [this] {
        throwSheet();
        requestSheet();
    });
    column->addLayout(m_sheetGrid);
    column->addWidget(more, 0, Qt::AlignLeft);
    return box;
}

QWidget* CVariants::makeLiked() {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 6, 0, 0);
    auto* row = new QHBoxLayout;
    auto* title = new QLabel(QStringLiteral("<b>%1</b>").arg(tr("Liked seeds")));
    m_like = new QToolButton;
    m_like->setText(tr("♥ Like"));
    m_like->setCheckable(true);
    m_like->setToolTip(tr("Keep the seed of the tree in the window in its file"));
    row->addWidget(title, 1);
    row->addWidget(m_like);
    m_liked = new QListWidget;
    m_liked->setAccessibleName(tr("Liked seeds"));
    m_liked->setViewMode(QListView::IconMode);
    m_liked->setIconSize({kLikedSize, kLikedSize});
    m_liked->setGridSize({kLikedSize + 12, kLikedSize + fontMetrics().height() + 10});
    m_liked->setMovement(QListView::Static);
    m_liked->setResizeMode(QListView::Adjust);
    m_liked->setFixedHeight(kLikedSize + 2 * fontMetrics().height() + 14);
    column->addLayout(row);
    column->addWidget(m_liked);
    connect(m_like, &QToolButton::clicked, this, [this](bool liked) {
        std::vector<int> seeds = seedsFrom(m_params.text.likedSeeds);
        std::erase(seeds, m_params.common.seed);
        if (liked) seeds.push_back(m_params.common.seed);
        setLiked(seeds);
    });
    connect(m_liked, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { emit seedChosen(item->data(Qt::UserRole).toInt()); });
    connect(m_liked, &QListWidget::itemClicked, this,
            [this](const QListWidgetItem* item) { emit seedChosen(item->data(Qt::UserRole).toInt()); });
    return box;
}

QWidget* CVariants::makeAges() {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 6, 0, 0);
    column->addWidget(new QLabel(QStringLiteral("<b>%1</b>").arg(tr("Ages"))));
    m_agesGrid = new QGridLayout;
    m_agesGrid->setSpacing(1);
    for (std::size_t i = 0; i < kAges.size(); ++i) {
        const QString percent = tr("%1 %").arg(100 * kAges[i]);
        QToolButton* cell = makeCell(QStringLiteral("age%1").arg(i));
        cell->setText(percent);
        cell->setAccessibleName(tr("Age %1").arg(percent));
        cell->setToolTip(tr("The tree at this part of its life"));
        connect(cell, &QToolButton::clicked, this, [this, i] { emit ageChosen(kAges[i]); });
        m_ages[i] = cell;
    }
    column->addLayout(m_agesGrid);
    return box;
}

QWidget* CVariants::makeRandomiser() {
    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 6, 0, 0);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_level = new QComboBox;
    m_level->setObjectName(QStringLiteral("randomiseLevel"));
    m_level->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_level->setMinimumContentsLength(5);
    m_amount = new QSpinBox;
    m_amount->setRange(1, 100);
    m_amount->setValue(10);
    m_amount->setPrefix(QStringLiteral("± "));
    m_amount->setSuffix(QStringLiteral(" %"));
    auto* go = new QPushButton(tr("&Randomise"));
    go->setObjectName(QStringLiteral("randomise"));
    go->setToolTip(tr("Move the values by chance; locked ones stay (right click a parameter to lock it)"));
    form->addRow(new QLabel(QStringLiteral("<b>%1</b>").arg(tr("Random values"))));
    form->addRow(tr("Values of"), m_level);
    form->addRow(tr("&At most"), m_amount);
    form->addRow(go);
    connect(go, &QPushButton::clicked, this, &CVariants::randomise);
    return box;
}

/// "Everything", then the groups of the tree's method.
void CVariants::fillGroups() {
    const ParamBlock& block = m_params.block();
    if (m_block == &block) return;
    m_block = &block;
    m_level->clear();
    m_level->addItem(tr("Everything"));
    for (const ParamPage& page : pagesOf(block))
        if (page.group != Group::Textures) m_level->addItem(groupTitle(page.group, page.level));
}

void CVariants::randomise() {
    const bool all = m_level->currentIndex() == 0;
    const auto belongs = [&](const ParamRef& ref) {
        return all ? ref.group() != Group::Textures : titleOf(ref) == m_level->currentText();
    };
    std::vector<ParamRef> refs;
    std::ranges::copy_if(allParams(m_params.block()), std::back_inserter(refs), belongs);
    emit randomiseWanted(refs, m_amount->value() / 100.0);
}

void CVariants::throwSheet() {
    for (std::size_t i = 0; i < m_seeds.size(); ++i) {
        m_seeds[i] = randomSeed();
        m_cells[i]->setText(QString::number(m_seeds[i]));
        m_cells[i]->setAccessibleName(tr("Seed %1").arg(m_seeds[i]));
        m_cells[i]->setIcon({});
    }
    m_stale = true;
}

void CVariants::showParams(const CParams& params, const std::filesystem::path& folder) {
    CParams kind = params, shown = m_params;
    kind.common.seed = shown.common.seed = 0;
    kind.text.likedSeeds = shown.text.likedSeeds = {};
    m_stale = m_stale || kind != shown;
    m_agesStale = m_agesStale || params != m_params;
    const bool otherLiked = params.text.likedSeeds != m_params.text.likedSeeds;
    m_params = params;
    m_folder = folder;
    fillGroups();
    const std::vector<int> liked = seedsFrom(params.text.likedSeeds);
    m_like->setChecked(std::ranges::find(liked, params.common.seed) != liked.end());
    if (otherLiked) requestLiked();
    if (m_shown && stale()) m_pause.start();
}

void CVariants::setShown(bool shown) {
    m_shown = shown;
    if (m_shown && stale()) m_pause.start();
}

/// The pictures take the room there is.
void CVariants::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layOut(*m_sheetGrid, m_cells, 3);
    layOut(*m_agesGrid, m_ages, int(kAges.size()));
}

/// In as many columns as have room for pictures one can tell apart.
void CVariants::layOut(QGridLayout& grid, std::span<QToolButton* const> cells, int most) const {
    const int columns = std::clamp(width() / kLeastCell, 1, most);
    const int side = std::min(width() / columns - 12, kPictureSize);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i]->setIconSize({side, side});
        grid.addWidget(cells[i], int(i) / columns, int(i) % columns);
    }
}

QSize CVariants::pictureSize() const { return QSize(kPictureSize, kPictureSize) * devicePixelRatioF(); }

void CVariants::requestAges() {
    if (!m_shown || !m_agesStale) return;
    m_agesStale = false;
    m_thumbnails.drop(QLatin1String(kAgeId));
    for (std::size_t i = 0; i < kAges.size(); ++i)
        m_thumbnails.request(QStringLiteral("%1%2").arg(QLatin1String(kAgeId)).arg(i), m_params, m_folder, pictureSize(),
                             CThumbnails::Keep::No, kAges[i]);
}

void CVariants::requestSheet() {
    if (!m_shown || !m_stale) return;
    m_stale = false;
    m_thumbnails.drop(QLatin1String(kSheetId));
    for (std::size_t i = 0; i < m_seeds.size(); ++i) {
        CParams params = m_params;
        params.common.seed = m_seeds[i];
        m_thumbnails.request(QStringLiteral("%1%2").arg(QLatin1String(kSheetId)).arg(i), params, m_folder,
                             pictureSize(), CThumbnails::Keep::No);
    }
}

void CVariants::requestLiked() {
    m_likedStale = !m_shown;
    m_thumbnails.drop(QLatin1String(kLikedId));
    m_liked->clear();
    for (const int seed : seedsFrom(m_params.text.likedSeeds)) {
        auto* item = new QListWidgetItem(QString::number(seed), m_liked);
        item->setData(Qt::UserRole, seed);
        CParams params = m_params;
        params.common.seed = seed;
        if (m_shown)
            m_thumbnails.request(QStringLiteral("%1%2").arg(QLatin1String(kLikedId)).arg(seed), params, m_folder,
                                 pictureSize(), CThumbnails::Keep::No);
    }
}

void CVariants::showThumbnail(const QString& id, const QImage& image) {
    const QString number = id.section(QLatin1Char(':'), 1);
    QPixmap pixmap = QPixmap::fromImage(image);
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    if (id.startsWith(QLatin1String(kSheetId))) m_cells[number.toUInt()]->setIcon(QIcon(pixmap));
    if (id.startsWith(QLatin1String(kAgeId))) m_ages[number.toUInt()]->setIcon(QIcon(pixmap));
    if (!id.startsWith(QLatin1String(kLikedId))) return;
    for (int i = 0; i < m_liked->count(); ++i)
        if (m_liked->item(i)->text() == number) m_liked->item(i)->setIcon(QIcon(pixmap));
}

void CVariants::setLiked(const std::vector<int>& seeds) {
    QStringList words;
    for (const int seed : seeds) words << QString::number(seed);
    emit likedChanged(words.join(QLatin1Char(' ')));
}

} // namespace stromar
