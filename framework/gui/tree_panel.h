#pragma once
#include "worker/tree_drawing.h"
#include <framework/trackball.h>
#include <glm/vec2.hpp>

namespace gui {

// A level and a leaf of a submission's tree, as its code draws them over the picture.
class TreePanel {
public:
    void controls(); // in the current ImGui window
    [[nodiscard]] worker::TreeRequest wanted() const;

    void show(worker::TreeDrawing drawing);
    void forget() { m_drawing = {}; }
    [[nodiscard]] const worker::TreeDrawing& drawing() const { return m_drawing; }

    // Over the picture that a camera sees in this area of the window.
    void drawOver(const Trackball& camera, const glm::vec2& first, const glm::vec2& last) const;

private:
    worker::TreeDrawing m_drawing; // the newest
    bool m_showsLevel = false, m_showsLeaf = false;
    int m_level = 0, m_leaf = 1;
};

}
