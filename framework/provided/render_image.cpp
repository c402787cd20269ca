#include "app/render_pixels.h"
#include "extra.h"
#include "render.h"

void renderImage(
    const Scene& scene, const BVHInterface& bvh, const Features& features, const Trackball& camera, Screen& screen)
{
    if (features.extra.enableDepthOfField)
        renderImageWithDepthOfField(scene, bvh, features, camera, screen);
    else if (features.extra.enableMotionBlur)
        renderImageWithMotionBlur(scene, bvh, features, camera, screen);
    else
        app::renderPixels(scene, bvh, features, camera, screen);
    if (features.extra.enableBloomEffect)
        postprocessImageWithBloom(scene, features, camera, screen);
}
