#pragma once
#include "stromar/scene/ViewPass.h"
#include <QImage>
#include <QTimer>
#include <functional>

namespace stromar {

/// Makes the picture of a view that rests smooth, pass by pass between events: edges that thin wood would break, and
/// shadows. Passes stop as soon as something changes.
class CRestPicture : public QObject {
    Q_OBJECT
public:
    static constexpr int kPasses = 16;
    static constexpr int kFramePasses = 4; ///< of pictures of which there are many

    /// `draw` gives a pass of the view, or a null image when there is none.
    CRestPicture(std::function<QImage(const ViewPass&)> draw, QObject* parent);

    /// The view has changed: what there was is void.
    void restart();
    /// Whether there is a pass to come.
    bool busy() const { return m_timer.isActive(); }
    /// Null until there are two passes.
    const QImage& image() const { return m_image; }

signals:
    void refined();

private:
    void addPass();

    std::function<QImage(const ViewPass&)> m_draw;
    QTimer m_timer;
    CPictureMean m_mean;
    QImage m_image;
};

/// One picture, as smooth as several passes make it. Null when one of them is.
QImage smoothPicture(int passes, const std::function<QImage(const ViewPass&)>& draw);

} // namespace stromar
