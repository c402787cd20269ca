#pragma once
#include "debug/false_color.h"
#include "worker/debug_ray.h"
#include "worker/output.h"
#include "worker/tree_drawing.h"
#include "worker/view.h"
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace gui {

// A picture being refined, as far as it is.
struct Picture {
    glm::ivec2 size { 0 };
    std::vector<glm::vec3> pixels; // as seen, row 0 at the bottom; what is not traced yet repeats its neighbour
    uint64_t number = 0; // of the view
    bool isDone = false;
    double seconds = 0.0; // since the view was asked for
    worker::Work work;
    std::vector<worker::ExplainedPart> needs; // none unless all of the work is counted, not the rays alone
    std::size_t memory = 0; // bytes that the worker holds; 0: unknown
    debug::Quantity quantity = debug::Quantity::Color; // that the pixels are the false colours of
    std::vector<glm::vec3> values; // in the pixels, raw; none for colours, which are their own
    debug::Range range; // of the values
};

struct Wanted {
    std::filesystem::path scene; // empty: nothing yet
    worker::View view;
    bool isPaused = false; // no picture is wanted for now
    std::optional<glm::ivec2> pixel; // whose ray is to be followed, once
    worker::TreeRequest tree; // what is to be drawn of it
    uint64_t number = 0; // another one, another view
};

// What the window and the thread that traces for it tell each other.
struct Exchange {
    std::mutex mutex;
    std::condition_variable_any changed; // what is wanted
    Wanted wanted;
    std::optional<Picture> picture; // the newest, until it is taken
    std::optional<worker::DebugRay> ray; // likewise
    std::optional<worker::TreeDrawing> tree; // likewise
    std::shared_ptr<worker::Output> output; // of the worker that runs, or ran last; null: of none so far
    std::string printed; // by workers before, until it is taken
    std::string message; // what is wrong with the submission or the scene; empty while all is well
};

}
