#pragma once
#include <QDialog>
#include <QSize>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace stromar {

/// What is recorded of a tree that moves.
struct RecordOptions {
    enum class What { Growth, Wind, Fall };

    What what = What::Growth;
    QSize size;
    double seconds = 6;
    int fps = 25;
    bool video = false; ///< else numbered pictures
    QString path;

    int frames() const;
    /// The path itself for a video, else that of one of the numbered pictures.
    QString fileOf(int frame) const;
};

/// Asks what to record, how large and how long, then for the file. The last choices are remembered.
class CRecordDialog : public QDialog {
    Q_OBJECT
public:
    CRecordDialog(const QSize& windowSize, bool windBlows, bool felled, QWidget* parent = nullptr);
    RecordOptions options() const;

private:
    void chooseFile();

    QComboBox* m_what;
    QSpinBox *m_width, *m_height, *m_fps;
    QDoubleSpinBox* m_seconds;
    QComboBox* m_kind;
    QString m_path;
};

/// The program that makes videos; empty when it is not installed.
QString videoProgram();

} // namespace stromar
