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
    static constexpr int kFormat = 2; ///< rises when an older reader would misread a file

    /// A new document with the defaults of a method.
    explicit CTreeFile(const ParamBlock& block = weberPennBlock()) : m_params(block) {}

    /// Throws CInputError with every error found (file, line, column), CError when the file cannot be read.
    static CTreeFile read(const std::filesystem::path& path);
    /// `name` stands in messages for the file.
    static CTreeFile parse(const std::string& text, const std::string& name);

    const CParams& params() const { return m_params; }
    const Messages& warnings() const { return m_warnings; }
    /// What its lines say, in their order: of lines that were copied, say.
    ParamValues givenValues() const;
    /// Values as lines of a file of their method.
    static std::string lines(const CParams& params, const std::vector<ParamRef>& refs);
    /// What others find wrong with a value, at its place in the file; `at` bytes into a text.
    Message errorAt(const ParamRef& ref, std::string text, std::size_t at = 0) const;

    /// The file's text with the values of `params`: only lines whose value differs from what was read change, values
    /// without a line are added at the end of their group. Without lines, or for another method: all values, group by group.
    std::string text(const CParams& params) const;
    /// Writes text(params), atomically, and returns the file as it is then. Throws CError.
    CTreeFile write(const std::filesystem::path& path, const CParams& params) const;

private:
    /// A line, or a key with all lines of its text.
    struct Line {
        std::string raw; ///< with its line endings
        int number;      ///< of the first, counted from 1
        std::string key; ///< empty: a comment or blank
        std::size_t valueBegin = 0, valueEnd = 0;
        bool block = false; ///< the value is lines between """

        std::string value() const;
        /// Where a byte of the value stands.
        std::pair<int, int> placeOf(std::size_t at) const;
    };
    class CParser;

    std::string changedLine(const Line& line, const CParams& params) const;
    std::string lineEnd() const;

    std::string m_name; ///< of the file, in messages
    std::vector<Line> m_lines;
    CParams m_params;
    Messages m_warnings;
};

} // namespace stromar
