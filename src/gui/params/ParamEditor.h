#pragma once
#include "stromar/params/ParamTable.h"
#include "window/WheelGuard.h"
#include <QElapsedTimer>
#include <QWidget>

class QAbstractSpinBox;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QPlainTextEdit;
class QSpinBox;

namespace stromar {

struct TextLanguage;
class CCurveEditor;
class CLanguageEditor;
class CParamSlider;

/// The editor of one value, made from its row of the parameter table: slider and spin box, a choice, a switch, a curve
/// or lines of text.
/// The wheel changes it only while it has the focus.
class CParamEditor : public QWidget {
    Q_OBJECT
public:
    enum class Form {
        Whole,    ///< with a slider
        Variation ///< a spin box alone, to stand beside the value it varies
    };

    explicit CParamEditor(const ParamRef& ref, Form form = Form::Whole, QWidget* parent = nullptr);

    const ParamRef& ref() const { return m_ref; }
    /// Shows a value without telling.
    void showValue(const ParamValue& value);
    /// The tree that the value belongs to, for editors that show more of it.
    void showTree(const CParams& params);
    /// Takes as little room as it can.
    void setNarrow(bool narrow);
    /// The editor of a text that has a language, else null.
    CLanguageEditor* language() const { return m_language; }
    /// The editor of a curve, else null.
    CCurveEditor* curve() const { return m_curve; }
    /// Whether the slider, or a point of the curve, is held.
    bool held() const;

signals:
    /// The user set a value. All changes of one drag, or of one burst of keys or wheel, have the same positive gesture;
    /// 0 stands alone.
    void edited(const stromar::ParamRef& ref, const stromar::ParamValue& value, int gesture);
    void released();
    /// The cursor went to another line of a text; 0: away.
    void lineTouched(const stromar::ParamRef& ref, int line);
    /// A point of a curve is held that acts between these x, which are not included.
    void rangeHeld(const stromar::ParamRef& ref, double low, double high);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void addChoice();
    void addNumber(Form form);
    void addSwitch();
    void addSeed();
    void addCurve();
    void addBlock();
    void addLanguage(const TextLanguage& language);
    void takeBlock();
    void addSlider();
    QAbstractSpinBox* makeBox(Form form);
    QAbstractSpinBox* box() const;
    void guardWheel(QWidget* editor);
    int sliderPosition(double value) const;
    double sliderValue(int position) const;
    void showNumber(double value);
    void onBox(double value);
    void onSlider(int position);
    int gestureNow();

    ParamRef m_ref;
    QComboBox* m_choice = nullptr;
    QCheckBox* m_switch = nullptr;
    CParamSlider* m_slider = nullptr;
    CCurveEditor* m_curve = nullptr;
    QPlainTextEdit* m_block = nullptr;
    CLanguageEditor* m_language = nullptr;
    QDoubleSpinBox* m_real = nullptr;
    QSpinBox* m_whole = nullptr;
    CWheelGuard m_wheel;
    double m_perUnit = 1; ///< shown numbers per metre
    bool m_varies = false;
    int m_gesture = 0;
    QElapsedTimer m_sinceChange;
};

} // namespace stromar
