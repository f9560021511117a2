#pragma once
#include <QFrame>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace stromar {

/// A message above the picture with what can be done about it. One at a time; a newer one replaces it.
class CMessageBar : public QFrame {
    Q_OBJECT
public:
    struct Choice {
        QString text;
        std::function<void()> run;
    };

    explicit CMessageBar(QWidget* parent = nullptr);
    /// `about` names the matter, so that only its own message is taken back.
    void ask(const QString& about, const QString& text, const std::vector<Choice>& choices);
    void dismiss(const QString& about);
    const QString& about() const { return m_about; }
    QString text() const;

private:
    QLabel* m_text;
    QHBoxLayout* m_row;
    std::vector<QWidget*> m_buttons;
    QString m_about;
};

} // namespace stromar
