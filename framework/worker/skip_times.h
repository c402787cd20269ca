#pragma once
#include "worker/render_request.h"

namespace worker {

// What the probe render.skip answers a SpeedRequest: one time a repetition of the same frame, by turns on one thread,
// with the library's tree.
struct SkipTimes {
    std::vector<double> skipping, without; // what the picture does not need
    std::vector<double> specialised; // code that was compiled for what it needs alone
    bool isSame = false; // to the bit, skipping and without
    float farthest = 0.0f; // any channel of a pixel by the specialised code from that by skipping
};

inline Message& operator<<(Message& message, const SkipTimes& t)
{
    return message << t.skipping << t.without << t.specialised << t.isSame << t.farthest;
}

inline Reader& operator>>(Reader& reader, SkipTimes& t)
{
    return reader >> t.skipping >> t.without >> t.specialised >> t.isSame >> t.farthest;
}

}
