#include "Document.h"
#include "QtText.h"
#include <QFileInfo>
#include <QUndoCommand>

namespace stromar {

namespace fs = std::filesystem;

/// A step of the history: the values before and after.
class CEditCommand : public QUndoCommand {
public:
    CEditCommand(CDocument& document, const QString& text, CParams after, int gesture, QString subject)
        : QUndoCommand(text), m_document(document), m_before(document.params()), m_after(std::move(after)),
          m_gesture(gesture), m_subject(std::move(subject)) {}

    void undo() override { m_document.assign(m_before); }
    void redo() override { m_document.assign(m_after); }
    int id() const override { return m_gesture > 0 ? 1 : -1; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* other = static_cast<const CEditCommand*>(next);
        if (other->m_gesture != m_gesture || other->m_subject != m_subject) return false;
        m_after = other->m_after;
        setObsolete(m_after == m_before);
        return true;
    }

private:
    CDocument& m_document;
    CParams m_before, m_after;
    int m_gesture;
    QString m_subject;
};

/// The step to another file's tree and back.
class CPresetCommand : public QUndoCommand {
public:
    CPresetCommand(CDocument& document, const QString& text, CDocument::Origin after)
        : QUndoCommand(text), m_document(document), m_before(document.origin()), m_after(std::move(after)),
          m_params(document.params()) {}

    void undo() override { m_document.assign(m_before, m_params); }
    void redo() override { m_document.assign(m_after, m_after.file->params()); }

private:
    CDocument& m_document;
    CDocument::Origin m_before, m_after;
    CParams m_params;
};

std::string rebasedPath(const std::string& path, const fs::path& from, const fs::path& to) {
    if (path.empty() || fs::path(path).is_absolute()) return path;
    std::error_code problem;
    const fs::path whole = fs::weakly_canonical(fs::absolute(from) / path, problem);
    const fs::path relative = fs::relative(whole, fs::absolute(to), problem);
    return (problem || relative.empty() ? whole : relative).generic_string();
}

CDocument::CDocument(QObject* parent) : QObject(parent), m_file(std::make_shared<CTreeFile>()) {}

fs::path CDocument::folder() const { return m_path.isEmpty() ? fs::path() : toPath(m_path).parent_path(); }

QString CDocument::displayName() const {
    if (!m_path.isEmpty()) return QFileInfo(m_path).fileName();
    return m_name.isEmpty() ? tr("new.tree") : m_name;
}

void CDocument::startNew() { replace({std::make_shared<CTreeFile>(), {}, {}}); }

void CDocument::open(const QString& path) {
    replace({std::make_shared<CTreeFile>(CTreeFile::read(toPath(path))), QFileInfo(path).absoluteFilePath(), {}});
}

void CDocument::replace(Origin origin) {
    m_history.clear();
    m_file = std::move(origin.file);
    m_path = std::move(origin.path);
    m_name = std::move(origin.name);
    m_params = m_file->params();
    emit nameChanged();
    emit replaced();
}

void CDocument::loadPreset(const QString& path) {
    auto file = std::make_shared<CTreeFile>(CTreeFile::read(toPath(path)));
    // Without a folder of its own the document needs whole paths to the textures.
    CParams params = file->params();
    for (const TextInfo& text : textTable())
        if (std::string& picture = params.text.*text.field; text.path && !picture.empty())
            picture = fromPath(fs::absolute(toPath(path)).parent_path() / picture).toStdString();
    if (params != file->params())
        file = std::make_shared<CTreeFile>(CTreeFile::parse(file->text(params), path.toStdString()));
    m_history.push(new CPresetCommand(*this, tr("Open preset %1").arg(QFileInfo(path).completeBaseName()),
                                      {std::move(file), {}, QFileInfo(path).fileName()}));
}

void CDocument::restore(const QString& path, const CParams& params) {
    if (QFileInfo(path).isAbsolute() && QFileInfo::exists(path))
        open(path);
    else
        replace({std::make_shared<CTreeFile>(), {}, QFileInfo(path).fileName()});
    edit(tr("Restore"), [&](CParams& p) { p = params; });
}

/// The values with the paths of the pictures as seen from another file.
CParams CDocument::paramsFor(const QString& target) const {
    CParams params = m_params;
    for (const TextInfo& text : textTable())
        if (text.path)
            params.text.*text.field = rebasedPath(m_params.text.*text.field, folder(), toPath(target).parent_path());
    return params;
}

void CDocument::save(const QString& path) {
    const QString target = QFileInfo(path).absoluteFilePath();
    m_file = std::make_shared<CTreeFile>(m_file->write(toPath(target), paramsFor(target)));
    m_params = m_file->params();
    m_path = target;
    emit nameChanged();
}

void CDocument::saveCopy(const QString& path, const QString& species) const {
    CParams params = paramsFor(path);
    params.text.species = species.toStdString();
    static_cast<void>(m_file->write(toPath(path), params));
}

void CDocument::edit(const QString& text, const std::function<void(CParams&)>& change, int gesture,
                     const QString& subject) {
    CParams after = m_params;
    change(after);
    if (after != m_params) m_history.push(new CEditCommand(*this, text, std::move(after), gesture, subject));
}

void CDocument::setValue(const ParamRef& ref, double value, int gesture) {
    const QString key = toQString(ref.key());
    edit(
        tr("Change %1").arg(key), [&](CParams& p) { ref.set(p, value); }, gesture, key);
}

void CDocument::setValues(const QString& text, const std::vector<std::pair<ParamRef, double>>& values) {
    edit(text, [&](CParams& p) {
        for (const auto& [ref, value] : values) ref.set(p, value);
    });
}

void CDocument::setText(const TextInfo& text, const QString& value) {
    std::string problem;
    edit(tr("Change %1").arg(toQString(text.key)),
         [&](CParams& p) { setFromText(p, ParamTarget(&text), value.toStdString(), problem); });
}

void CDocument::assign(const CParams& params) {
    m_params = params;
    emit changed();
    emit nameChanged();
}

void CDocument::assign(const Origin& origin, const CParams& params) {
    m_file = origin.file;
    m_path = origin.path;
    m_name = origin.name;
    m_params = params;
    emit nameChanged();
    emit replaced();
}

} // namespace stromar
