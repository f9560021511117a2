#pragma once
#include "Autosave.h"
#include "stromar/params/TreeFile.h"
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <memory>
#include <vector>

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
    const Messages& warnings() const { return m_file->warnings(); }
    /// The values as they are in the file; of a new document the defaults.
    const CParams& savedParams() const { return m_file->params(); }
    bool isModified() const { return m_params != savedParams(); }
    QUndoStack& history() { return m_history; }
    /// What a crash must not take.
    CAutosave::State kept() const { return {m_file, m_params, m_path.isEmpty() ? m_name : m_path}; }

    void startNew();
    /// Throws CError; then nothing has changed.
    void open(const QString& path);
    /// Throws CError; then the old file is as it was. Texture paths follow the file to another folder.
    void save(const QString& path);

    /// Writes the tree under another species name; the document stays what it is. Throws CError.
    void saveCopy(const QString& path, const QString& species) const;

    /// Changes values through `change`; one step of the history. Changes with the same positive `gesture` on the same
    /// `subject` are one step.
    void edit(const QString& text, const std::function<void(CParams&)>& change, int gesture = 0,
              const QString& subject = {});
    void setValue(const ParamRef& ref, double value, int gesture);
    /// Several values as one step; `text` names it.
    void setValues(const QString& text, const std::vector<std::pair<ParamRef, double>>& values);
    void setText(const TextInfo& text, const QString& value);
    /// The tree of a preset as a new, unnamed document; one step of the history, so that nothing is lost. Throws
    /// CError.
    void loadPreset(const QString& path);
    /// What a crash left: values on top of the file at `path` (empty: of a new document). They count as changes.
    void restore(const QString& path, const CParams& params);

signals:
    void changed();  ///< the values
    void replaced(); ///< another document: new or opened
    void nameChanged();

private:
    friend class CEditCommand;
    friend class CPresetCommand;
    /// What a step of the history can bring back beside the values.
    struct Origin {
        std::shared_ptr<const CTreeFile> file;
        QString path, name; ///< the name is shown while there is no path
    };
    void assign(const CParams& params);
    void assign(const Origin& origin, const CParams& params);
    void replace(Origin origin);
    CParams paramsFor(const QString& target) const;
    Origin origin() const { return {m_file, m_path, m_name}; }

    std::shared_ptr<const CTreeFile> m_file;
    CParams m_params;
    QString m_path, m_name;
    QUndoStack m_history;
};

/// A path of a tree in `from` as seen from the folder `to`.
std::string rebasedPath(const std::string& path, const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace stromar
