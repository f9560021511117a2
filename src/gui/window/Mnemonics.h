#pragma once
#include <QAction>
#include <QList>
#include <QSet>
#include <QString>

namespace stromar {

/// Gives the entries of a menu letters of their own for the keyboard: the marked one where it is free, else the first of a word,
/// else any; where none is left, none.
inline void assignMnemonics(const QList<QAction*>& actions) {
    QSet<QChar> used;
    QList<QAction*> open;
    const auto take = [&](QAction* action, QString text, qsizetype at) {
        used.insert(text[at].toUpper());
        action->setText(text.insert(at, QLatin1Char('&')));
    };
    for (QAction* action : actions) {
        const qsizetype marked = action->text().indexOf(QLatin1Char('&'));
        QString plain = action->text();
        plain.remove(QLatin1Char('&'));
        const bool free = marked >= 0 && marked < plain.size() && !used.contains(plain[marked].toUpper());
        if (free)
            take(action, plain, marked);
        else if (!plain.isEmpty())
            open.push_back(action);
        if (!free) action->setText(plain);
    }
    for (QAction* action : open) {
        const QString plain = action->text();
        for (const bool ofWords : {true, false}) {
            const auto isFree = [&](qsizetype i) {
                const bool first = i == 0 || plain[i - 1] == QLatin1Char(' ');
                return plain[i].isLetter() && first >= ofWords && !used.contains(plain[i].toUpper());
            };
            qsizetype at = 0;
            while (at < plain.size() && !isFree(at)) ++at;
            if (at == plain.size()) continue;
            take(action, plain, at);
            break;
        }
    }
}

} // namespace stromar
