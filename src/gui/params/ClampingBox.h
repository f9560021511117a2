#pragma once
#include <QCoreApplication>
#include <QToolTip>
#include <QValidator>
#include <algorithm>
#include <optional>

namespace stromar {

/// A QSpinBox or QDoubleSpinBox that lets one type numbers beyond the range, and says so when it takes the nearest: by itself a box
/// swallows the last digit.
template <typename Box>
class CClampingBox : public Box {
public:
    QValidator::State validate(QString& text, int& position) const override {
        const QValidator::State state = Box::validate(text, position);
        return state == QValidator::Invalid && typed(text) ? QValidator::Intermediate : state;
    }
    void fixup(QString& text) const override {
        const std::optional<double> number = typed(text);
        if (!number) return Box::fixup(text);
        const bool high = *number > this->maximum();
        text = this->textFromValue(high ? this->maximum() : std::max(static_cast<decltype(this->minimum())>(*number), this->minimum()));
        if (high || *number < this->minimum()) {
            const QString word = high ? QCoreApplication::translate("ClampingBox", "The maximum is %1")
                                      : QCoreApplication::translate("ClampingBox", "The minimum is %1");
            QToolTip::showText(this->mapToGlobal(this->rect().bottomLeft()), word.arg(text + this->suffix()), const_cast<CClampingBox*>(this));
        }
    }

private:
    std::optional<double> typed(QString text) const {
        if (text.startsWith(this->prefix())) text.remove(0, this->prefix().size());
        if (text.endsWith(this->suffix())) text.chop(this->suffix().size());
        bool isNumber = false;
        const double number = this->locale().toDouble(text.trimmed(), &isNumber);
        return isNumber ? std::optional(number) : std::nullopt;
    }
};

} // namespace stromar
