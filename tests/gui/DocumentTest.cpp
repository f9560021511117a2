#include "document/Document.h"
#include "Support.h"
#include "stromar/params/methods/weberpenn/WeberPennParams.h"
#include "stromar/util/FileSet.h"
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace stromar {
namespace {

double valueOf(const CDocument& document, const char* key) { return paramRef(key).get(document.params()); }

TEST(Document, ADragIsOneStepAndGesturesAreApart) {
    CDocument document;
    for (const double v : {11.0, 12.0, 13.0}) document.setValue(paramRef("Scale"), v, 1);
    document.setValue(paramRef("Scale"), 14, 2);
    document.setValue(paramRef("Ratio"), 0.5, 2);
    EXPECT_EQ(document.history().count(), 3);
    document.history().undo();
    EXPECT_EQ(valueOf(document, "Ratio"), weberPenn(CDocument().params()).ratio);
    document.history().undo();
    EXPECT_EQ(valueOf(document, "Scale"), 13);
    document.history().undo();
    EXPECT_EQ(document.params(), CParams());
    EXPECT_FALSE(document.isModified());
    document.history().redo();
    EXPECT_EQ(valueOf(document, "Scale"), 13);
}

TEST(Document, StepsSayWhatTheyChangeInThePanelsWords) {
    CDocument document;
    for (const double v : {60.0, 75.0, 90.0}) document.setValue(paramRef("1Branches"), v, 1);
    EXPECT_EQ(document.history().text(0).toStdString(), "Branches 1 ▸ Number: 10 → 90") << "all of a drag";
    document.setValue(paramRef("Shape"), 1, 0);
    EXPECT_EQ(document.history().text(1).toStdString(), "Tree ▸ Crown shape: conical → spherical");
    document.setValue(paramRef("Seed"), 629581, 0);
    EXPECT_EQ(document.history().text(2).section(QStringLiteral("→ "), 1).toStdString(), "629,581");
    document.setValue(paramRef("Scale"), 13.05, 0);
    EXPECT_EQ(document.history().text(3).section(QStringLiteral("→ "), 1).toStdString(), "13.05\u00a0m");
    document.setValue(paramRef("Species"), std::string("Elm"), 0);
    EXPECT_FALSE(document.history().text(4).contains(QStringLiteral("→"))) << "texts may be long";
}

TEST(Document, ADragBackToItsStartLeavesNoStep) {
    CDocument document;
    for (const double v : {11.0, 12.0, 10.0}) document.setValue(paramRef("Scale"), v, 1);
    EXPECT_EQ(document.history().count(), 0);
    EXPECT_FALSE(document.isModified());
}

TEST(Document, EditsOfEveryValueAreTakenBack) {
    for (const ParamRef& ref : numberParams()) {
        CDocument document;
        const double other =
            ref.get(document.params()) == ref.info->range.max ? ref.info->range.min : ref.info->range.max;
        document.setValue(ref, other, 0);
        EXPECT_EQ(ref.get(document.params()), other) << ref.key();
        document.history().undo();
        EXPECT_EQ(document.params(), CParams()) << ref.key();
    }
}

TEST(Document, AFileThatCannotBeReadChangesNothing) {
    QTemporaryDir folder;
    const QString bad = folder.filePath(QStringLiteral("bad.tree"));
    writeFile(bad.toStdString(), "Format = 1\nScale = big\n");
    CDocument document;
    document.open(presetPath("black_tupelo"));
    document.setValue(paramRef("Scale"), 11, 0);
    const CParams before = document.params();
    EXPECT_THROW(document.open(bad), CInputError);
    EXPECT_THROW(document.open(folder.filePath(QStringLiteral("missing.tree"))), CError);
    EXPECT_EQ(document.params(), before);
    EXPECT_EQ(document.path(), presetPath("black_tupelo"));
    EXPECT_EQ(document.history().count(), 1);
}

TEST(Document, SavingMakesItCleanAndReadsBack) {
    QTemporaryDir folder;
    CDocument document;
    document.open(presetPath("quaking_aspen"));
    document.setValue(paramRef("1DownAngle"), 33, 0);
    EXPECT_TRUE(document.isModified());
    const QString path = folder.filePath(QStringLiteral("a.tree"));
    document.save(path);
    EXPECT_FALSE(document.isModified());
    EXPECT_EQ(document.path(), path);
    EXPECT_EQ(CTreeFile::read(path.toStdString()).params(), document.params());
    document.history().undo();
    EXPECT_TRUE(document.isModified());
}

TEST(Document, TexturePathsFollowTheFile) {
    QTemporaryDir folder;
    QDir(folder.path()).mkpath(QStringLiteral("trees/deep"));
    CDocument document;
    document.save(folder.filePath(QStringLiteral("trees/a.tree")));
    document.setValue(*findParam("BarkTexture"), std::string("oak.png"), 0);
    document.save(folder.filePath(QStringLiteral("trees/deep/b.tree")));
    EXPECT_EQ(document.params().text.barkTexture, "../oak.png");
    EXPECT_EQ(document.params().text.leafTexture, "");
}

TEST(Document, AFailedSaveKeepsFileAndChanges) {
    QTemporaryDir folder;
    CDocument document;
    document.setValue(paramRef("Scale"), 20, 0);
    EXPECT_THROW(document.save(folder.filePath(QStringLiteral("no/such/a.tree"))), CError);
    EXPECT_THROW(document.save(folder.path()), CError);
    EXPECT_TRUE(document.path().isEmpty());
    EXPECT_TRUE(document.isModified());
}

TEST(Document, SavingAPresetOverTheOldFileIsNotUndone) {
    QTemporaryDir folder;
    const QString mine = folder.filePath(QStringLiteral("mine.tree"));
    ASSERT_TRUE(QFile::copy(presetPath("quaking_aspen"), mine));
    CDocument document;
    document.open(mine);
    document.loadPreset(presetPath("black_tupelo"));
    EXPECT_TRUE(document.path().isEmpty());
    document.save(mine);
    EXPECT_FALSE(document.isModified());
    document.history().undo();
    EXPECT_EQ(valueOf(document, "Scale"), 13);
    EXPECT_TRUE(document.isModified()) << "the file holds the tupelo now";
    document.history().redo();
    EXPECT_EQ(document.path(), mine) << "what was saved keeps its file";
    EXPECT_FALSE(document.isModified());
}

TEST(Document, UndoAfterSavingElsewhereKeepsThePictures) {
    QTemporaryDir folder;
    QDir(folder.path()).mkdir(QStringLiteral("sub"));
    const QString first = folder.filePath(QStringLiteral("a.tree"));
    CDocument document;
    document.save(first);
    const ParamRef bark = *findParam("BarkTexture");
    document.setValue(bark, std::string("bark.png"), 0);
    document.setValue(*findParam("LeafMesh"), std::string("leaf.obj"), 0);
    document.setValue(*findParam("2BarkTexture"), std::string("bark:birch"), 0);
    document.setValue(paramRef("Scale"), 12, 0);
    EXPECT_EQ(document.params().folder, folder.path().toStdString());
    document.save(folder.filePath(QStringLiteral("sub/b.tree")));
    EXPECT_EQ(document.params().text.barkTexture, "../bark.png");
    EXPECT_EQ(document.params().text.leafMesh, "../leaf.obj");
    EXPECT_EQ(document.params().text.bark2Texture, "bark:birch") << "no path";
    document.history().undo();
    EXPECT_EQ(document.params().text.barkTexture, "../bark.png") << "the same picture as before";
    EXPECT_EQ(document.params().text.leafMesh, "../leaf.obj");
    EXPECT_EQ(document.params().folder, folder.filePath(QStringLiteral("sub")).toStdString()) << "where its paths start";
    EXPECT_EQ(valueOf(document, "Scale"), 10);
}

TEST(Document, ABuiltInMeshIsNoPath) {
    QTemporaryDir folder;
    CDocument document;
    document.setValue(*findParam("LeafMesh"), std::string("mesh:curved"), 0);
    document.save(folder.filePath(QStringLiteral("a.tree")));
    document.save(folder.filePath(QStringLiteral("../b.tree")));
    EXPECT_EQ(document.params().text.leafMesh, "mesh:curved");
    QFile::remove(folder.filePath(QStringLiteral("../b.tree")));
}

TEST(Document, AnUnnamedTreeWithARelativePictureCanBeSaved) {
    QTemporaryDir folder;
    CDocument document;
    document.setValue(*findParam("BarkTexture"), std::string("bark.png"), 0);
    document.save(folder.filePath(QStringLiteral("a.tree")));
    EXPECT_EQ(document.params().text.barkTexture, "bark.png");
}

TEST(Document, WhatACrashLeftIsRestoredEvenWhenItsFileIsGone) {
    CParams kept;
    weberPenn(kept).scale = 17;
    kept.text.barkTexture = "bark.png";
    CDocument document;
    document.restore(QStringLiteral("/no/such/folder/lost.tree"), kept);
    EXPECT_EQ(valueOf(document, "Scale"), 17);
    EXPECT_EQ(document.params().text.barkTexture, "/no/such/folder/bark.png");
    EXPECT_TRUE(document.path().isEmpty());
    EXPECT_TRUE(document.isModified());
}

TEST(Document, ATreeOfAnotherProgramIsNewAndTellsWhatChanged) {
    QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("small_birch.py")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("params = {'g_scale': 17, 'levels': 2,\n 'gadget': 1}");
    file.close();
    CDocument document;
    document.import(file.fileName());
    EXPECT_EQ(valueOf(document, "Scale"), 17);
    EXPECT_TRUE(document.path().isEmpty()) << "saving asks for a name";
    EXPECT_EQ(document.displayName(), QStringLiteral("small_birch.tree"));
    EXPECT_TRUE(document.isModified());
    ASSERT_EQ(document.warnings().size(), 1u);
    EXPECT_EQ(document.warnings()[0].line, 2);
}

} // namespace
} // namespace stromar
