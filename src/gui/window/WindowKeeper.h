#pragma once
#include "window/MainWindow.h"
#include <QObject>
#include <memory>

namespace stromar {

/// Holds the window. Texts and units are laid down when a window is made: for others a new one takes over the document,
/// its history and the view.
class CWindowKeeper : public QObject {
    Q_OBJECT
public:
    explicit CWindowKeeper(const SizeLimits& limits = {}, QObject* parent = nullptr);

    CMainWindow& window() { return *m_window; }

private:
    void make(std::shared_ptr<CDocument> document);
    void rebuild();

    SizeLimits m_limits;
    std::unique_ptr<CMainWindow> m_window;
};

} // namespace stromar
