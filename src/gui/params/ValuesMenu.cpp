#include "params/ValuesMenu.h"
#include "window/QtText.h"
#include "stromar/params/TreeFile.h"
#include "stromar/util/FileSet.h"
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QRegularExpression>
#include <QStandardPaths>
#include <algorithm>

namespace stromar {

namespace {
using Assign = std::function<void(const QString&, const ParamValues&)>;

QString fileName(QString text) {
    return text.replace(QRegularExpression(QStringLiteral("[^\\w-]+"), QRegularExpression::UseUnicodePropertiesOption), QStringLiteral("_"));
}

/// Where sets of a kind are kept; sets of a method that knows other values, elsewhere.
QDir folderOf(const ValueSet& set, const ParamBlock& block) {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return QDir(QStringLiteral("%1/values/%2/%3").arg(data, toQString(block.method), fileName(set.kind)));
}

std::string linesOf(const ValueSet& set, const CParams& params) { return CTreeFile::lines(params, set.refs); }

void tell(QWidget* parent, const std::exception& e) {
    QMessageBox::critical(parent, QCoreApplication::translate("Values", "Cannot use the values"), errorText(e));
}

void pasteText(const ValueSet& set, const ParamBlock& block, const std::string& text, const Assign& assign, QWidget* parent) {
    try {
        const ParamValues values = valuesFor(set, block, text);
        if (values.empty()) throw CError(QCoreApplication::translate("Values", "There is no value for %1 among these lines.").arg(set.title).toStdString());
        assign(QCoreApplication::translate("Values", "Paste %1").arg(set.title), values);
    } catch (const CError& e) {
        tell(parent, e);
    }
}

void saveSet(const ValueSet& set, const CParams& params, QWidget* parent) {
    bool wanted = false;
    const QString name = QInputDialog::getText(parent, QCoreApplication::translate("Values", "Save Values"),
                                               QCoreApplication::translate("Values", "Name of these values"), QLineEdit::Normal, set.title, &wanted)
                             .trimmed();
    if (!wanted || name.isEmpty()) return;
    const QDir folder = folderOf(set, params.block());
    const QString file = folder.filePath(fileName(name) + QStringLiteral(".tree"));
    if (QFileInfo::exists(file) &&
        QMessageBox::question(parent, QCoreApplication::translate("Values", "Save Values"),
                              QCoreApplication::translate("Values", "There are values called “%1” already. Replace them?").arg(name)) != QMessageBox::Yes)
        return;
    try {
        folder.mkpath(QStringLiteral("."));
        writeFile(toPath(file), linesOf(set, params));
    } catch (const std::exception& e) {
        tell(parent, e);
    }
}

std::string textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

void addSaved(QMenu& menu, const ValueSet& set, const ParamBlock& block, const Assign& assign, QWidget* parent) {
    const QFileInfoList saved = folderOf(set, block).entryInfoList({QStringLiteral("*.tree")}, QDir::Files, QDir::Name);
    if (saved.isEmpty()) return;
    menu.addSeparator();
    const auto nameOf = [](const QFileInfo& file) { return file.completeBaseName().replace(QLatin1Char('_'), QLatin1Char(' ')); };
    for (const QFileInfo& file : saved)
        menu.addAction(nameOf(file), parent, [=, &block] { pasteText(set, block, textOf(file.absoluteFilePath()), assign, parent); });
    QMenu* remove = menu.addMenu(QCoreApplication::translate("Values", "Remove"));
    for (const QFileInfo& file : saved)
        remove->addAction(nameOf(file), parent, [file] { QFile::moveToTrash(file.absoluteFilePath()); });
}
} // namespace

ParamValues valuesFor(const ValueSet& set, const ParamBlock& block, const std::string& text) {
    ParamValues values;
    for (auto [ref, value] : CTreeFile::parse("Method = " + std::string(block.method) + "\n" + text, "clipboard").givenValues()) {
        const auto same = std::ranges::find(set.refs, ref);
        const auto fits = same != set.refs.end() ? same : std::ranges::find(set.refs, ref.info, &ParamRef::info);
        if (fits != set.refs.end()) values.emplace_back(*fits, value);
    }
    return values;
}

void addValuesMenu(QMenu& menu, const ValueSet& set, const CParams& params, const Assign& assign, QWidget* parent) {
    const ParamBlock& block = params.block();
    menu.addSection(set.title);
    menu.addAction(QCoreApplication::translate("Values", "&Copy Values"), parent,
                   [set, params] { QGuiApplication::clipboard()->setText(toQString(linesOf(set, params))); });
    menu.addAction(QCoreApplication::translate("Values", "&Paste Values"), parent, [set, &block, assign, parent] {
        pasteText(set, block, QGuiApplication::clipboard()->text().toStdString(), assign, parent);
    });
    menu.addAction(QCoreApplication::translate("Values", "&Save Values…"), parent, [set, params, parent] { saveSet(set, params, parent); });
    addSaved(menu, set, block, assign, parent);
}

} // namespace stromar
