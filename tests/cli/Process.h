#pragma once
#include "util/TemporaryFolder.h"
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace stromar::test {

struct ProcessSettings {
    std::string folder{};     ///< to start in; empty: this one
    std::string output{};     ///< where standard output goes instead of into the result
    rlim_t maxFileBytes = 0; ///< like a disk that is full after so many bytes; 0: no limit
};

struct ProcessResult {
    int status = -1; ///< exit status; negative: ended by that signal
    std::string out, err;
};

/// A program that runs beside the test.
class CProcess {
public:
    explicit CProcess(std::vector<std::string> command, const ProcessSettings& settings = {}) {
        const std::string out = settings.output.empty() ? (m_folder / "out").string() : settings.output;
        const std::string err = (m_folder / "err").string();
        std::vector<char*> arguments;
        for (std::string& word : command) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        m_id = ::fork();
        if (m_id == 0) runChild(arguments, settings, out, err);
        if (m_id < 0) throw std::runtime_error("cannot start " + command.front());
    }
    ~CProcess() {
        if (m_id > 0) wait();
    }
    CProcess(const CProcess&) = delete;
    CProcess& operator=(const CProcess&) = delete;

    void signal(int number) const { ::kill(m_id, number); }
    ProcessResult wait() {
        int status = 0;
        while (::waitpid(m_id, &status, 0) < 0 && errno == EINTR) {
        }
        m_id = 0;
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), content("out"), content("err")};
    }

private:
    /// Only calls that are safe between fork and exec.
    [[noreturn]] static void runChild(const std::vector<char*>& arguments, const ProcessSettings& settings,
                                      const std::string& out, const std::string& err) {
        const int outFile = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        const int errFile = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        ::dup2(outFile, STDOUT_FILENO);
        ::dup2(errFile, STDERR_FILENO);
        if (settings.maxFileBytes > 0) {
            const rlimit limit{settings.maxFileBytes, settings.maxFileBytes};
            ::signal(SIGXFSZ, SIG_IGN);
            ::setrlimit(RLIMIT_FSIZE, &limit);
        }
        if (settings.folder.empty() || ::chdir(settings.folder.c_str()) == 0)
            ::execvp(arguments.front(), arguments.data());
        ::_exit(127);
    }
    std::string content(const char* name) const {
        std::ifstream in(m_folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    CTemporaryFolder m_folder;
    pid_t m_id = 0;
};

inline ProcessResult runProcess(std::vector<std::string> command, const ProcessSettings& settings = {}) {
    return CProcess(std::move(command), settings).wait();
}

} // namespace stromar::test
