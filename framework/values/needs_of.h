#pragma once
#include "scene.h"
#include "scene_needs.h"
#include <string>

namespace values {

// A part of what rendering can do, and whether a picture needs it.
struct Need {
    std::string part;
    bool SceneNeeds::*member;
    bool isNeeded;
    std::string why; // it is left out; empty where it is needed
};

// What is true of a scene with these features, one for each member of SceneNeeds.
[[nodiscard]] std::vector<Need> judgeNeeds(const Scene& scene, const Features& features);

// As judged; all of it where the features do not let anything be left out.
[[nodiscard]] SceneNeeds needsOf(const Scene& scene, const Features& features);

}
