#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace stromar {

enum class Severity { Warning, Error };

/// Something to tell the user about a place in a file. Line and column count from 1; 0 = the file as a whole.
struct Message {
    Severity severity = Severity::Warning;
    std::string file;
    int line = 0;
    int column = 0;
    std::string text;

    /// "oak.tree:12:9: warning: …"
    std::string toString() const;
    bool operator==(const Message&) const = default;
};
using Messages = std::vector<Message>;

/// The world refused: a full disk, a vanished file, no OpenGL. what() is fit for the user.
class CError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// An input file is wrong. what() holds all messages, one a line.
class CInputError : public CError {
public:
    explicit CInputError(Messages messages);
    const Messages& messages() const { return m_messages; }

private:
    Messages m_messages;
};

/// Someone asked to stop; nothing is wrong.
class CCancelled : public std::runtime_error {
public:
    CCancelled() : std::runtime_error("cancelled") {}
};

} // namespace stromar
