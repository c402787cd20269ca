#include "app/progress_bar.h"
#include <algorithm>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace app {

void drawProgressBar(float fraction)
{
    if (!isatty(STDERR_FILENO))
        return;
    constexpr int width = 40;
    const int filled = static_cast<int>(std::clamp(fraction, 0.0f, 1.0f) * width);
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#');
    std::fprintf(stderr, "\r[%-*s] %3d %%", width, bar.c_str(), filled * 100 / width);
    std::fflush(stderr);
}

void clearProgressBar()
{
    if (isatty(STDERR_FILENO))
        std::fputs("\r\033[K", stderr);
}

}
