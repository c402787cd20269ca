#pragma once
#include "adaptive/render.h"
#include "worker/render_request.h"

namespace worker {

// What the probe render.adaptive is asked for: a picture with as many samples as it needs, whatever numbers of them
// the scene file says.
struct AdaptiveRequest {
    RenderRequest render; // of colours
    adaptive::Goal goal;
};

struct AdaptiveRendering {
    Rendering rendering;
    adaptive::Summary summary;
};

inline Message& operator<<(Message& message, const AdaptiveRequest& r)
{
    return message << r.render << r.goal;
}

inline Reader& operator>>(Reader& reader, AdaptiveRequest& r)
{
    return reader >> r.render >> r.goal;
}

inline Message& operator<<(Message& message, const AdaptiveRendering& r)
{
    return message << r.rendering << r.summary;
}

inline Reader& operator>>(Reader& reader, AdaptiveRendering& r)
{
    return reader >> r.rendering >> r.summary;
}

}
