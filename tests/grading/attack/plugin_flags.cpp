// wrong: asks the compiler to be lenient, and redefines what a test might be made of
#pragma GCC diagnostic ignored "-Wall"
#define CHECK(...) true
#define REQUIRE(...) true
#define expectNear(...) true
#define Wrong Passed

static glm::vec3 attack()
{
    return glm::vec3(1.0f);
}
