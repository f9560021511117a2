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

std::string rebasedPath(const std::string& path, const fs::path& from, const fs::path& to) {
    if (path.empty() || fs::path(path).is_absolute()) return path;
    std::error_code problem;
    const fs::path whole = fs::weakly_canonical(fs::absolute(from) / path, problem);
    const fs::path relative = fs::relative(whole, fs::absolute(to), problem);
    return (problem || relative.empty() ? whole : relative).generic_string();
}

CDocument::CDocument(QObject* parent) : QObject(parent) {
    connect(&m_history, &QUndoStack::cleanChanged, this, &CDocument::nameChanged);
}

fs::path CDocument::folder() const { return m_path.isEmpty() ? fs::path() : toPath(m_path).parent_path(); }

QString CDocument::displayName() const { return m_path.isEmpty() ? tr("new.tree") : QFileInfo(m_path).fileName(); }

void CDocument::startNew() { replace(CTreeFile(), {}); }

void CDocument::open(const QString& path) {
    replace(CTreeFile::read(toPath(path)), QFileInfo(path).absoluteFilePath());
}

void CDocument::replace(CTreeFile file, const QString& path) {
    m_file = std::move(file);
    m_params = m_file.params();
    m_path = path;
    m_history.clear();
    emit nameChanged();
    emit replaced();
}

void CDocument::save(const QString& path) {
    const QString target = QFileInfo(path).absoluteFilePath();
    CParams saved = m_params;
    for (const TextInfo& text : textTable())
        if (text.path)
            saved.text.*text.field = rebasedPath(m_params.text.*text.field, folder(), toPath(target).parent_path());
    m_file = m_file.write(toPath(target), saved);
    m_params = saved;
    m_path = target;
    m_history.setClean();
    emit nameChanged();
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

void CDocument::setText(const TextInfo& text, const QString& value) {
    std::string problem;
    edit(tr("Change %1").arg(toQString(text.key)),
         [&](CParams& p) { setFromText(p, ParamTarget(&text), value.toStdString(), problem); });
}

void CDocument::assign(const CParams& params) {
    m_params = params;
    emit changed();
}

} // namespace stromar
