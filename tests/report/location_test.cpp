#include "files/temporary_folder.h"
#include "report/location.h"
#include <catch2/catch.hpp>

TEST_CASE("A function is found where it is defined, not where it is called or declared", "[report]")
{
    const files_test::TemporaryFolder folder;
    folder.write("shading.cpp",
        "#include \"shading.h\"\n"
        "glm::vec3 helper(float ti);\n"
        "static float other() { return helper(1.0f).x; }\n"
        "// glm::vec3 helper(float ti) {\n"
        "glm::vec3 helper(\n"
        "    float ti)\n"
        "{\n"
        "    return glm::vec3(ti);\n"
        "}\n");
    const report::Location location = report::locate("helper", folder / ".", "shading.cpp");
    CHECK(location.file == "shading.cpp");
    CHECK(location.line == 5);
    CHECK(report::locate("nowhere", folder / ".", "shading.cpp").file.empty());
}
