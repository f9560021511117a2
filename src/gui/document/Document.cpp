#include "document/Document.h"
#include "window/QtText.h"
#include "window/Settings.h"
#include "stromar/app/Import.h"
#include "stromar/params/BuiltInMesh.h"
#include "stromar/texture/Draw.h"
#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <iterator>

namespace stromar {

namespace fs = std::filesystem;

namespace {
/// Not built in.
bool isPath(const std::string& text) { return !text.empty() && !isRecipe(text) && !isBuiltInMesh(text); }

/// The values that name files.
std::vector<ParamRef> filesIn(const CParams& params) {
    std::vector<ParamRef> refs;
    std::ranges::copy_if(allParams(params.block()), std::back_inserter(refs), [](const ParamRef& ref) { return ref.info->file(); });
    return refs;
}

CParams rebased(CParams params, const fs::path& from, const fs::path& to) {
    if (from == to) return params;
    for (const ParamRef& ref : filesIn(params)) ref.setValue(params, rebasedPath(ref.text(params), from, to));
    return params;
}

/// Files by their whole paths, for a document without a folder.
CParams withWholePaths(CParams params, const fs::path& folder) {
    for (const ParamRef& ref : filesIn(params))
        if (const std::string path = ref.text(params); isPath(path) && !folder.empty())
            ref.setValue(params, (folder / path).lexically_normal().generic_string());
    return params;
}
} // namespace

/// Of a step that changes one value: "Branches 1 ▸ Number: 50 → 90".
QString stepText(const ParamRef& ref, const CParams& before, const CParams& after) {
    const QString name = QStringLiteral("%1 ▸ %2").arg(groupTitle(ref.group(), ref.level), trText(ref.info->label));
    const auto caption = [&](const CParams& params) { // a number stays with its unit where the line breaks
        return captionOf(*ref.info, ref.get(params)).replace(QLatin1Char(' '), QChar(QChar::Nbsp));
    };
    return ref.info->numeric() ? QStringLiteral("%1: %2 → %3").arg(name, caption(before), caption(after)) : name;
}

/// A step of the history: the values before and after, and the folder that paths in them start at.
class CEditCommand : public QUndoCommand {
public:
    CEditCommand(CDocument& document, const CDocument::StepText& text, CParams after, int gesture, QString subject)
        : m_document(document), m_before(document.params()), m_after(std::move(after)), m_folder(document.folder()), m_gesture(gesture),
          m_subject(std::move(subject)), m_text(text) {
        setText(m_text(m_before, m_after));
    }

    void undo() override { m_document.assign(m_before, m_folder); }
    void redo() override { m_document.assign(m_after, m_folder); }
    int id() const override { return m_gesture > 0 ? 1 : -1; }
    bool mergeWith(const QUndoCommand* next) override {
        const auto* other = static_cast<const CEditCommand*>(next);
        if (other->m_gesture != m_gesture || other->m_subject != m_subject || other->m_folder != m_folder) return false;
        m_after = other->m_after;
        setText(m_text(m_before, m_after));
        setObsolete(m_after == m_before);
        return true;
    }

private:
    CDocument& m_document;
    CParams m_before, m_after;
    fs::path m_folder;
    int m_gesture;
    QString m_subject;
    CDocument::StepText m_text;
};

/// The step to another file's tree and back.
class CPresetCommand : public QUndoCommand {
public:
    CPresetCommand(CDocument& document, const QString& text, CDocument::PlacePtr after)
        : QUndoCommand(text), m_document(document), m_before(document.m_place), m_after(std::move(after)),
          m_params(document.params()), m_preset(m_after->file->params()), m_folder(document.folder()) {}

    void undo() override { m_document.assign(m_before, m_params, m_folder); }
    void redo() override { m_document.assign(m_after, m_preset, {}); }

private:
    CDocument& m_document;
    CDocument::PlacePtr m_before, m_after;
    CParams m_params, m_preset;
    fs::path m_folder;
};

std::string rebasedPath(const std::string& path, const fs::path& from, const fs::path& to) {
    if (!isPath(path) || from.empty() || fs::path(path).is_absolute()) return path;
    std::error_code problem;
    const fs::path whole = fs::weakly_canonical(fs::absolute(from, problem) / path, problem);
    if (problem) return path;
    if (to.empty()) return whole.generic_string();
    const fs::path relative = fs::relative(whole, fs::absolute(to, problem), problem);
    return (problem || relative.empty() ? whole : relative).generic_string();
}

fs::path CDocument::Place::folder() const { return path.isEmpty() ? fs::path() : toPath(path).parent_path(); }

CDocument::CDocument(QObject* parent) : QObject(parent), m_place(newPlace(CTreeFile(), {}, {})) {}

CDocument::PlacePtr CDocument::newPlace(CTreeFile file, const QString& path, const QString& name) {
    auto place = std::make_shared<Place>(Place{std::make_shared<CTreeFile>(std::move(file)), path, name});
    std::erase_if(m_places, [](const std::weak_ptr<Place>& known) { return known.expired(); });
    m_places.push_back(place);
    return place;
}

fs::path CDocument::folder() const { return m_place->folder(); }

QString CDocument::displayName() const {
    if (!path().isEmpty()) return QFileInfo(path()).fileName();
    return m_place->name.isEmpty() ? tr("new.tree") : m_place->name;
}

void CDocument::startNew(const ParamBlock& block) { replace(newPlace(CTreeFile(block), {}, {})); }

void CDocument::open(const QString& path) {
    replace(newPlace(CTreeFile::read(toPath(path)), QFileInfo(path).absoluteFilePath(), {}));
}

void CDocument::goBack() {
    if (!m_previous) return;
    const PlacePtr place = m_previous;
    const CParams wanted = m_previousParams;
    replace(place);
    m_previous.reset();
    if (wanted == m_params) return;
    edit(tr("Unsaved changes"), [&](CParams& params) { params = wanted; });
}

void CDocument::replace(const PlacePtr& place) {
    m_history.clear();
    m_previous = m_place;
    m_previousParams = m_params;
    m_place = place;
    setParams(m_place->file->params());
    emit nameChanged();
    emit replaced();
}

void CDocument::loadPreset(const QString& path) {
    CTreeFile file = CTreeFile::read(toPath(path));
    const CParams whole = withWholePaths(file.params(), toPath(QFileInfo(path).absolutePath()));
    const bool open = this->path().isEmpty() && displayName() == QFileInfo(path).fileName() && m_params == whole;
    if (open) return; // the second click of a double click
    if (whole != file.params()) file = CTreeFile::parse(file.text(whole), path.toStdString());
    m_history.push(new CPresetCommand(*this, tr("Open preset %1").arg(QFileInfo(path).completeBaseName()),
                                      newPlace(std::move(file), {}, QFileInfo(path).fileName())));
}

void CDocument::startWith(const QString& path) {
    loadPreset(path);
    m_history.clear();
}

void CDocument::restore(const QString& path, const CParams& params) {
    const bool absolute = QFileInfo(path).isAbsolute();
    CParams wanted = params;
    try {
        if (!absolute || !QFileInfo::exists(path)) throw CError("");
        open(path);
    } catch (const CError&) { // gone or broken meanwhile: what was kept is still whole
        replace(newPlace(CTreeFile(), {}, QFileInfo(path).fileName()));
        if (absolute) wanted = withWholePaths(params, toPath(QFileInfo(path).absolutePath()));
    }
    edit(tr("Restore"), [&](CParams& p) { p = wanted; });
}

void CDocument::import(const QString& path) {
    const ImportedTree tree = importTree(toPath(path));
    const PlacePtr place = newPlace(CTreeFile(tree.params.block()), {}, QFileInfo(path).completeBaseName() + QStringLiteral(".tree"));
    place->notes = tree.notes;
    replace(place);
    edit(tr("Import %1").arg(QFileInfo(path).fileName()), [&](CParams& params) {
        const fs::path folder = params.folder;
        params = tree.params;
        params.folder = folder;
    });
}

void CDocument::keepAgainstFile() {
    m_place->diverged = true;
    emit nameChanged();
}

CParams CDocument::paramsFor(const QString& target) const {
    return rebased(m_params, folder(), toPath(target).parent_path());
}

void CDocument::save(const QString& path) {
    const QString target = QFileInfo(path).absoluteFilePath();
    const auto file = std::make_shared<CTreeFile>(m_place->file->write(toPath(target), paramsFor(target)));
    for (const std::weak_ptr<Place>& known : m_places) // another one's file was perhaps written over
        if (const PlacePtr place = known.lock(); place && place->path == target) place->file = file;
    m_place->file = file;
    m_place->path = target;
    m_place->diverged = false;
    setParams(file->params());
    emit nameChanged();
}

void CDocument::saveCopy(const QString& path, const QString& species) const {
    CParams params = paramsFor(path);
    params.text.species = species.toStdString();
    static_cast<void>(m_place->file->write(toPath(path), params));
}

void CDocument::edit(const QString& text, const std::function<void(CParams&)>& change, int gesture,
                     const QString& subject) {
    push([text](const CParams&, const CParams&) { return text; }, change, gesture, subject);
}

void CDocument::push(const StepText& text, const std::function<void(CParams&)>& change, int gesture, const QString& subject) {
    CParams after = m_params;
    change(after);
    if (after != m_params) m_history.push(new CEditCommand(*this, text, std::move(after), gesture, subject));
}

void CDocument::setValue(const ParamRef& ref, const ParamValue& value, int gesture) {
    push([ref](const CParams& before, const CParams& after) { return stepText(ref, before, after); },
         [&](CParams& p) { ref.setValue(p, value); }, gesture, toQString(ref.key()));
}

void CDocument::setValues(const QString& text, const ParamValues& values) {
    edit(text, [&](CParams& p) {
        for (const auto& [ref, value] : values) ref.setValue(p, value);
    });
}

void CDocument::setParams(CParams params) {
    m_params = std::move(params);
    m_params.folder = folder();
}

void CDocument::assign(const CParams& params, const fs::path& from) {
    setParams(rebased(params, from, folder()));
    emit changed();
    emit nameChanged();
}

void CDocument::assign(const PlacePtr& place, const CParams& params, const fs::path& from) {
    m_place = place;
    setParams(rebased(params, from, folder()));
    emit nameChanged();
    emit replaced();
}

} // namespace stromar
