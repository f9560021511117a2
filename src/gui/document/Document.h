#pragma once
#include "document/Autosave.h"
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
    const QString& path() const { return m_place->path; }
    /// The folder that texture paths start at.
    std::filesystem::path folder() const;
    QString displayName() const;
    const Messages& warnings() const { return m_place->notes.empty() ? m_place->file->warnings() : m_place->notes; }
    /// The values as they are in the file; of a new document the defaults.
    const CParams& savedParams() const { return m_place->file->params(); }
    bool isModified() const { return m_params != savedParams() || m_place->diverged; }
    /// The file has other values now, by another program, and these are to stay: they count as changes.
    void keepAgainstFile();
    QUndoStack& history() { return m_history; }
    /// What a crash must not take.
    CAutosave::State kept() const { return {m_place->file, m_params, path().isEmpty() ? m_place->name : path()}; }

    void startNew(const ParamBlock& block = weberPennBlock());
    /// Throws CError; then nothing has changed.
    void open(const QString& path);
    /// Throws CError; then the old file is as it was. Texture paths follow the file to another folder.
    void save(const QString& path);

    /// Writes the tree under another species name; the document stays what it is. Throws CError.
    void saveCopy(const QString& path, const QString& species) const;

    /// The document before the one that was opened or started last, as it was; without its history. False when there is none.
    bool canGoBack() const { return m_previous != nullptr; }
    void goBack();

    /// What a step is called, by the values before and after it.
    using StepText = std::function<QString(const CParams& before, const CParams& after)>;

    /// Changes values through `change`; one step of the history. Changes with the same positive `gesture` on the same
    /// `subject` are one step.
    void edit(const QString& text, const std::function<void(CParams&)>& change, int gesture = 0,
              const QString& subject = {});
    void setValue(const ParamRef& ref, const ParamValue& value, int gesture);
    void setValue(const ParamRef& ref, double value, int gesture) { setValue(ref, ParamValue(value), gesture); }
    /// Several values as one step; `text` names it.
    void setValues(const QString& text, const ParamValues& values);
    /// The tree of a preset as a new, unnamed document; one step of the history, so that nothing is lost. Throws
    /// CError. Nothing happens where it is just the document already.
    void loadPreset(const QString& path);
    /// The same without a way back: for a program that starts.
    void startWith(const QString& path);
    /// What a crash left: values on top of the file at `path` (empty: of a new document). They count as changes.
    void restore(const QString& path, const CParams& params);
    /// A tree of another program, which is no file yet; what was lost on the way is told as warnings. Throws CError.
    void import(const QString& path);

signals:
    void changed();  ///< the values
    void replaced(); ///< another document: new or opened
    void nameChanged();

private:
    friend class CEditCommand;
    friend class CPresetCommand;
    void push(const StepText& text, const std::function<void(CParams&)>& change, int gesture, const QString& subject);
    /// Where a tree comes from and is saved to. Steps of the history share it, so that saving is not undone.
    struct Place {
        std::shared_ptr<const CTreeFile> file;
        QString path, name;    ///< the name is shown while there is no path
        bool diverged = false; ///< the file on the disk is another one
        Messages notes{};      ///< in place of the file's, of a tree of another program
        std::filesystem::path folder() const;
    };
    using PlacePtr = std::shared_ptr<Place>;

    /// Paths of pictures in `params` start at `folder`.
    void setParams(CParams params);
    void assign(const CParams& params, const std::filesystem::path& folder);
    void assign(const PlacePtr& place, const CParams& params, const std::filesystem::path& folder);
    PlacePtr newPlace(CTreeFile file, const QString& path, const QString& name);
    void replace(const PlacePtr& place);
    CParams paramsFor(const QString& target) const;

    std::vector<std::weak_ptr<Place>> m_places; ///< all that the history may come back to
    PlacePtr m_place, m_previous;
    CParams m_params, m_previousParams;
    QUndoStack m_history;
};

/// A path of a tree in `from` as seen from the folder `to`.
std::string rebasedPath(const std::string& path, const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace stromar
