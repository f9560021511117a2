#include "window/PreferencesDialog.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "stromar/app/Pictures.h"
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

namespace stromar {

namespace {
QWidget* makeChoice(const Setting& setting) {
    auto* choice = new QComboBox;
    const QString now = CSettings::instance().text(setting.key);
    for (const SettingWord& word : setting.words()) {
        choice->addItem(word.text, word.word);
        if (word.word == now) choice->setCurrentIndex(choice->count() - 1);
    }
    QObject::connect(choice, &QComboBox::activated, choice, [choice, &setting](int index) {
        CSettings::instance().set(setting.key, choice->itemData(index).toString());
    });
    return choice;
}

QWidget* makeNumber(const Setting& setting) {
    auto* box = new QSpinBox;
    box->setRange(setting.min, setting.max);
    box->setSingleStep(setting.step);
    box->setSuffix(trText(setting.unit));
    if (*setting.whenZero) box->setSpecialValueText(trText(setting.whenZero));
    box->setValue(CSettings::instance().number(setting.key));
    QObject::connect(box, &QSpinBox::valueChanged, box,
                     [&setting](int value) { CSettings::instance().set(setting.key, QString::number(value)); });
    return box;
}

QString emptyCacheText() {
    return CPreferencesDialog::tr("Clear the Picture Cache (%1)").arg(QLocale().formattedDataSize(qint64(pictureCacheSize())));
}

/// They are drawn again when a tree needs them.
QWidget* makeEmptyCache() {
    auto* button = new QPushButton(emptyCacheText());
    button->setObjectName(QStringLiteral("emptyCache"));
    button->setAutoDefault(false);
    QObject::connect(button, &QPushButton::clicked, button, [button] {
        trimPictureCache(0);
        button->setText(emptyCacheText());
    });
    return button;
}
} // namespace

CPreferencesDialog::CPreferencesDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Preferences"));
    auto* form = new QFormLayout(this);
    for (const Setting& setting : settingTable()) {
        QWidget* editor = setting.kind == Setting::Kind::Choice ? makeChoice(setting) : makeNumber(setting);
        editor->setObjectName(QString::fromLatin1(setting.key));
        editor->setAccessibleName(trText(setting.label));
        editor->setToolTip(trText(setting.help));
        auto* label = new QLabel(trText(setting.label));
        label->setToolTip(trText(setting.help));
        label->setBuddy(editor);
        form->addRow(label, editor);
    }
    form->addRow(makeEmptyCache());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::accept);
    form->addRow(buttons);
}

} // namespace stromar
