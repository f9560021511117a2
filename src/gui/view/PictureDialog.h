#pragma once
#include <QDialog>
#include <QSize>

class QCheckBox;
class QSpinBox;

namespace stromar {

/// A picture of the tree, or the frames of a turntable, as files.
struct PictureOptions {
    QSize size;
    bool transparent = false;
    int frames = 1; ///< more than 1: the tree turns once around
    QString path;

    /// `path`, with the number of the frame in front of the ending when there are several.
    QString fileOf(int frame) const;
};

/// Asks for size, background and frames, then for the file. The last choices are remembered.
class CPictureDialog : public QDialog {
    Q_OBJECT
public:
    explicit CPictureDialog(const QSize& windowSize, QWidget* parent = nullptr);
    PictureOptions options() const;

private:
    void chooseFile();

    QSpinBox* m_width;
    QSpinBox* m_height;
    QCheckBox* m_transparent;
    QSpinBox* m_frames;
    QString m_path;
};

} // namespace stromar
