#include "WindowKeeper.h"
#include "Languages.h"
#include "Settings.h"
#include "Viewport.h"

namespace stromar {

CWindowKeeper::CWindowKeeper(double mostVertices, QObject* parent) : QObject(parent), m_mostVertices(mostVertices) {
    make(nullptr);
}

void CWindowKeeper::make(std::shared_ptr<CDocument> document) {
    speak(chosenLanguage(CSettings::instance().text("language")));
    m_window = std::make_unique<CMainWindow>(m_mostVertices, std::move(document));
    connect(m_window.get(), &CMainWindow::rebuildWanted, this, &CWindowKeeper::rebuild, Qt::QueuedConnection);
}

void CWindowKeeper::rebuild() {
    m_window->keepLayout();
    const bool shown = m_window->isVisible();
    const std::shared_ptr<CDocument> document = m_window->sharedDocument();
    m_window.reset(); // before the new one: both would keep the document's changes aside
    make(document);
    m_window->setVisible(shown);
}

} // namespace stromar
