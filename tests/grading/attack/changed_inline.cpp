// refused: has its own version of what the worker inlines win, so that it sends what it likes
namespace worker {
struct Message;
__attribute__((used)) inline Message& operator<<(Message& message, bool)
{
    return message;
}
}

static glm::vec3 attack()
{
    return glm::vec3(1.0f);
}
