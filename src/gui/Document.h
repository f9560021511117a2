#pragma once
#include "stromar/params/TreeFile.h"
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>

namespace stromar {

/// The tree that is being edited: its values, its file and its history. The only place where values change.
class CDocument : public QObject {
    Q_OBJECT
public:
    explicit CDocument(QObject* parent = nullptr);

    const CParams& params() const { return m_params; }
    /// Empty for a new document.
    const QString& path() const { return m_path; }
    /// The folder that texture paths start at.
    std::filesystem::path folder() const;
    QString displayName() const;
    const Messages& warnings() const { return m_file.warnings(); }
    QUndoStack& history() { return m_history; }

    void startNew();
    /// Throws CError; then nothing has changed.
    void open(const QString& path);
    /// Throws CError; then the old file is as it was. Texture paths follow the file to another folder.
    void save(const QString& path);

    /// Changes values through `change`; one step of the history. Changes with the same positive `gesture` on the same
    /// `subject` are one step.
    void edit(const QString& text, const std::function<void(CParams&)>& change, int gesture = 0,
              const QString& subject = {});
    void setValue(const ParamRef& ref, double value, int gesture);
    void setText(const TextInfo& text, const QString& value);

signals:
    void changed();  ///< the values
    void replaced(); ///< another document: new or opened
    void nameChanged();

private:
    friend class CEditCommand;
    void assign(const CParams& params);
    void replace(CTreeFile file, const QString& path);

    CTreeFile m_file;
    CParams m_params;
    QString m_path;
    QUndoStack m_history;
};

/// A path of a tree in `from` as seen from the folder `to`.
std::string rebasedPath(const std::string& path, const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace stromar
