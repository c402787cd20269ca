// wrong: leaves a process behind that rewrites the results once the grader is done
#include <fstream>
#include <unistd.h>

static glm::vec3 attack()
{
    if (fork() == 0) {
        setsid();
        if (fork() == 0)
            for (;;) {
                std::ofstream("@BUILD@/tests/graded/grade.json") << R"({"score": 100, "max_score": 100})";
                usleep(1000);
            }
        _exit(0);
    }
    return glm::vec3(1.0f);
}
