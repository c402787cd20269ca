#pragma once

// Which functions are the provided ones: the linker leaves the others out, with their marks, where a submission has its
// own. Of those the address is null.
namespace provided {

[[gnu::weak]] extern const char shadingMark, lambertianMark, phongMark, blinnPhongMark, colorMark, pixelRaysMark,
    raysMark;

[[nodiscard]] inline bool hasOwnModels()
{
    return !(&shadingMark && &lambertianMark && &phongMark && &blinnPhongMark);
}

[[nodiscard]] inline bool hasOwnColors()
{
    return !&colorMark;
}

[[nodiscard]] inline bool hasOwnPixels()
{
    return !(&pixelRaysMark && &raysMark);
}

}
