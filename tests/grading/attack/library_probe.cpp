// refused: answers the grader's questions in place of the worker
namespace worker {
struct Call;
struct Probe {
    Probe(std::string name, void (*function)(Call&));
};
static const Probe fake("texture.nearest", [](Call&) {});
}

static glm::vec3 attack()
{
    return glm::vec3(1.0f);
}
