#include "grading/expected.h"
#include "grading/scene_folders.h"

namespace grading {

std::string keyOf(const std::string& probe, const worker::Message& input)
{
    return files::Digest().add(digestOfScenes()).add(probe).add(input.bytes()).hex();
}

}
