#include "library/TextureWorkshop.h"
#include "params/ClampingBox.h"
#include "params/ParamSlider.h"
#include "window/QtText.h"
#include "stromar/util/Translatable.h"
#include <QColorDialog>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

namespace stromar {

namespace {
constexpr int kShown = 320, kTile = 160, kSaved = 1024; // pixels
constexpr int kSteps = 100;                             // of a slider
constexpr double kManyWhole = 1000;                     // whole numbers beyond have no slider

/// What one pixel of a picture shows, straight RGBA.
using Pixel = std::array<std::uint8_t, 4>;
using PixelOf = Pixel (*)(const TextureMaps& maps, std::size_t at);

Pixel colourAt(const TextureMaps& maps, std::size_t at) { return maps.albedo[at]; }

Pixel normalAt(const TextureMaps& maps, std::size_t at) {
    const auto& n = maps.normal[at];
    return {n[0], n[1], n[2], maps.albedo[at][3]};
}

Pixel roughnessAt(const TextureMaps& maps, std::size_t at) {
    const std::uint8_t r = maps.roughness[at];
    return {r, r, r, maps.albedo[at][3]};
}

/// In a light from the upper left, with a gleam where it is smooth. The eye looks straight at it.
Pixel litAt(const TextureMaps& maps, std::size_t at) {
    const auto component = [&](std::size_t i) { return (double(maps.normal[at][i]) - 128) / 127; };
    constexpr double kLight[] = {-0.48, 0.55, 0.683}, kHalf[] = {-0.262, 0.3, 0.917}; // unit vectors
    const auto along = [&](const double (&v)[3]) { return std::max(0.0, component(0) * v[0] + component(1) * v[1] + component(2) * v[2]); };
    const double rough = std::max(0.12, double(maps.roughness[at]) / 255);
    const double gleam = 0.35 * (1 - rough) * std::pow(along(kHalf), 4 / (rough * rough));
    const double light = 0.28 + 1.05 * along(kLight);
    Pixel lit{0, 0, 0, maps.albedo[at][3]};
    for (std::size_t i = 0; i < 3; ++i) lit[i] = static_cast<std::uint8_t>(std::clamp(double(maps.albedo[at][i]) * light + 255 * gleam, 0.0, 255.0));
    return lit;
}

struct ShownMap {
    std::string_view label;
    PixelOf pixel;
};
constexpr ShownMap kMaps[] = {{N_("Lit"), litAt}, {N_("Colour"), colourAt}, {N_("Normals"), normalAt}, {N_("Roughness"), roughnessAt}};

QImage imageOf(const TextureMaps& maps, PixelOf pixel) {
    QImage image(maps.width, maps.height, QImage::Format_RGBA8888);
    for (int y = 0; y < maps.height; ++y)
        for (int x = 0; x < maps.width; ++x) {
            const Pixel p = pixel(maps, maps.at(x, y));
            std::copy(p.begin(), p.end(), image.scanLine(y) + 4 * x);
        }
    return image;
}
} // namespace

bool CTextureWorkshop::tiles() const { return m_recipe.text().starts_with("bark:"); }

/// Tiles are shown four times, so that their seams could be seen; cut-out pictures once, on grey, in the form of what wears them.
QPixmap CTextureWorkshop::picture() const {
    const QImage image = imageOf(m_maps, kMaps[static_cast<std::size_t>(m_map->currentIndex())].pixel);
    QPixmap whole(kShown, kShown);
    whole.fill(QColor(200, 206, 212));
    QPainter painter(&whole);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!tiles()) {
        const QSizeF size(kShown * std::min(1.0, m_aspect), kShown / std::max(1.0, m_aspect));
        painter.drawImage(QRectF(QPointF((kShown - size.width()) / 2, (kShown - size.height()) / 2), size), image);
        return whole;
    }
    for (int y = 0; y < kShown; y += m_maps.height)
        for (int x = 0; x < kShown; x += m_maps.width) painter.drawImage(x, y, image);
    return whole;
}

CTextureWorkshop::CTextureWorkshop(CRecipe recipe, double aspect, QWidget* parent)
    : QDialog(parent), m_recipe(std::move(recipe)), m_aspect(aspect), m_map(new QComboBox), m_scroll(new QScrollArea), m_picture(new QLabel),
      m_text(new QLabel), m_drawing(*this) {
    setWindowTitle(tr("Texture Workshop"));
    auto* kinds = new QComboBox;
    kinds->setObjectName(QStringLiteral("kind"));
    for (const std::string_view kind : m_recipe.kinds()) kinds->addItem(trText(kind));
    kinds->setCurrentIndex(m_recipe.kind());
    connect(kinds, &QComboBox::currentIndexChanged, this, [this](int kind) {
        m_recipe.setKind(kind);
        makeRows();
        m_redraw.start();
    });
    for (const ShownMap& map : kMaps) m_map->addItem(trText(map.label));
    m_map->setObjectName(QStringLiteral("map"));
    m_map->setAccessibleName(tr("Picture"));
    connect(m_map, &QComboBox::currentIndexChanged, this, &CTextureWorkshop::showMap);
    m_picture->setFixedSize(kShown, kShown);
    m_picture->setObjectName(QStringLiteral("picture"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_text->setMaximumWidth(kShown);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setMinimumWidth(380);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QPushButton* save = buttons->addButton(tr("Save Pictures…"), QDialogButtonBox::ActionRole);
    connect(save, &QPushButton::clicked, this, &CTextureWorkshop::savePictures);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* left = new QVBoxLayout;
    left->addWidget(m_picture);
    left->addWidget(m_map);
    left->addWidget(m_text);
    left->addStretch(1);
    auto* right = new QVBoxLayout;
    right->addWidget(kinds);
    right->addWidget(m_scroll, 1);
    auto* row = new QHBoxLayout;
    row->addLayout(left);
    row->addLayout(right, 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(row, 1);
    column->addWidget(buttons);
    m_redraw.setSingleShot(true);
    m_redraw.setInterval(30);
    connect(&m_redraw, &QTimer::timeout, this, [this] {
        draw();
        emit changed();
    });
    makeRows();
    draw();
}

void CTextureWorkshop::makeRows() {
    auto* form = new QWidget;
    auto* layout = new QFormLayout(form);
    const std::vector<CRecipe::Row> rows = m_recipe.rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        QWidget* editor = makeEditor(i);
        editor->setToolTip(trText(rows[i].help));
        layout->addRow(trText(rows[i].label), editor);
    }
    m_scroll->setWidget(form);
}

QWidget* CTextureWorkshop::makeEditor(std::size_t row) {
    return m_recipe.rows()[row].type == CRecipe::Type::Tint ? makeColourEditor(row) : makeNumberEditor(row);
}

QWidget* CTextureWorkshop::makeNumberEditor(std::size_t i) {
    const CRecipe::Row row = m_recipe.rows()[i];
    const bool whole = row.type == CRecipe::Type::Whole;
    auto* number = new CClampingBox<QDoubleSpinBox>;
    number->setObjectName(toQString(row.key));
    number->setDecimals(whole ? 0 : 3);
    number->setRange(row.min, row.max);
    number->setSingleStep(whole ? 1 : (row.max - row.min) / kSteps);
    number->setKeyboardTracking(false);
    number->setValue(QString::fromStdString(m_recipe.value(i)).toDouble());
    connect(number, &QDoubleSpinBox::valueChanged, this,
            [this, i, number] { set(i, QString::number(number->value(), 'g', 9)); });
    if (whole && row.max - row.min > kManyWhole) return number;
    const double step = whole ? 1 : (row.max - row.min) / kSteps;
    auto* slider = new CParamSlider(static_cast<int>(std::lround((row.max - row.min) / step)));
    const auto place = [slider, row, step](double value) {
        const QSignalBlocker quiet(slider);
        slider->setValue(static_cast<int>(std::lround((value - row.min) / step * CParamSlider::kFinePerStep)));
    };
    place(number->value());
    connect(slider, &QSlider::valueChanged, number, [number, row, step](int position) {
        number->setValue(row.min + position * step / CParamSlider::kFinePerStep);
    });
    connect(number, &QDoubleSpinBox::valueChanged, slider, place);
    auto* both = new QWidget;
    auto* layout = new QHBoxLayout(both);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(slider, 1);
    layout->addWidget(number);
    return both;
}

QWidget* CTextureWorkshop::makeColourEditor(std::size_t i) {
    auto* button = new QPushButton;
    button->setObjectName(toQString(m_recipe.rows()[i].key));
    const auto show = [this, i, button] {
        QPixmap patch(48, 16);
        patch.fill(QColor(QString::fromStdString(m_recipe.value(i))));
        button->setIcon(patch);
        button->setIconSize(patch.size());
        button->setText(QString::fromStdString(m_recipe.value(i)));
    };
    show();
    connect(button, &QPushButton::clicked, this, [this, i, show] {
        const QColor now(QString::fromStdString(m_recipe.value(i)));
        const QColor chosen = QColorDialog::getColor(now, this, trText(m_recipe.rows()[i].label));
        if (!chosen.isValid()) return;
        set(i, chosen.name());
        show();
    });
    return button;
}

void CTextureWorkshop::set(std::size_t row, const QString& value) {
    m_recipe.setValue(row, value.toStdString()); // the editors keep to the rows' ranges
    m_redraw.start();
}

void CTextureWorkshop::draw() {
    m_text->setText(QString::fromStdString(m_recipe.text()));
    m_drawing.run([this, recipe = m_recipe, size = tiles() ? kTile : kShown](const CProgress& progress) -> CLatestTask::Then {
        return [this, maps = recipe.draw(size, progress)] {
            m_maps = maps;
            showMap();
        };
    });
}

void CTextureWorkshop::showMap() {
    if (m_maps.width > 0) m_picture->setPixmap(picture());
}

void CTextureWorkshop::savePictures() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save Pictures"), QStringLiteral("texture.png"), tr("Pictures (*.png)"));
    if (path.isEmpty()) return;
    try {
        CFileSet files;
        writePngs(m_recipe.draw(kSaved, CProgress()), toPath(path), files);
        files.commit();
    } catch (const std::exception& e) {
        QMessageBox::critical(this, tr("Cannot save the pictures"), errorText(e));
    }
}

} // namespace stromar
