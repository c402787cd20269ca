#include "grading/watch.h"
#include "submission/watched_folder.h"
#include <chrono>
#include <thread>

namespace grading {

void watch(const std::filesystem::path& folder, const std::function<void()>& onChange)
{
    constexpr std::chrono::milliseconds interval { 200 };
    submission::WatchedFolder watched { folder };
    for (;;) {
        onChange();
        while (!watched.hasChanged())
            std::this_thread::sleep_for(interval);
    }
}

}
