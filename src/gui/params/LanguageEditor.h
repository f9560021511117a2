#pragma once
#include "work/LatestTask.h"
#include "stromar/app/TextLanguage.h"
#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QSpinBox;
class QVBoxLayout;

namespace stromar {

class CCodeEditor;
class CDefineSlider;

/// A text in a language with all that helps to write it: the editor, what is wrong, a slider for every number that the
/// text offers, and the steps of what it describes. It can be detached into a window of its own.
class CLanguageEditor : public QWidget {
    Q_OBJECT
public:
    explicit CLanguageEditor(const TextLanguage& language, QWidget* parent = nullptr);
    ~CLanguageEditor() override;

    void showText(const QString& text);
    /// The tree that the text describes, for its steps.
    void showParams(const CParams& params);
    CCodeEditor& code() { return *m_code; }
    /// Whether a slider is held.
    bool held() const;
    bool detached() const { return !m_window.isNull(); }
    void setDetached(bool detach);
    /// Marks the line that wrote what was picked.
    void showLine(int line);

signals:
    /// The text is another one, and right. All changes of one drag or one burst of typing have the same gesture.
    void edited(const QString& text, int gesture);
    void released();
    /// The cursor went to another line; 0: away.
    void lineTouched(int line);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeToolBar();
    QWidget* makeSteps();
    void tellLine();
    void onTyped();
    void check();
    void commit();
    void showFaults();
    void updateSliders();
    void moveSlider(const CDefineSlider& slider, double value);
    void find(bool backwards);
    void importFile();
    void exportFile();
    void readStep();
    void showStep(const TextLanguage::Step& step);

    const TextLanguage& m_language;
    QWidget* m_inner; ///< what is detached
    QPointer<QWidget> m_window;
    CCodeEditor* m_code;
    QLineEdit* m_find;
    QListWidget* m_problems;
    QVBoxLayout* m_sliderColumn;
    std::vector<CDefineSlider*> m_sliders;
    QSpinBox* m_step;
    QLabel* m_rules;
    QPlainTextEdit* m_word;
    CLatestTask m_reader;
    std::unique_ptr<CParams> m_params;
    QTimer m_typed, m_stepPause;
    QElapsedTimer m_sinceCommit;
    QString m_committed;
    int m_gesture = 0, m_line = 0;
};

} // namespace stromar
