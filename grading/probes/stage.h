#pragma once
#include "grading/probes/incidence.h"
#include "scene.h"
#include "worker/scene_message.h"

// What the probes of lights are asked about.
namespace grading {

struct Stage {
    Scene scene; // what throws shadows: not the shaded surface, unless it is added
    Features features;
    Incidence shaded;
};

inline worker::Message& operator<<(worker::Message& message, const Stage& stage)
{
    return message << stage.scene << stage.features << stage.shaded;
}

inline worker::Reader& operator>>(worker::Reader& reader, Stage& stage)
{
    reader >> stage.scene >> stage.features >> stage.shaded;
    stage.shaded.hitInfo.material.kdTexture = nullptr;
    return reader;
}

}
