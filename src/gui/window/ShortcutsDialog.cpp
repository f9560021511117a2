#include "window/ShortcutsDialog.h"
#include "view/Navigation.h"
#include "window/Commands.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QKeySequence>
#include <QScreen>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>

namespace stromar {

namespace {
constexpr int kWidth = 460, kHeight = 640;
constexpr double kPartOfScreen = 0.8;

using Rows = QList<std::pair<QString, QString>>;

QString table(const QString& title, const Rows& rows) {
    QString text = QStringLiteral("<p><b>%1</b></p><table>").arg(title);
    for (const auto& [key, what] : rows) text += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>").arg(key, what);
    return text + QStringLiteral("</table>");
}

Rows commandRows() {
    Rows rows;
    for (const Command& command : commandTable())
        if (*command.shortcut)
            rows.emplace_back(QKeySequence(QLatin1String(command.shortcut)).toString(QKeySequence::NativeText),
                              QCoreApplication::translate("Commands", command.text).remove(QLatin1Char('&')).remove(QChar(0x2026)));
    return rows;
}
} // namespace

CShortcutsDialog::CShortcutsDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Mouse and keys"));
    Rows picture;
    for (const MouseGesture& gesture : navigationNamed(CSettings::instance().text("navigation")).gestures)
        picture.emplace_back(gestureText(gesture), motionText(gesture.motion));
    picture << std::pair(tr("Wheel"), tr("Nearer and farther")) << std::pair(tr("Click"), tr("Show details of the stem or leaf"));
    const Rows editors{{tr("Wheel"), tr("Scroll; changes an editor only after a click into it")},
                       {tr("Shift"), tr("Finer steps of a slider")},
                       {tr("Ctrl"), tr("Larger steps of a slider")},
                       {tr("Double click on a name"), tr("Back to the default")},
                       {tr("Right click on a name"), tr("Copy, paste, lock")}};
    auto* text = new QTextBrowser(this);
    text->setHtml(table(tr("In the picture"), picture) + table(tr("In the parameters"), editors) + table(tr("Keys"), commandRows()));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(text);
    layout->addWidget(buttons);
    resize(kWidth, std::min(kHeight, static_cast<int>(kPartOfScreen * screen()->availableSize().height())));
}

} // namespace stromar
