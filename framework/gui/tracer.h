#pragma once
#include "gui/exchange.h"
#include <thread>

namespace gui {

// Traces what a window shows, by a submission's code in a process of its own, from a thread of its own: no call waits.
// A view that is asked for takes the place of the one before at once. When a file of the submission changes it is built
// again, and a new worker takes over.
class Tracer {
public:
    explicit Tracer(const std::filesystem::path& submission);

    // Returns the number that pictures of this view have.
    uint64_t show(const std::filesystem::path& scene, const worker::View& view);
    void follow(glm::ivec2 pixel);
    void drawTree(const worker::TreeRequest& request); // of this scene and those to come
    void setPaused(bool isPaused); // the picture: rays are followed all the same

    // What is new since the last call.
    [[nodiscard]] std::optional<Picture> takePicture();
    [[nodiscard]] std::optional<worker::DebugRay> takeRay();
    [[nodiscard]] std::optional<worker::TreeDrawing> takeTree();
    [[nodiscard]] std::string takePrinted(); // by the submission's code, also while it is busy

    // What is wrong with the submission, or with the scene; empty while all is well.
    [[nodiscard]] std::string message();

private:
    Exchange m_exchange;
    std::jthread m_thread; // the last member: it uses the other
};

}
