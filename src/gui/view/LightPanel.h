#pragma once
#include "stromar/scene/ViewScene.h"
#include <QWidget>
#include <functional>

namespace stromar {

/// Sliders for the light of the picture: one for each row of a table. They belong to the view, not to the tree, and are
/// kept between runs.
class CLightPanel : public QWidget {
    Q_OBJECT
public:
    explicit CLightPanel(QWidget* parent = nullptr);

    /// Puts what the sliders say into a look.
    void applyTo(ViewLook& look) const;

signals:
    void changed();

private:
    std::vector<std::function<void(Light&)>> m_rows;
};

} // namespace stromar
