#pragma once
#include "grading/scene_folders.h"
#include "worker/process.h"

namespace grading {

// What every worker may have, the reference's too.
[[nodiscard]] inline worker::Limits limitsOfWorkers()
{
    const auto scenes = sceneFolders();
    return { .memoryBytes = std::size_t(4) << 30,
        .outputBytes = std::size_t(1) << 20,
        .readable = { scenes.begin(), scenes.end() } };
}

}
