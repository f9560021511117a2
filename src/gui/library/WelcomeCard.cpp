#include "library/WelcomeCard.h"
#include "library/PresetBrowser.h"
#include "window/QtText.h"
#include "stromar/app/Methods.h"
#include "stromar/app/Pictures.h"
#include "stromar/params/TreeFile.h"
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QVBoxLayout>

namespace stromar {

namespace {
constexpr const char* kDoneKey = "welcomed";
constexpr int kPicture = 72, kMargin = 14; // pixels
constexpr const char* kWelcomePresets[] = {"quaking_aspen", "english_oak", "scots_pine", "wild_cherry", "strand_oak"};
} // namespace

CWelcomeCard::CWelcomeCard(QWidget* over) : QFrame(over) {
    setObjectName(QStringLiteral("welcome"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    auto* column = new QVBoxLayout(this);
    column->addWidget(makeHead());
    column->addWidget(makePresets());
    column->addWidget(makeWays());
    over->installEventFilter(this);
    show();
    place();
}

bool CWelcomeCard::wanted() { return !QSettings().value(QLatin1String(kDoneKey)).toBool(); }

QWidget* CWelcomeCard::makeHead() {
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(new QLabel(QStringLiteral("<b>%1</b> %2").arg(tr("Welcome to Stromar."), tr("Begin with a tree and change it:"))), 1);
    auto* close = new QToolButton;
    close->setObjectName(QStringLiteral("closeWelcome"));
    close->setText(QStringLiteral("✕"));
    close->setAutoRaise(true);
    close->setAccessibleName(tr("Close"));
    connect(close, &QToolButton::clicked, this, &CWelcomeCard::finish);
    row->addWidget(close);
    return head;
}

QWidget* CWelcomeCard::makePresets() {
    auto* presets = new QWidget;
    auto* row = new QHBoxLayout(presets);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (const char* name : kWelcomePresets) {
        const QString path = fromPath(dataFolder() / "presets" / (std::string(name) + ".tree"));
        auto* button = new QToolButton;
        button->setObjectName(QLatin1String(name));
        button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        button->setAutoRaise(true);
        button->setIcon(QIcon(CPresetBrowser::shippedPicture(QFileInfo(path))));
        button->setIconSize({kPicture, kPicture});
        button->setText(CPresetBrowser::nameOf(path));
        connect(button, &QToolButton::clicked, this, [this, path] {
            emit presetWanted(path);
            finish();
        });
        row->addWidget(button);
    }
    return presets;
}

QWidget* CWelcomeCard::makeWays() {
    auto* ways = new QWidget;
    auto* row = new QHBoxLayout(ways);
    row->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char* name, const QString& text) {
        auto* button = new QPushButton(text);
        button->setObjectName(QLatin1String(name));
        button->setAutoDefault(false);
        row->addWidget(button);
        return button;
    };
    connect(add("allPresets", tr("All Presets")), &QPushButton::clicked, this, [this] {
        emit allPresetsWanted();
        finish();
    });
    connect(add("openFile", tr("Open a File…")), &QPushButton::clicked, this, [this] {
        finish();
        emit fileWanted();
    });
    auto* menu = new QMenu(this);
    for (const TreeMethod& method : treeMethods()) {
        const ParamBlock& block = *method.block;
        QAction* action = menu->addAction(trText(block.label), this, [this, &block] {
            emit methodWanted(block);
            finish();
        });
        action->setToolTip(trText(block.help));
    }
    menu->setToolTipsVisible(true);
    add("newTree", tr("New Tree by"))->setMenu(menu);
    row->addStretch(1);
    return ways;
}

void CWelcomeCard::place() {
    adjustSize();
    const QSize room = parentWidget()->size();
    move((room.width() - width()) / 2, room.height() - height() - kMargin);
    setVisible(width() <= room.width());
    emit placed(isVisibleTo(parentWidget()) ? height() + kMargin : 0);
}

void CWelcomeCard::finish() {
    QSettings().setValue(QLatin1String(kDoneKey), true);
    hide();
    emit placed(0);
    deleteLater();
}

bool CWelcomeCard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) place();
    return QFrame::eventFilter(watched, event);
}

} // namespace stromar
