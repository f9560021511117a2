#pragma once
#include "stromar/texture/Draw.h"
#include <QDialog>
#include <QTimer>

class QFormLayout;
class QLabel;
class QScrollArea;

namespace stromar {

/// A dialog in which a recipe is changed while its picture follows.
class CTextureWorkshop : public QDialog {
    Q_OBJECT
public:
    explicit CTextureWorkshop(CRecipe recipe, QWidget* parent = nullptr);

    const CRecipe& recipe() const { return m_recipe; }

private:
    void makeRows();
    QWidget* makeEditor(std::size_t row);
    QWidget* makeNumberEditor(std::size_t row);
    QWidget* makeColourEditor(std::size_t row);
    void set(std::size_t row, const QString& value);
    void draw();
    void savePictures();

    CRecipe m_recipe;
    QScrollArea* m_scroll;
    QLabel *m_picture, *m_text;
    QTimer m_redraw; ///< a little later: the newest value counts
};

} // namespace stromar
