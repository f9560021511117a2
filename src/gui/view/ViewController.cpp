#include "view/ViewController.h"
#include "params/CurveEditor.h"
#include "params/ParamEditor.h"
#include "params/ParamPanel.h"
#include "view/ImageFile.h"
#include "view/LodDistance.h"
#include "view/PictureDialog.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "stromar/app/Methods.h"
#include "stromar/params/ParamText.h"
#include "stromar/tree/Nearest.h"
#include "stromar/util/Random.h"
#include <QFileDialog>
#include <QInputDialog>
#include <QLocale>
#include <QMessageBox>
#include <QProgressDialog>
#include <QStandardPaths>
#include <QTabWidget>
#include <algorithm>

namespace stromar {

namespace {
constexpr int kFlash = 600;     // milliseconds that a level is tinted when it is first touched
constexpr int kPatience = 4000;  // milliseconds until a dialog says how far one picture is
constexpr int kTurnPoints = 12; // of a drawn turn of a helix
constexpr std::size_t kMaxLines = 40000; // that are drawn of what a line of a text wrote

osg::Vec3d toOsg(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

std::size_t trianglesOfLeaves(const TreeModel& tree) {
    std::size_t count = 0;
    for (std::size_t kind = 0; kind < kLeafKinds; ++kind) count += tree.leaves(kind)->triangleCount();
    return tree.cards ? count + tree.cards->triangleCount() : count;
}

/// The centre line of every path of a stem.
std::vector<std::vector<CViewOverlay::TreePoint>> linesOf(const CTree& tree, std::size_t generation, const CStem& stem) {
    const CGeneration& all = tree.generation(generation);
    std::vector<std::vector<CViewOverlay::TreePoint>> lines;
    const auto pointOf = [&](std::uint32_t s, double part) {
        return CViewOverlay::TreePoint{toOsg(all.segments[s].centre(part)), static_cast<std::uint32_t>(generation), s,
                                       static_cast<float>(part)};
    };
    for (std::uint32_t p = stem.firstPath; p < stem.firstPath + stem.pathCount; ++p) {
        const CPath& path = all.paths[p];
        auto& line = lines.emplace_back();
        for (std::uint32_t s = path.firstSegment; s < path.firstSegment + path.segmentCount; ++s) {
            const int steps = all.segments[s].helixRadius != 0 ? kTurnPoints : 1;
            for (int i = 0; i < steps; ++i) line.push_back(pointOf(s, double(i) / steps));
        }
        line.push_back(pointOf(path.firstSegment + path.segmentCount - 1, 1));
    }
    return lines;
}

/// The same in every tree in which the leaf sits in the same place.
std::uint64_t nameOf(const CTree& tree, const CLeaf& leaf) {
    return hashCombine(tree.generation(leaf.generation).stems[leaf.stem].id, leaf.number);
}
} // namespace

CViewController::CViewController(CViewport& viewport, CParamPanel& panel, CDocument& document, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_panel(panel), m_document(document) {
    connect(&m_panel, &CParamPanel::touched, this, &CViewController::onTouched);
    m_flash.setSingleShot(true);
    connect(&m_flash, &QTimer::timeout, this, &CViewController::endFlash);
    connect(&m_document, &CDocument::changed, this, &CViewController::endFlash);
    connect(&m_panel, &CParamPanel::lineTouched, this, &CViewController::onLineTouched);
    connect(&m_panel, &CParamPanel::rangeHeld, this, &CViewController::onRangeHeld);
    connect(&m_panel, &CParamPanel::released, this, &CViewController::onPanelReleased);
    connect(&m_panel, &CParamPanel::curveUnfolded, this, &CViewController::showCurveUse);
    connect(&m_panel.tabs(), &QTabWidget::currentChanged, this, &CViewController::showCurveUse);
    connect(&m_panel.tabs(), &QTabWidget::currentChanged, this, [this](int tab) {
        m_guide = nullptr;
        for (const Guide& guide : methodOf(m_document.params()).guides)
            if (!guide.group.name.empty() && tab == m_panel.tabOf(guide.group)) m_guide = &guide;
        updateOverlay();
    });
    connect(&m_document, &CDocument::replaced, this, &CViewController::clearSelection);
    connect(&m_viewport, &CViewport::picked, this, &CViewController::onPicked);
    connect(&m_viewport, &CViewport::guideDragged, this, &CViewController::onDragged);
    connect(&m_viewport, &CViewport::guideReleased, this, [this] {
        m_dragging = false;
        emit released();
    });
}

void CViewController::show(const std::shared_ptr<const ViewModel>& view) {
    m_view = view;
    updateSelection();
}

int CViewController::generationOf(const ParamRef& ref) const {
    const TreeMethod& method = methodOf(m_document.params());
    return method.generationOf ? method.generationOf(ref, m_document.params()) : ViewPart::kNone;
}

const Guide* CViewController::guideOf(const ParamRef& ref) const {
    for (const Guide& guide : methodOf(m_document.params()).guides)
        if (guide.belongsTo(ref)) return &guide;
    return nullptr;
}

/// The tree is seen in its own colours while a value changes, and after.
void CViewController::endFlash() {
    m_flash.stop();
    if (!m_tintKept) m_viewport.tint(ViewPart::kNone);
}

void CViewController::setTintKept(bool on) {
    m_tintKept = on;
    m_flash.stop();
    m_viewport.tint(on ? m_touched : ViewPart::kNone);
}

void CViewController::onTouched(const std::optional<ParamRef>& ref) {
    const int touched = ref ? generationOf(*ref) : ViewPart::kNone;
    if (touched != m_touched) {
        m_viewport.tint(touched);
        m_flash.start(kFlash);
    }
    m_touched = touched;
    // Guides stay while the mouse goes to their handles, until another value is touched.
    if (!ref || guideOf(*ref) == m_guide) return;
    m_guide = guideOf(*ref);
    updateOverlay();
}

void CViewController::onDragged(std::size_t handle, const glm::dvec2& to, int gesture) {
    if (!m_guide) return;
    m_dragging = true;
    const GuideHandle& dragged = m_guide->handles[handle];
    const double scale = m_viewport.overlay().model().scaleTree;
    const QString text = trText(dragged.text);
    m_document.edit(
        tr("Drag %1").arg(text), [&](CParams& params) { dragged.drag(params, scale, to); }, gesture, text);
}

void CViewController::onPicked(const std::optional<ViewHit>& hit) {
    m_selected.reset();
    if (hit && m_view) {
        const CTree& tree = *m_view->model->tree;
        const glm::dvec3 point(hit->point.x(), hit->point.y(), hit->point.z());
        if (hit->generation < ViewPart::kLeaves) {
            m_panel.tabs().setCurrentIndex(m_panel.tabOf(Group::Blossom));
        } else if (hit->generation == ViewPart::kLeaves) {
            if (const auto leaf = nearestLeaf(tree, point))
                m_selected = Selected{ViewPart::kLeaves, nameOf(tree, tree.leaves()[*leaf])};
            m_panel.showLeaves();
        } else {
            const auto generation = static_cast<std::size_t>(hit->generation);
            if (const auto stem = nearestStem(tree, generation, point)) {
                const CStem& own = tree.generation(generation).stems[*stem];
                const std::uint32_t segment = nearestSegment(tree, generation, *stem, point);
                m_selected = Selected{hit->generation, own.id, segment - own.firstSegment};
                showWriterOf(generation, *stem);
            }
            if (methodOf(m_view->model->params).curvePlaces)
                m_panel.showCurves();
            else
                m_panel.showGeneration(hit->generation);
        }
    }
    updateSelection();
}

/// In the text that describes the tree: the line that wrote a stem.
void CViewController::showWriterOf(std::size_t generation, std::size_t stem) {
    const CParams& params = m_view->model->params;
    const TextLanguage* language = methodOf(params).language;
    if (!language || params != m_document.params()) return;
    if (const auto line = language->lineOf(params, *m_view->model->tree, generation, stem))
        m_panel.showLine(*findParam(std::string(language->key), params.block()), *line);
}

/// What a line of that text wrote.
void CViewController::onLineTouched(const ParamRef& ref, int line) {
    const TextLanguage* language = languageOf(*ref.info);
    CViewOverlay::Model& model = m_viewport.overlay().model();
    m_selected.reset();
    model.selection = {};
    model.selectionText.clear();
    if (const CTree* tree = treeOfDocument(); tree && line > 0 && language) {
        const auto written = language->writtenBy(m_view->model->params, *tree, line);
        selectSegments(written);
        std::size_t count = 0;
        for (const auto& own : written) count += own.size();
        if (count > 0) model.selectionText = tr("Line %1 wrote %n segment(s)", nullptr, static_cast<int>(count)).arg(line);
    }
    updateOverlay();
}

/// The tree that is shown, if it is one of the document's method.
const CTree* CViewController::treeOfDocument() const {
    return m_view && &m_view->model->params.block() == &m_document.params().block() ? m_view->model->tree.get() : nullptr;
}

/// By generation.
void CViewController::selectSegments(const std::vector<std::vector<std::uint32_t>>& segments) {
    auto& [tree, lines] = m_viewport.overlay().model().selection;
    tree = m_view->model->tree;
    for (std::size_t g = 0; g < segments.size(); ++g)
        for (const std::uint32_t s : segments[g]) {
            if (lines.size() == kMaxLines) return;
            const CSegment& segment = tree->generation(g).segments[s];
            const auto generation = static_cast<std::uint32_t>(g);
            lines.push_back({{toOsg(segment.position), generation, s, 0}, {toOsg(segment.axisPoint(1)), generation, s, 1}});
        }
}

void CViewController::onRangeHeld(const ParamRef& curve, double low, double high) {
    m_range = HeldRange{curve, low, high};
    updateSelection();
}

void CViewController::onPanelReleased() {
    if (!m_range) return;
    m_range.reset();
    updateSelection();
}

void CViewController::selectHeldRange() {
    const CTree* tree = treeOfDocument();
    const auto placesOf = methodOf(m_document.params()).curvePlaces;
    if (!tree || !placesOf) return;
    const CurvePlaces places = placesOf(*m_range->curve.info, m_view->model->params, *tree);
    std::vector<std::vector<std::uint32_t>> touched(places.size());
    std::size_t count = 0;
    for (std::size_t g = 0; g < places.size(); ++g)
        for (std::uint32_t s = 0; s < places[g].size(); ++s)
            if (places[g][s] > m_range->low && places[g][s] < m_range->high) {
                touched[g].push_back(s);
                ++count;
            }
    selectSegments(touched);
    m_viewport.overlay().model().selectionText = tr("This point touches %n branch(es)", nullptr, static_cast<int>(count));
}

/// Behind the curves that are seen: how the tree's branches lie along them; on all, where the selected one does.
void CViewController::showCurveUse() {
    const CTree* tree = treeOfDocument();
    const auto placesOf = methodOf(m_document.params()).curvePlaces;
    if (!tree || !placesOf) return;
    for (const CParamEditor* editor : m_panel.curves()) {
        CCurveEditor& curve = *editor->curve();
        if (!curve.isVisible() || (curve.folded() && !m_selected)) {
            curve.showUse({});
            continue;
        }
        CCurveEditor::Use use;
        const CurvePlaces places = placesOf(*editor->ref().info, m_view->model->params, *tree);
        if (const auto at = selectedSegment()) use.marked = {places[at->generation][at->segment]};
        for (const auto& own : places) use.branches.insert(use.branches.end(), own.begin(), own.end());
        curve.showUse(std::move(use));
    }
}

/// Nothing where none is selected, or the tree has it no more.
std::optional<SegmentPlace> CViewController::selectedSegment() const {
    const CTree* tree = treeOfDocument();
    if (!tree || !m_selected || m_selected->generation == ViewPart::kLeaves) return {};
    const auto generation = static_cast<std::size_t>(m_selected->generation);
    if (generation >= tree->generationCount()) return {};
    const auto& stems = tree->generation(generation).stems;
    const auto stem = std::ranges::find(stems, m_selected->id, &CStem::id);
    if (stem == stems.end() || m_selected->segment >= stem->segmentCount) return {};
    return SegmentPlace{generation, stem->firstSegment + m_selected->segment};
}

/// What the method knows of a segment.
QStringList CViewController::quantitiesAt(const SegmentPlace& place) const {
    QStringList rows;
    for (const SegmentQuantity& quantity : methodOf(m_view->model->params).quantities)
        if (!quantity.label.empty())
            rows << QStringLiteral("%1: %2").arg(trText(quantity.label)).arg(quantity.of(*m_view->model->tree, place));
    return rows;
}

void CViewController::clearSelection() {
    m_guide = nullptr;
    m_selected.reset();
    updateOverlay();
    updateSelection();
}

void CViewController::updateSelection() {
    CViewOverlay::Model& model = m_viewport.overlay().model();
    model.selection = {};
    model.selectionText.clear();
    if (m_range) {
        selectHeldRange();
    } else if (m_selected && m_view && m_selected->generation == ViewPart::kLeaves) {
        const CTree& tree = *m_view->model->tree;
        for (const CLeaf& leaf : tree.leaves())
            if (nameOf(tree, leaf) == m_selected->id) describeLeaf(leaf);
    } else if (m_selected && m_view &&
             static_cast<std::size_t>(m_selected->generation) < m_view->model->tree->generationCount()) {
        const auto generation = static_cast<std::size_t>(m_selected->generation);
        const auto& stems = m_view->model->tree->generation(generation).stems;
        const auto stem = std::ranges::find(stems, m_selected->id, &CStem::id);
        if (stem != stems.end()) describeStem(generation, *stem, static_cast<std::size_t>(stem - stems.begin()));
    }
    showCurveUse();
    updateOverlay();
}

void CViewController::describeStem(std::size_t generation, const CStem& stem, std::size_t number) {
    const CTree& tree = *m_view->model->tree;
    const CGeneration& all = tree.generation(generation);
    CViewOverlay::Model& model = m_viewport.overlay().model();
    model.selection = {m_view->model->tree, linesOf(tree, generation, stem)};
    QStringList rows{
        tr("%1, stem %2 of %3").arg(levelTitle(int(generation))).arg(number + 1).arg(all.stems.size()),
        tr("Length %1, radius %2").arg(lengthText(stem.length), lengthText(stem.radius))};
    if (stem.parent >= 0)
        rows << tr("On %1, stem %2, at %3")
                    .arg(levelTitle(int(generation) - 1))
                    .arg(stem.parent + 1)
                    .arg(lengthText(stem.offset));
    if (stem.pathCount > 1) rows << tr("Split into %n path(s)", nullptr, static_cast<int>(stem.pathCount));
    if (const auto at = selectedSegment()) rows << quantitiesAt(*at);
    model.selectionText = rows.join(QLatin1Char('\n'));
}

void CViewController::describeLeaf(const CLeaf& leaf) {
    CViewOverlay::Model& model = m_viewport.overlay().model();
    const CTree& tree = *m_view->model->tree;
    const glm::dvec3 foot(leaf.position), tip(leaf.position + leaf.length * leaf.axis);
    const std::uint32_t segment = nearestSegment(tree, leaf.generation, leaf.stem, foot);
    model.selection = {m_view->model->tree, {{{toOsg(foot), leaf.generation, segment, 0}, {toOsg(tip), leaf.generation, segment, 0}}}};
    model.selectionText =
        tr("Leaf %1 of %2\nLength %3, width %4\nOn %5, stem %6")
            .arg(leaf.number + 1)
            .arg(m_view->model->tree->organs(Organ::Leaf)->countOn(leaf.generation, leaf.stem))
            .arg(lengthText(leaf.length), lengthText(leaf.width), levelTitle(int(leaf.generation)))
            .arg(leaf.stem + 1);
}

double CViewController::shownLodDistance() const {
    const osg::BoundingBox box = m_viewport.scene().bounds();
    return box.valid() ? lodDistance(*m_view->model->detail, double(box.zMax() - box.zMin()), m_viewport.camera()) : 0;
}

void CViewController::goToLod() {
    if (!m_view) return;
    m_viewport.frame();
    if (const double distance = shownLodDistance(); distance > 0) m_viewport.moveTo(distance);
}

QStringList CViewController::statistics() const {
    if (!m_statistics || !m_view) return {};
    const TreeModel& tree = *m_view->model;
    const QLocale numbers;
    const auto whole = [&](std::size_t n) { return numbers.toString(qulonglong(n)); };
    const osg::BoundingBox box = m_viewport.scene().bounds();
    QStringList rows{toQString(m_document.params().text.species)};
    if (box.valid())
        rows << tr("Height %1, width %2")
                    .arg(lengthText(box.zMax()),
                         lengthText(std::max(box.xMax() - box.xMin(), box.yMax() - box.yMin())));
    for (std::size_t g = 0; g < tree.tree->generationCount(); ++g)
        rows << tr("%1: %2, %3 triangles")
                    .arg(levelTitle(int(g)), stemsText(tree.tree->generation(g).stems.size()),
                         whole(tree.stems[g]->triangleCount()));
    rows
        << tr("Leaves: %1, %2 triangles").arg(whole(tree.tree->organs(Organ::Leaf)->total), whole(trianglesOfLeaves(tree)));
    if (const double distance = shownLodDistance(); distance > 0)
        rows << tr("%1: %2 triangles, from %3 on").arg(detailTitle(*tree.detail), whole(tree.triangleCount()), lengthText(distance));
    rows << tr("Structure %1 ms, mesh %2 ms")
                .arg(numbers.toString(tree.milliseconds.structure, 'f', 1),
                     numbers.toString(tree.milliseconds.smooth + tree.milliseconds.mesh, 'f', 1));
    return rows;
}

void CViewController::updateOverlay() {
    CViewOverlay::Model& model = m_viewport.overlay().model();
    model.params = m_document.params();
    model.guide = m_guide;
    model.statistics = statistics();
    if (m_view) model.scaleTree = m_view->model->tree->height();
    if (const osg::BoundingBox box = m_viewport.scene().bounds(); box.valid())
        model.reach = std::max({box.xMax(), -box.xMin(), box.yMax(), -box.yMin(), 0.1f});
    const ViewLook& look = m_viewport.look();
    model.person = look.ground ? std::optional(m_viewport.scene().personAt()) : std::nullopt;
    model.personText = lengthText(CViewScene::kPersonHeight);
    m_viewport.overlay().update();
}

void CViewController::setLook(const std::function<void(ViewLook&)>& change) {
    ViewLook look = m_viewport.look();
    change(look);
    m_viewport.setLook(look);
    updateOverlay();
}

void CViewController::setStatistics(bool on) {
    m_statistics = on;
    updateOverlay();
}

std::shared_ptr<const BackdropPicture> CViewController::askForPicture(QWidget* parent, const QString& title, const QString& kinds) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    const QString file = QFileDialog::getOpenFileName(parent, title, folder, kinds);
    if (file.isEmpty()) return nullptr;
    try {
        return readBackdrop(toPath(file).string());
    } catch (const CError& e) {
        QMessageBox::critical(parent, tr("Cannot show the picture"), errorText(e));
        return nullptr;
    }
}

bool CViewController::chooseBackdrop(QWidget* parent) {
    const auto picture = askForPicture(parent, tr("Picture Behind the Tree"), tr("Pictures and HDRI panoramas (*.png *.jpg *.jpeg *.hdr)"));
    if (!picture) return false;
    setLook([&](ViewLook& look) {
        look.backdrop = Backdrop::Picture;
        look.picture = picture;
    });
    return true;
}

bool CViewController::chooseReference(QWidget* parent) {
    const auto picture = askForPicture(parent, tr("Reference Picture"), tr("Pictures (*.png *.jpg *.jpeg)"));
    if (!picture) return false;
    const LengthUnit unit = lengthUnit();
    const osg::BoundingBox box = m_viewport.scene().bounds();
    const double tree = box.valid() ? double(box.zMax()) : m_viewport.look().referenceHeight;
    bool wanted = false;
    const double height = QInputDialog::getDouble(parent, tr("Reference Picture"), tr("Height of what the picture shows, from edge to edge (%1)").arg(unit.name),
                                                  tree * unit.perMetre, 0.01 * unit.perMetre, 1000 * unit.perMetre, 2, &wanted);
    if (!wanted) return false;
    setLook([&](ViewLook& look) {
        look.reference = picture;
        look.referenceHeight = height / unit.perMetre;
    });
    return true;
}

void CViewController::savePicture(QWidget* parent) {
    CPictureDialog dialog(m_viewport.size() * m_viewport.devicePixelRatioF(), parent);
    if (dialog.exec() != QDialog::Accepted) return;
    const PictureOptions wanted = dialog.options();
    ViewLook look = m_viewport.look();
    if (wanted.transparent) look.backdrop = Backdrop::Nothing;
    QProgressDialog progress(tr("Writing pictures"), tr("Cancel"), 0, wanted.frames, parent);
    progress.setWindowModality(Qt::WindowModal);
    progress.setMinimumDuration(wanted.frames > 1 ? 0 : kPatience);
    progress.setValue(0);
    QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents); // the dialog that asked is gone, and this one painted
    CCamera camera = m_viewport.camera();
    const int passes = wanted.frames == 1 ? CRestPicture::kPasses : CRestPicture::kFramePasses;
    int written = 0;
    for (; written < wanted.frames && !progress.wasCanceled(); ++written) {
        const QString file = wanted.fileOf(written);
        if (!writeImage(m_viewport.picture(wanted.size, look, camera, passes), file)) {
            progress.close(); // it would lie above the message
            QMessageBox::critical(parent, tr("Cannot save the picture"), tr("%1 cannot be written.").arg(file));
            return;
        }
        camera.turn(360.0 / wanted.frames, 0);
        progress.setValue(written + 1);
    }
    emit notice(wanted.frames == 1 ? tr("Saved %1").arg(wanted.path)
                                   : tr("Saved %n frame(s) of a turntable", nullptr, written));
}

} // namespace stromar
