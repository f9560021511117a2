#include "work/GrowthController.h"
#include "window/Display.h"
#include "window/MessageBar.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "stromar/app/Prediction.h"
#include <QLocale>
#include <utility>

namespace stromar {

namespace {
constexpr const char *kAboutSize = "size", *kAboutFault = "fault";
constexpr int kSoundMs = 3000; // that drawing pictures takes before it fails
}

CGrowthController::CGrowthController(CDocument& document, CMessageBar& bar, const SizeLimits& limits, QObject* parent)
    : QObject(parent), m_document(document), m_bar(bar), m_limits(limits), m_givenMemory(limits.bytes),
      m_thread(std::make_unique<CTreeCreator>(true, limits)) {
    m_pause.setSingleShot(true);
    connect(&m_pause, &QTimer::timeout, this, &CGrowthController::requestFull);
    connect(&m_thread, &CTreeCreatorThread::created, this, &CGrowthController::onCreated);
    connect(&m_thread, &CTreeCreatorThread::tooLarge, this,
            [this](const std::shared_ptr<const TooLargeTree>& tree) { onTooLarge(*tree); });
    connect(&m_thread, &CTreeCreatorThread::surfaceRead, this, &CGrowthController::surfaceRead);
    connect(&m_thread, &CTreeCreatorThread::failed, this, &CGrowthController::onFailed);
    m_sound.setSingleShot(true);
    m_sound.setInterval(kSoundMs);
    connect(&m_sound, &QTimer::timeout, this, [this] { m_bar.dismiss(QLatin1String(kAboutFault)); });
}

void CGrowthController::follow() {
    request(m_only.value_or(Model::Simple));
    if (!m_only && !m_playing) m_pause.start();
}

void CGrowthController::setAge(double age) {
    if (age == m_age) return;
    m_age = age;
    follow();
}

void CGrowthController::setPlaying(bool on) {
    m_playing = on;
    if (on)
        m_pause.stop();
    else if (!m_only)
        m_pause.start();
}

void CGrowthController::setSwaying(bool on) {
    if (on == m_swaying) return;
    m_swaying = on;
    if (on) request(m_last);
}

void CGrowthController::growFull() {
    m_pause.stop();
    m_only.reset();
    request(Model::Full);
}

void CGrowthController::generate() { request(m_only.value_or(Model::Full), true); }

bool CGrowthController::stop() {
    m_pause.stop();
    const bool growing = m_thread.progress().has_value();
    m_thread.cancel();
    return growing;
}

void CGrowthController::showOnly(Model model) {
    m_only = model;
    follow();
}

void CGrowthController::setLod(int lod) {
    if (lod == std::exchange(m_lod, lod) && !m_only) return;
    growFull();
}

void CGrowthController::setMaxMemory(int gigabytes) { m_limits.bytes = gigabytes > 0 ? 1e9 * gigabytes : m_givenMemory; }

SizeLimits CGrowthController::limits() const {
    return m_document.params() == m_allowed ? SizeLimits::none() : m_limits;
}

void CGrowthController::request(Model model, bool anew) {
    m_last = model;
    const Detail& detail = detailOf(model, model == Model::Full ? m_lod : 0);
    m_thread.request({m_document.params(), m_document.folder(), &detail, limits(), anew, m_age, m_swaying});
    emit started();
}

void CGrowthController::requestFull() {
    if (!m_held() && !m_only) request(Model::Full);
}

void CGrowthController::onCreated(const std::shared_ptr<const ViewModel>& view) {
    if (view->model->params == m_document.params()) m_bar.dismiss(QLatin1String(kAboutSize));
    m_sound.start();
    emit created(view);
}

/// It stays to be read, but never in place of a question.
void CGrowthController::onFailed(const QString& why) {
    m_sound.stop();
    if (m_bar.about().isEmpty() || m_bar.about() == QLatin1String(kAboutFault)) m_bar.ask(QLatin1String(kAboutFault), why, {});
    emit failed(why);
}

void CGrowthController::onTooLarge(const TooLargeTree& tree) {
    if (tree.params != m_document.params()) return; // a newer one is under way
    m_pause.stop();
    std::vector<CMessageBar::Choice> choices;
    if (tree.fits) {
        const auto [ref, value] = *tree.fits;
        const QString shown = ref.info->unit == Unit::Metre ? lengthText(value) : QLocale().toString(value, 'g', 6);
        choices.push_back({tr("%1 = %2 fits").arg(QStringLiteral("%1 ▸ %2").arg(groupTitle(ref.group(), ref.level), trText(ref.info->label)), shown),
                           [this, ref, value] { m_document.setValue(ref, value, 0); }});
    }
    const Prediction& size = tree.size;
    if (size.bytes < 2 * SizeLimits::defaultMemory())
        choices.push_back({tr("Grow it anyway"), [this] {
                               m_allowed = m_document.params();
                               follow();
                           }});
    if (m_document.history().canUndo())
        choices.push_back({tr("Undo"), [this] { m_document.history().undo(); }});
    else if (m_document.canGoBack())
        choices.push_back({tr("Back"), [this] { m_document.goBack(); }});
    const QLocale numbers;
    m_bar.ask(QLatin1String(kAboutSize),
              tr("Nothing has grown: this tree may have up to %1 stems, %2 leaves and %3 million vertices and take %4 GB of memory; the limit is "
                 "%5 million vertices and %6 GB.")
                  .arg(numbers.toString(size.stems, 'f', 0), numbers.toString(size.leaves, 'f', 0),
                       numbers.toString(size.vertices / 1e6, 'f', 0), numbers.toString(size.bytes / 1e9, 'f', 1),
                       numbers.toString(m_limits.vertices / 1e6, 'f', 0), numbers.toString(m_limits.bytes / 1e9, 'f', 1)),
              choices);
    emit refused();
}

} // namespace stromar
