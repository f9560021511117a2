#pragma once
#include "stromar/params/ParamText.h"
#include "stromar/util/Error.h"
#include <filesystem>
#include <string>
#include <vector>

namespace stromar {

/// A `.tree` file: the values it gave and its lines, so that saving keeps comments, order and unknown lines.
class CTreeFile {
public:
    static constexpr int kFormat = 1; ///< rises when an older reader would misread a file

    /// A new document with the table's defaults.
    CTreeFile() = default;

    /// Throws CInputError with every error found (file, line, column), CError when the file cannot be read.
    static CTreeFile read(const std::filesystem::path& path);
    /// `name` stands in messages for the file.
    static CTreeFile parse(const std::string& text, const std::string& name);

    const CParams& params() const { return m_params; }
    const Messages& warnings() const { return m_warnings; }
    /// What others find wrong with a value, at its place in the file.
    Message errorAt(const ParamTarget& target, std::string text) const;

    /// The file's text with the values of `params`: only lines whose value differs from what was read change, values
    /// without a line are added at the end of their group. Without lines: all values, group by group.
    std::string text(const CParams& params) const;
    /// Writes text(params), atomically, and returns the file as it is then. Throws CError.
    CTreeFile write(const std::filesystem::path& path, const CParams& params) const;

private:
    struct Line {
        std::string raw; ///< with its line ending
        std::string key; ///< empty: a comment or blank
        std::size_t valueBegin = 0, valueEnd = 0;
    };
    class CParser;

    std::string changedLine(const Line& line, const CParams& params) const;

    std::string m_name; ///< of the file, in messages
    std::vector<Line> m_lines;
    CParams m_params;
    Messages m_warnings;
};

} // namespace stromar
