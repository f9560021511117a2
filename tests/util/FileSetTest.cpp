#include "stromar/util/FileSet.h"
#include "util/TemporaryFolder.h"
#include <atomic>
#include <csignal>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <thread>

namespace stromar {
namespace {

namespace fs = std::filesystem;
using test::CTemporaryFolder;
using Names = std::set<std::string>;

TEST(FileSet, FilesAppearAtCommit) {
    const CTemporaryFolder folder;
    CFileSet files;
    files.create(folder / "a") << "alpha";
    files.create(folder / "b") << "beta";
    EXPECT_FALSE(fs::exists(folder / "a"));
    EXPECT_FALSE(fs::exists(folder / "b"));
    files.commit();
    EXPECT_EQ(readFile(folder / "a"), "alpha");
    EXPECT_EQ(readFile(folder / "b"), "beta");
    EXPECT_EQ(folder.names(), (Names{"a", "b"}));
}

TEST(FileSet, WithoutCommitNothingChanges) {
    const CTemporaryFolder folder;
    writeFile(folder / "old", "old content");
    {
        CFileSet files;
        files.create(folder / "old") << std::string(1 << 20, 'x') << std::flush;
        files.create(folder / "new") << "y";
        EXPECT_EQ(readFile(folder / "old"), "old content");
    }
    EXPECT_EQ(readFile(folder / "old"), "old content");
    EXPECT_EQ(folder.names(), Names{"old"});
}

TEST(FileSet, AFailureInALaterFileLeavesTheEarlierAlone) {
    const CTemporaryFolder folder;
    writeFile(folder / "first", "old content");
    {
        CFileSet files;
        files.create(folder / "first") << "new content";
        EXPECT_THROW(files.create(folder / "nowhere/second"), CError);
    }
    EXPECT_EQ(readFile(folder / "first"), "old content");
    EXPECT_EQ(folder.names(), Names{"first"});
}

TEST(FileSet, CommitOntoAFolderFailsAndLeavesAll) {
    const CTemporaryFolder folder;
    fs::create_directory(folder / "taken");
    writeFile(folder / "first", "old content");
    {
        CFileSet files;
        files.create(folder / "first") << "new content";
        files.create(folder / "third") << "new content";
        EXPECT_THROW(
            {
                files.create(folder / "taken") << "text";
                files.commit();
            },
            CError);
    }
    EXPECT_EQ(readFile(folder / "first"), "old content");
    EXPECT_EQ(folder.names(), (Names{"first", "taken"}));
    EXPECT_TRUE(fs::is_empty(folder / "taken"));
}

TEST(FileSet, ErrorsNameTheFile) {
    const CTemporaryFolder folder;
    CFileSet files;
    try {
        files.create(folder / "nowhere/oak.tree");
        FAIL() << "written into a folder that does not exist";
    } catch (const CError& error) {
        EXPECT_NE(std::string(error.what()).find("oak.tree"), std::string::npos) << error.what();
    }
}

/// Lets files grow to so many bytes only: a disk that runs full.
class CFullDisk {
public:
    explicit CFullDisk(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &m_old);
        const rlimit limit{bytes, m_old.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~CFullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &m_old);
        std::signal(SIGXFSZ, m_handler);
    }

private:
    rlimit m_old{};
    void (*m_handler)(int);
};

TEST(FileSet, AFullDiskLeavesTheOldFile) {
    for (const std::size_t size : {std::size_t{2000}, std::size_t{300000}}) { // inside and beyond the buffer
        const CTemporaryFolder folder;
        writeFile(folder / "first", "old first");
        writeFile(folder / "second", "old second");
        {
            const CFullDisk disk(1000);
            CFileSet files;
            EXPECT_THROW(
                {
                    files.create(folder / "first") << "fits";
                    files.create(folder / "second") << std::string(size, 'x');
                    files.commit();
                },
                CError);
        }
        EXPECT_EQ(readFile(folder / "first"), "old first");
        EXPECT_EQ(readFile(folder / "second"), "old second");
        EXPECT_EQ(folder.names(), (Names{"first", "second"}));
    }
}

TEST(FileSet, CancelLeavesAll) {
    const CTemporaryFolder folder;
    writeFile(folder / "old", "old content");
    {
        const CProgress progress(1);
        CFileSet files(progress);
        std::ostream& out = files.create(folder / "old");
        out << "begun";
        progress.cancel();
        EXPECT_THROW(out << std::string(1 << 20, 'x'), CCancelled);
    }
    {
        const CProgress progress(1);
        CFileSet files(progress);
        files.create(folder / "old") << "all written";
        progress.cancel();
        EXPECT_THROW(files.commit(), CCancelled);
    }
    EXPECT_EQ(readFile(folder / "old"), "old content");
    EXPECT_EQ(folder.names(), Names{"old"});
}

TEST(FileSet, ReportsHowFarItIs) {
    const CTemporaryFolder folder;
    const CProgress progress(1);
    CFileSet files(progress, 1 << 20);
    std::ostream& out = files.create(folder / "a");
    out << std::string(1 << 19, 'x') << std::flush;
    EXPECT_NEAR(progress.done(), 0.5, 0.01);
    EXPECT_EQ(files.bytes(), std::uint64_t{1} << 19);
    out << std::string(1 << 20, 'x') << std::flush;
    EXPECT_EQ(progress.done(), 1);
}

TEST(FileSet, GoesBackToFillInALength) {
    const CTemporaryFolder folder;
    const std::string body(200000, 'b'); // longer than any buffer
    CFileSet files;
    std::ostream& out = files.create(folder / "chunks");
    out << "size";
    const auto place = out.tellp();
    out << "????" << body;
    const auto end = out.tellp();
    out.seekp(place) << "1234";
    EXPECT_EQ(out.tellp(), std::streampos(8));
    out.seekp(end) << "tail";
    files.commit();
    EXPECT_EQ(place, std::streampos(4));
    EXPECT_TRUE(readFile(folder / "chunks") == "size1234" + body + "tail");
}

TEST(FileSet, TheEndCountsWhatIsNotYetOnTheDisk) {
    const CTemporaryFolder folder;
    CFileSet files;
    std::ostream& out = files.create(folder / "text");
    out << "tail";
    out.seekp(-2, std::ios::end) << "I";
    out.seekp(0, std::ios::end) << "!";
    files.commit();
    EXPECT_EQ(readFile(folder / "text"), "taIl!");
}

TEST(FileSet, BytesGoThroughUnchanged) {
    const CTemporaryFolder folder;
    std::string all;
    for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
    CFileSet files;
    std::ostream& out = files.create(folder / "bytes");
    for (const char c : all) out.put(c);
    out.write(all.data(), static_cast<std::streamsize>(all.size()));
    files.commit();
    EXPECT_EQ(readFile(folder / "bytes"), all + all);
}

TEST(FileSet, WritesThroughASymbolicLink) {
    const CTemporaryFolder folder;
    fs::create_directory(folder / "real");
    writeFile(folder / "real/oak.tree", "old");
    fs::create_symlink("real/oak.tree", folder / "link");
    writeFile(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(readFile(folder / "real/oak.tree"), "new");
    EXPECT_EQ(folder.names(), (Names{"link", "real"}));
}

TEST(FileSet, WritesThroughALinkWhoseTargetIsNotYetThere) {
    const CTemporaryFolder folder;
    fs::create_directory(folder / "real");
    fs::create_symlink("real/oak.tree", folder / "link");
    writeFile(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link")) << "the link was replaced by a file";
    EXPECT_TRUE(fs::exists(folder / "real/oak.tree"));
}

TEST(FileSet, KeepsThePermissionsOfWhatItReplaces) {
    const CTemporaryFolder folder;
    writeFile(folder / "private", "old");
    fs::permissions(folder / "private", fs::perms::owner_read | fs::perms::owner_write);
    writeFile(folder / "private", "new");
    EXPECT_EQ(fs::status(folder / "private").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(FileSet, ThreadsThatWriteTheSameFileDoNotMeet) {
    const CTemporaryFolder folder;
    const fs::path path = folder / "same";
    std::atomic<int> broken = 0;
    const auto write = [&](char letter) {
        for (int i = 0; i < 20; ++i) {
            writeFile(path, std::string(300'000, letter));
            const std::string read = readFile(path);
            if (read.size() != 300'000 || read.find_first_not_of(read.front()) != std::string::npos) ++broken;
        }
    };
    std::jthread one(write, 'a'), other(write, 'b');
    one.join();
    other.join();
    EXPECT_EQ(broken, 0);
    EXPECT_EQ(folder.names(), (std::set<std::string>{"same"}));
}

TEST(FileSet, CopiesFiles) {
    const CTemporaryFolder folder;
    writeFile(folder / "bark.png", std::string("\x89PNG\0\r\n", 7));
    CFileSet files;
    files.copy(folder / "bark.png", folder / "copy.png");
    files.copy(folder / "bark.png", folder / "bark.png"); // onto itself: nothing to do
    EXPECT_FALSE(fs::exists(folder / "copy.png"));
    files.commit();
    EXPECT_EQ(readFile(folder / "copy.png"), std::string("\x89PNG\0\r\n", 7));
    EXPECT_EQ(readFile(folder / "bark.png"), std::string("\x89PNG\0\r\n", 7));
    EXPECT_THROW(files.copy(folder / "missing", folder / "x"), CError);
    EXPECT_EQ(folder.names(), (Names{"bark.png", "copy.png"}));
}

TEST(FileSet, ReadingRefusesFoldersAndMissingFiles) {
    const CTemporaryFolder folder;
    EXPECT_THROW(readFile(folder.path()), CError);
    EXPECT_THROW(readFile(folder / "missing"), CError);
    EXPECT_THROW(writeFile(folder.path(), "x"), CError);
}

} // namespace
} // namespace stromar
