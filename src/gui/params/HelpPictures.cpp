#include "params/HelpPictures.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "stromar/app/Demonstration.h"
#include "stromar/app/TreeCreator.h"
#include "stromar/model/ModelSway.h"
#include <QBuffer>
#include <QHash>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace stromar {

namespace {
constexpr int kWidth = 330, kHeight = 120, kCaption = 30; // of the whole row of pictures
constexpr int kMaxColumns = 5;

/// A triangle ready to be painted.
struct Face {
    std::array<QPointF, 3> corners;
    float depth;
    QColor colour;
};

struct Picture {
    std::vector<Face> faces;
    QRectF bounds; ///< metres, z up as −y
    QString caption;
};

QColor shaded(const QColor& colour, float light) {
    const auto part = [light](int c) { return std::clamp(static_cast<int>(float(c) * light), 0, 255); };
    return {part(colour.red()), part(colour.green()), part(colour.blue())};
}

/// Turns the tree about z so that it is seen from where it is widest.
struct Turn {
    float c = 1, s = 0;
    glm::vec3 operator()(const glm::vec3& p) const { return {c * p.x + s * p.y, c * p.y - s * p.x, p.z}; }
};

Turn widestView(const Meshes& meshes) {
    double xx = 0, yy = 0, xy = 0;
    for (const auto& mesh : meshes)
        for (const glm::vec3& p : mesh->positions) {
            xx += double(p.x * p.x);
            yy += double(p.y * p.y);
            xy += double(p.x * p.y);
        }
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

void addFaces(Picture& picture, const CMesh& mesh, const QColor& colour, const Turn& turn, bool fromAbove) {
    const glm::vec3 sun = glm::normalize(glm::vec3(-0.5f, -0.7f, 0.6f));
    const auto seen = [&](const glm::vec3& p) { return fromAbove ? QPointF(p.x, -p.y) : QPointF(p.x, -p.z); };
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
        Face face{{}, 0, {}};
        std::array<glm::vec3, 3> corners;
        for (std::size_t c = 0; c < 3; ++c) {
            corners[c] = turn(mesh.positions[mesh.indices[3 * t + c]]);
            face.corners[c] = seen(corners[c]);
            face.depth += fromAbove ? corners[c].z : -corners[c].y;
            picture.bounds |= QRectF(face.corners[c] - QPointF(1e-4, 1e-4), QSizeF(2e-4, 2e-4));
        }
        const glm::vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const float area = glm::length(normal);
        if (area <= 0) continue;
        const float facing = glm::dot(normal / area, sun);
        face.colour = shaded(colour, 0.75f + 0.35f * (isBark(mesh.surface) || mesh.surface == Surface::Fruit ? facing : std::abs(facing)));
        picture.faces.push_back(face);
    }
}

/// In a strong gale.
QColor colourOf(Surface surface, const QColor& bark) {
    if (isBark(surface)) return bark;
    if (surface == Surface::Blossom) return {226, 158, 176};
    if (surface == Surface::Fruit) return {196, 74, 56};
    return {106, 158, 74};
}

Meshes blown(const std::shared_ptr<const TreeModel>& model) {
    const auto sway = swayOf(model, nullptr, CProgress());
    WindPose pose;
    sway->table->pose({.strength = 1.5, .gusts = 0}, 0, pose, CProgress());
    return swayedMeshes(*sway, pose, 0, 0, CProgress());
}

Picture makePicture(const ParamRef& ref, const Demonstration& shown, const QPalette& palette) {
    const bool close = ref.level == 0 && ref.group() != Group::Tree && ref.group() != Group::Pruning;
    const auto made = CTreeCreator().create(shown.params, detailOf(close ? Model::Full : Model::Simple), CProgress());
    const TreeModel& model = *made;
    const QColor bark =
        palette.color(QPalette::Window).lightness() < 128 ? QColor(170, 150, 128) : QColor(140, 118, 96);
    const QColor accent = palette.color(QPalette::Active, QPalette::Highlight);
    Picture picture;
    const bool above = ref.info->demo.fromAbove;
    const bool inWind = ref.info->demo.inWind; // towards the right
    const Turn turn = above || inWind ? Turn() : widestView(model.meshes());
    picture.caption = captionOf(*ref.info, shown.value);
    if (inWind) {
        for (const auto& mesh : blown(made)) addFaces(picture, *mesh, colourOf(mesh->surface, bark), turn, above);
        std::ranges::sort(picture.faces, {}, &Face::depth);
        return picture;
    }
    const auto concerned = ref.info->perLevel() ? std::size_t(std::min(ref.level, 1)) : model.stems.size();
    for (std::size_t level = 0; level < model.stems.size(); ++level)
        addFaces(picture, *model.stems[level], level == concerned ? accent : bark, turn, above);
    for (const auto& organs : model.organs)
        addFaces(picture, *organs->expanded(CProgress()), colourOf(organs->surface(), bark), turn, above);
    std::ranges::sort(picture.faces, {}, &Face::depth);
    return picture;
}

void paint(QPainter& painter, const Picture& picture, const QRectF& into, const QRectF& metres) {
    const double scale = std::min(into.width() / metres.width(), into.height() / metres.height());
    painter.save();
    painter.translate(into.center().x(), into.bottom());
    painter.scale(scale, scale);
    painter.translate(-picture.bounds.center().x(), -metres.bottom());
    for (const Face& face : picture.faces) {
        painter.setPen(QPen(face.colour, 0.6 / scale)); // closes the hairlines between antialiased faces
        painter.setBrush(face.colour);
        painter.drawConvexPolygon(face.corners.data(), 3);
    }
    painter.restore();
}
} // namespace

QImage helpPicture(const ParamRef& ref, const QPalette& palette, qreal ratio) {
    std::vector<Picture> pictures;
    for (const Demonstration& shown : demonstrationsOf(ref)) pictures.push_back(makePicture(ref, shown, palette));
    if (pictures.empty()) return {};
    const int count = static_cast<int>(pictures.size());
    const int rows = (count + kMaxColumns - 1) / kMaxColumns, columns = (count + rows - 1) / rows;
    // One scale for all, so that sizes compare.
    QRectF metres(0, 0, 0, 0);
    for (const Picture& picture : pictures) {
        metres.setWidth(std::max(metres.width(), picture.bounds.width()));
        metres.setTop(std::min(metres.top(), picture.bounds.top()));
        metres.setBottom(std::max(metres.bottom(), picture.bounds.bottom()));
    }
    QImage image(QSizeF(kWidth * ratio, rows * (kHeight + kCaption) * ratio).toSize(),
                 QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont small = painter.font();
    small.setPixelSize(10);
    painter.setFont(small);
    for (int i = 0; i < count; ++i) {
        const QRectF cell(double(i % columns) * kWidth / columns, i / columns * (kHeight + kCaption),
                          double(kWidth) / columns, kHeight);
        paint(painter, pictures[std::size_t(i)], cell.adjusted(4, 4, -4, -4), metres);
        painter.setPen(palette.color(QPalette::ToolTipText));
        painter.drawText(QRectF(cell.left(), cell.bottom(), cell.width(), kCaption),
                         Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, pictures[std::size_t(i)].caption);
    }
    return image;
}

QString helpPictureHtml(const ParamRef& ref, const QPalette& palette, qreal ratio) {
    static QHash<QString, QString> drawn;
    const QString key =
        QStringLiteral("%1 %2 %3 %4 %5")
            .arg(toQString(ref.key()), palette.color(QPalette::ToolTipText).name(), QLocale().name(), lengthUnit().name)
            .arg(ratio);
    if (const auto known = drawn.constFind(key); known != drawn.constEnd()) return *known;
    const QImage image = helpPicture(ref, palette, ratio);
    QString html;
    if (!image.isNull()) {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        image.save(&buffer, "PNG");
        html = QStringLiteral("<p><img src=\"data:image/png;base64,%1\" width=%2 height=%3></p>")
                   .arg(QString::fromLatin1(bytes.toBase64()))
                   .arg(int(image.width() / ratio))
                   .arg(int(image.height() / ratio));
    }
    drawn.insert(key, html);
    return html;
}

} // namespace stromar
