#pragma once
#include "stromar/mesh/Detail.h"
#include "stromar/params/ParamTable.h"
#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QString>
#include <exception>
#include <filesystem>
#include <string_view>

namespace stromar {

// Between Qt's texts and the layers below. UTF-8 there.

inline QString toQString(std::string_view text) { return QString::fromUtf8(text.data(), qsizetype(text.size())); }
/// What an error says, as a sentence: with a capital, unless it begins with a place in a file.
inline QString errorText(const std::exception& e) {
    QString text = QString::fromUtf8(e.what());
    const bool place = text.section(QLatin1Char(' '), 0, 0).contains(QRegularExpression(QStringLiteral("[/\\\\.:_]")));
    if (!text.isEmpty() && !place) text[0] = text[0].toUpper();
    return text;
}
/// A text marked with N_ below, in the user's language.
inline QString trText(std::string_view marked) {
    return QCoreApplication::translate("stromar", QByteArray(marked.data(), qsizetype(marked.size())).constData());
}
/// "Trunk", "Branches 2", "Leaves": tabs, menus and messages name a level alike.
inline QString groupTitle(Group group, int level) {
    const QString name = trText(group.name);
    return group == Group::Branches ? QStringLiteral("%1 %2").arg(name).arg(level) : name;
}
inline QString levelTitle(int level) { return groupTitle(level == 0 ? Group::Trunk : Group::Branches, level); }

inline QString detailTitle(const Detail& detail) {
    if (detail.model == Model::Simple) return QCoreApplication::translate("Counts", "Simple model");
    if (detail.lod == 0) return QCoreApplication::translate("Counts", "Full model");
    return QCoreApplication::translate("Counts", "Level of detail %1").arg(detail.lod);
}
inline QString stemsText(std::size_t count) {
    return count == 1 ? QCoreApplication::translate("Counts", "1 stem")
                      : QCoreApplication::translate("Counts", "%1 stems").arg(QLocale().toString(qulonglong(count)));
}

inline std::filesystem::path toPath(const QString& path) { return std::filesystem::path(path.toStdU16String()); }
inline QString fromPath(const std::filesystem::path& path) { return QString::fromStdU16String(path.u16string()); }

} // namespace stromar
