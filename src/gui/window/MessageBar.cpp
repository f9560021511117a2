#include "window/MessageBar.h"
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace stromar {

namespace {
constexpr int kButton = 1000; // so much more of the room than the stretch in front
} // namespace

CMessageBar::CMessageBar(QWidget* parent) : QFrame(parent), m_text(new QLabel), m_row(new QHBoxLayout) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_text->setForegroundRole(QPalette::ToolTipText);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_text);
    column->addLayout(m_row);
    m_row->addStretch(1); // what the buttons leave
    hide();
}

QString CMessageBar::text() const { return m_text->text(); }

void CMessageBar::ask(const QString& about, const QString& text, const std::vector<Choice>& choices) {
    for (QWidget* button : m_buttons) {
        m_row->removeWidget(button);
        button->hide(); // it may live on while an event of its own runs
        button->deleteLater();
    }
    m_buttons.clear();
    m_about = about;
    m_text->setText(text.left(1).toUpper() + text.mid(1));
    for (const Choice& choice : choices) {
        auto* button = new QPushButton(choice.text);
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // the window is as wide as the user wants it
        button->setMaximumWidth(button->sizeHint().width());
        button->setToolTip(choice.text);
        connect(button, &QPushButton::clicked, this, [this, run = choice.run, about] {
            dismiss(about);
            run();
        });
        m_row->addWidget(button, kButton);
        m_buttons.push_back(button);
    }
    auto* close = new QToolButton;
    close->setText(QStringLiteral("✕"));
    close->setAutoRaise(true);
    close->setAccessibleName(tr("Dismiss"));
    connect(close, &QToolButton::clicked, this, [this, about] { dismiss(about); });
    m_row->addWidget(close);
    m_buttons.push_back(close);
    show();
}

void CMessageBar::dismiss(const QString& about) {
    if (m_about != about) return;
    m_about.clear();
    hide();
}

} // namespace stromar
