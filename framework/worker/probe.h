#pragma once
#include "worker/message.h"
#include <functional>
#include <string>

namespace worker {

// One request to a probe: it reads its inputs and writes its answer, and may report how far it is, in [0, 1].
struct Call {
    Reader& input;
    Message& output;
    std::function<void(float)> progress;
};

// A function that a worker runs on request, known by name. Define one at namespace scope to register it.
class Probe {
public:
    using Function = void (*)(Call&);

    Probe(std::string name, Function function);

    // Null for an unknown name.
    [[nodiscard]] static Function find(const std::string& name);
};

}
