#include "window/WindowKeeper.h"
#include "document/FileController.h"
#include "window/Languages.h"
#include "window/Settings.h"
#include "view/Viewport.h"

namespace stromar {

CWindowKeeper::CWindowKeeper(const SizeLimits& limits, QObject* parent) : QObject(parent), m_limits(limits) {
    make(nullptr);
}

void CWindowKeeper::make(std::shared_ptr<CDocument> document) {
    speak(chosenLanguage(CSettings::instance().text("language")));
    m_window = std::make_unique<CMainWindow>(m_limits, std::move(document));
    connect(m_window.get(), &CMainWindow::rebuildWanted, this, &CWindowKeeper::rebuild, Qt::QueuedConnection);
}

void CWindowKeeper::rebuild() {
    const std::unique_ptr<CMainWindow> old = std::move(m_window);
    old->keepLayout();
    make(old->sharedDocument());
    m_window->files().autosave().flush(); // changes are kept aside by the new window before the old one lets go
    m_window->setVisible(old->isVisible());
}

} // namespace stromar
