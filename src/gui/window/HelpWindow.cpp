#include "window/HelpWindow.h"
#include "window/QtText.h"
#include "stromar/app/Export.h"
#include <QAction>
#include <QDesktopServices>
#include <QFileInfo>
#include <QTextBrowser>
#include <QToolBar>
#include <QUrl>

namespace stromar {

namespace {
constexpr int kPageWidth = 860, kMargin = 18;

QString fileOf(const QString& page) { return fromPath(dataFolder() / "docs") + QStringLiteral("/%1.md").arg(page); }

/// Pictures are at most as wide as the text.
class CPages : public QTextBrowser {
public:
    CPages() { document()->setDocumentMargin(kMargin); }
    QVariant loadResource(int type, const QUrl& name) override {
        if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
        QImage image(source().resolved(name).toLocalFile());
        const int room = static_cast<int>((kPageWidth - 3 * kMargin) * devicePixelRatioF());
        if (image.width() > room) image = image.scaledToWidth(room, Qt::SmoothTransformation);
        image.setDevicePixelRatio(image.width() == room ? devicePixelRatioF() : 1);
        return image;
    }
};
} // namespace

bool CHelpWindow::available() { return QFileInfo::exists(fileOf(QStringLiteral("manual"))); }

CHelpWindow::CHelpWindow(QWidget* parent) : QMainWindow(parent), m_browser(new CPages) {
    setWindowTitle(tr("Stromar Manual"));
    setCentralWidget(m_browser);
    m_browser->setOpenLinks(false);
    QToolBar* bar = addToolBar(tr("Pages"));
    bar->setMovable(false);
    QAction* back = bar->addAction(tr("Back"), m_browser, &QTextBrowser::backward);
    QAction* forward = bar->addAction(tr("Forward"), m_browser, &QTextBrowser::forward);
    bar->addAction(tr("Contents"), this, [this] { open(QStringLiteral("manual")); });
    back->setEnabled(false);
    forward->setEnabled(false);
    connect(m_browser, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
    connect(m_browser, &QTextBrowser::forwardAvailable, forward, &QAction::setEnabled);
    connect(m_browser, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
        const QUrl whole = m_browser->source().resolved(link);
        if (whole.isLocalFile() && whole.path().endsWith(QLatin1String(".md")))
            m_browser->setSource(whole, QTextDocument::MarkdownResource);
        else if (!whole.isLocalFile())
            QDesktopServices::openUrl(whole);
    });
    resize(kPageWidth, 780);
}

void CHelpWindow::open(const QString& page) {
    m_browser->setSource(QUrl::fromLocalFile(fileOf(page)), QTextDocument::MarkdownResource);
}

} // namespace stromar
