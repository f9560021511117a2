#pragma once
#include "Checkout.h"
#include "stromar/params/ParamText.h"
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QString>
#include <QTest>

/// The event loop runs until `condition` holds; false after `milliseconds`.
template <typename Condition>
bool waitFor(Condition&& condition, int milliseconds = 20000) {
    QElapsedTimer clock;
    clock.start();
    while (!condition()) {
        if (clock.elapsed() > milliseconds) return false;
        QTest::qWait(5);
    }
    return true;
}

inline QString presetPath(const char* name) {
    return QString::fromStdString(stromar::test::inSource("presets/%1.tree")).arg(QLatin1String(name));
}

inline stromar::ParamRef paramRef(const char* key) { return *stromar::findParam(key); }
