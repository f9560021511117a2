// The editor of grammars in the window: faults, sliders, history, steps, and what belongs together in text and tree.
#include "WindowFixture.h"
#include "params/CodeEditor.h"
#include "params/DefineSlider.h"
#include "params/LanguageEditor.h"
#include "stromar/params/methods/lsystem/LSystemParams.h"
#include "view/ViewOverlay.h"
#include <QAbstractItemView>
#include <QCompleter>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QToolButton>

namespace stromar {
namespace {

class GrammarEditor : public WindowFixture {
protected:
    void SetUp() override {
        WindowFixture::SetUp();
        ASSERT_TRUE(window.files().open(presetPath("abop_2_6a")));
        ASSERT_TRUE(showsNow(Model::Full));
    }
    CLanguageEditor& editor() { return *window.panel().editor(grammarRef())->language(); }
    CCodeEditor& code() { return editor().code(); }
    ParamRef grammarRef() { return *findParam("Grammar", lsystemBlock()); }
    const std::string& grammar() { return lsystem(window.document().params()).grammar; }
    template <typename Widget>
    Widget* part(const char* name) {
        return editor().findChild<Widget*>(QLatin1String(name));
    }
    void putCursorBehind(const QString& text) {
        const auto at = code().toPlainText().indexOf(text);
        ASSERT_GE(at, 0);
        QTextCursor cursor(code().document());
        cursor.setPosition(static_cast<int>(at + text.size()));
        code().setTextCursor(cursor);
        code().setFocus();
    }
    void type(const QString& text) { QTest::keyClicks(&code(), text); }
};

TEST_F(GrammarEditor, ShowsTheTextOfTheTree) {
    EXPECT_EQ(code().toPlainText().toStdString(), grammar());
    EXPECT_TRUE(code().faults().empty());
    EXPECT_FALSE(part<QListWidget>("problems")->isVisible());
    EXPECT_EQ(editor().findChildren<CDefineSlider*>().size(), 6);
}

TEST_F(GrammarEditor, FaultsAppearWhileTypingAndTheLastGoodTreeStays) {
    const std::string before = grammar();
    const ViewModel* shown = window.shown();
    putCursorBehind(QStringLiteral("axiom: A(1,10)"));
    const int cursor = code().textCursor().position();
    type(QStringLiteral("F(zz)"));
    ASSERT_TRUE(waitFor([&] { return !code().faults().empty(); }));
    EXPECT_EQ(code().faults()[0].line, 7);
    EXPECT_EQ(code().faults()[0].column, 17);
    EXPECT_EQ(code().textCursor().position(), cursor + 5) << "the cursor is left alone";
    auto* problems = part<QListWidget>("problems");
    EXPECT_TRUE(problems->isVisible());
    EXPECT_TRUE(problems->item(0)->text().startsWith(QStringLiteral("7:17  'zz' is not defined")));
    EXPECT_EQ(grammar(), before);
    EXPECT_EQ(window.shown(), shown);
    for (int i = 0; i < 3; ++i) QTest::keyClick(&code(), Qt::Key_Backspace);
    type(QStringLiteral("1)"));
    ASSERT_TRUE(waitFor([&] { return code().faults().empty() && grammar() != before; }));
    EXPECT_FALSE(problems->isVisible());
    EXPECT_NE(grammar().find("A(1,10)F(1)"), std::string::npos);
    ASSERT_TRUE(showsNow(Model::Full));
}

TEST_F(GrammarEditor, ASliderRewritesJustItsNumberAsOneStep) {
    const std::string before = grammar();
    const int steps = window.document().history().count();
    CDefineSlider* slider = editor().findChildren<CDefineSlider*>().at(2);
    ASSERT_EQ(slider->name(), "a0");
    auto* bar = slider->findChild<QSlider*>();
    bar->setSliderDown(true);
    EXPECT_TRUE(editor().held());
    for (const double share : {0.45, 0.42, 0.4}) bar->setValue(static_cast<int>(share * bar->maximum()));
    bar->setSliderDown(false);
    std::string wanted = before;
    wanted.replace(wanted.find("#define a0 45"), 13, "#define a0 36");
    EXPECT_EQ(grammar(), wanted);
    EXPECT_EQ(window.document().history().count(), steps + 1);
    ASSERT_TRUE(showsNow(Model::Full));
    window.document().history().undo();
    EXPECT_EQ(grammar(), before);
    EXPECT_EQ(code().toPlainText().toStdString(), before);
    EXPECT_EQ(slider->findChild<QDoubleSpinBox*>()->value(), 45);
    slider->findChild<QDoubleSpinBox*>()->setValue(36);
    EXPECT_EQ(grammar(), wanted);
}

TEST_F(GrammarEditor, UndoTakesBackLettersThenStepsOfTheDocument) {
    const std::string before = grammar();
    putCursorBehind(QStringLiteral("#define a0 45"));
    type(QStringLiteral("0"));
    ASSERT_TRUE(waitFor([&] { return grammar() != before; }));
    type(QStringLiteral("x"));
    ASSERT_TRUE(waitFor([&] { return !code().faults().empty(); }));
    QTest::keyClick(&code(), Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return code().faults().empty(); })) << "the letter that was wrong";
    const bool letterOnly = grammar() != before;
    if (letterOnly) action("undo")->trigger();
    EXPECT_EQ(grammar(), before);
    EXPECT_EQ(code().toPlainText().toStdString(), before);
}

TEST_F(GrammarEditor, CompletesWhatWasBegun) {
    putCursorBehind(QStringLiteral("F(l) [ &(a0"));
    type(QStringLiteral("+sq"));
    ASSERT_TRUE(code().completer().popup()->isVisible());
    EXPECT_EQ(code().completer().currentCompletion(), QStringLiteral("sqrt"));
    QTest::keyClick(code().completer().popup(), Qt::Key_Return);
    EXPECT_TRUE(code().toPlainText().contains(QStringLiteral("&(a0+sqrt")));
}

TEST_F(GrammarEditor, PairsBracketsAndFinds) {
    const QString text = code().toPlainText();
    const int open = static_cast<int>(text.indexOf(QLatin1Char('['))), close = static_cast<int>(text.indexOf(QLatin1Char(']')));
    EXPECT_EQ(code().matchingBracket(open), close);
    EXPECT_EQ(code().matchingBracket(close), open);
    EXPECT_EQ(code().matchingBracket(open + 1), -1);
    auto* find = part<QLineEdit>("find");
    code().setFocus();
    QTest::keyClick(&code(), Qt::Key_F, Qt::ControlModifier);
    EXPECT_TRUE(find->hasFocus());
    find->setText(QStringLiteral("wr"));
    QTest::keyClick(find, Qt::Key_Return);
    const int first = code().textCursor().selectionStart();
    EXPECT_EQ(first, text.indexOf(QStringLiteral("wr")));
    QTest::keyClick(find, Qt::Key_Return);
    EXPECT_EQ(code().textCursor().selectionStart(), text.indexOf(QStringLiteral("wr"), first + 1));
}

TEST_F(GrammarEditor, TheStepsOfTheWordAreShown) {
    auto* step = part<QSpinBox>("step");
    auto* word = part<QPlainTextEdit>("word");
    step->setValue(0);
    ASSERT_TRUE(waitFor([&] { return word->toPlainText() == QStringLiteral("A(1,10)"); }));
    EXPECT_TRUE(part<QLabel>("rules")->text().contains(QStringLiteral("line 8 × 1")));
    step->setValue(10);
    ASSERT_TRUE(waitFor([&] { return word->toPlainText().contains(QStringLiteral("more")); }));
    EXPECT_TRUE(word->toPlainText().startsWith(QStringLiteral("!(10)F(1)[&(45)")));
}

TEST_F(GrammarEditor, APickedBranchMarksItsLineAndALineItsBranches) {
    putCursorBehind(QStringLiteral("p3: C(l,w)"));
    auto& model = window.viewport().overlay().model();
    ASSERT_TRUE(waitFor([&] { return !model.selection.lines.empty(); }));
    EXPECT_GT(model.selection.lines.size(), 100u);
    EXPECT_TRUE(model.selectionText.startsWith(QStringLiteral("Line 10 wrote")));
    window.panel().tabs().setCurrentIndex(1);
    emit window.viewport().picked(ViewHit{0, osg::Vec3d(0, 0, 0.5)});
    EXPECT_EQ(window.panel().tabs().currentIndex(), 0) << "the grammar's tab";
    EXPECT_EQ(code().currentLine(), 8) << "the trunk is written by p1";
}

TEST_F(GrammarEditor, CanBeDetached) {
    auto* detach = part<QToolButton>("detach");
    detach->click();
    EXPECT_TRUE(editor().detached());
    EXPECT_EQ(detach->text(), QStringLiteral("Attach"));
    EXPECT_NE(code().window(), &window);
    EXPECT_TRUE(code().isVisible());
    code().window()->close();
    EXPECT_FALSE(editor().detached());
    EXPECT_EQ(code().window(), &window);
}

TEST_F(GrammarEditor, ADoublingGrammarIsRefusedInTheWindow) {
    const auto shown = window.shown()->model;
    window.document().edit(QStringLiteral("doubling"), [](CParams& params) {
        lsystem(params).grammar = "axiom: A\nA -> F A A";
        lsystem(params).derivations = 60;
    });
    ASSERT_TRUE(waitFor([&] { return notice().contains(QStringLiteral("modules in 60 derivations")); })) << notice().toStdString();
    EXPECT_EQ(window.shown()->model->tree->generations(), shown->tree->generations()) << "the tree that was there stays";
}

} // namespace
} // namespace stromar
