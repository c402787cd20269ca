#include "app/render_pixels.h"
#include "extra.h"

void renderImageWithDepthOfField(
    const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera, Screen& screen)
{
    app::renderPixels(scene, bvh, features, camera, screen);
}
