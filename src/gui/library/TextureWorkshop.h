#pragma once
#include "work/LatestTask.h"
#include "stromar/texture/Draw.h"
#include <QDialog>
#include <QTimer>

class QComboBox;
class QFormLayout;
class QLabel;
class QScrollArea;

namespace stromar {

/// A dialog in which a recipe is changed while its picture follows, and who listens.
class CTextureWorkshop : public QDialog {
    Q_OBJECT
public:
    /// `aspect`: width over height of what wears the picture.
    explicit CTextureWorkshop(CRecipe recipe, double aspect = 1, QWidget* parent = nullptr);

    const CRecipe& recipe() const { return m_recipe; }

signals:
    /// A moment after the last of several.
    void changed();

private:
    bool tiles() const;
    QPixmap picture() const;
    void makeRows();
    QWidget* makeEditor(std::size_t row);
    QWidget* makeNumberEditor(std::size_t row);
    QWidget* makeColourEditor(std::size_t row);
    void set(std::size_t row, const QString& value);
    void draw();
    void showMap();
    void savePictures();

    CRecipe m_recipe;
    double m_aspect;
    TextureMaps m_maps; ///< that were drawn last
    QComboBox* m_map; ///< which of its pictures is shown
    QScrollArea* m_scroll;
    QLabel *m_picture, *m_text;
    QTimer m_redraw; ///< a little later: the newest value counts
    CLatestTask m_drawing;
};

} // namespace stromar
