#include "grading/validate/mutant.h"
#include <catch2/catch.hpp>

// Small changes of a source.

namespace {

// What the only function of the source may be changed to, without the function that returns at once.
std::vector<std::string> changesOf(const std::string& body)
{
    std::vector<std::string> changes;
    for (const grading::Mutant& mutant : grading::mutantsOf("int f()\n{\n" + body + "\n}\n"))
        if (mutant.line > 2)
            changes.push_back(mutant.changed);
    return changes;
}

using Changes = std::vector<std::string>;

}

TEST_CASE("A mutant is the source with one change, and knows the line", "[validation]")
{
    const std::string source = "// a < b\nint f(int a)\n{\n    return a - 2; // two\n}\n";
    const auto mutants = grading::mutantsOf(source);
    REQUIRE(mutants.size() == 4);
    CHECK(mutants[0].text == "// a < b\nint f(int a)\n{ return {};\n    return a - 2; // two\n}\n");
    CHECK(mutants[0].line == 2);
    CHECK(mutants[1].text == "// a < b\nint f(int a)\n{\n    return a + 2; // two\n}\n");
    CHECK(mutants[1].line == 4);
    CHECK(mutants[1].original == "return a - 2;");
    CHECK(mutants[1].changed == "return a + 2;");
    CHECK(mutants[2].changed == "return a - (2 + 1);");
    CHECK(mutants[3].changed == "return a - (-2);");
}

TEST_CASE("Operators, names and numbers are exchanged", "[validation]")
{
    CHECK(changesOf("return a < b;") == Changes { "return a <= b;", "return a >= b;" });
    CHECK(changesOf("return a >= b;") == Changes { "return a > b;", "return a < b;" });
    CHECK(changesOf("return a == b;") == Changes { "return a != b;" });
    CHECK(changesOf("return a * b;") == Changes { "return a / b;" });
    CHECK(changesOf("return a && b;") == Changes { "return a || b;" });
    CHECK(changesOf("return std::min(a, b);") == Changes { "return std::max(a, b);" });
    CHECK(changesOf("return true;") == Changes { "return false;" });
    CHECK(changesOf("return 0.0f;") == Changes { "return 1.0f;" });
    CHECK(changesOf("return 1u;") == Changes { "return 0u;", "return (-1u);" });
    CHECK(changesOf("return 1e-4f;") == Changes { "return (1e-4f + 1);", "return (-1e-4f);" });
    CHECK(changesOf("return a.x;") == Changes { "return a.y;" });
    CHECK(changesOf("int b = a++;") == Changes { "int b = a--;" });
}

TEST_CASE("A statement is left out, a declaration is not", "[validation]")
{
    CHECK(changesOf("a += b;") == Changes { ";", "a -= b;" });
    CHECK(changesOf("call(a,\n    b);") == Changes { ";" });
    CHECK(changesOf("for (auto& a : b)\n    continue;") == Changes { ";" });
    CHECK(changesOf("call([&] { a = b; });") == Changes { ";", "call([&] { ; });" });
    for (const std::string declaration : { "Ray ray;", "const float a = b;", "glm::vec3 a, b;",
             "std::vector<Ray> rays;", "Ray* a = b;", "auto a { b };" })
        CHECK(changesOf(declaration).empty());
}

TEST_CASE("Conditions are negated, and a return under one is left out", "[validation]")
{
    CHECK(changesOf("if (a)\n    return b;") == Changes { "if (!(a))", ";" });
    CHECK(changesOf("if (const int* a = b)\n    return c;") == Changes { ";" });
}

TEST_CASE("What looks like an operator and is none stays", "[validation]")
{
    for (const std::string text : { "return std::array<int, n>(*a, &b, -c);", "return \"a < b\" 'c';", "// a < b",
             "/* a\n < b */", "#define A \\\n a < b\n", "const T* a = &b;" })
        CHECK(changesOf(text).empty());
}

TEST_CASE("A function returns at once with what its type allows", "[validation]")
{
    CHECK(grading::mutantsOf("static void f(int)\n{\n}\n")[0].changed == "static void f(int) { return;");
    CHECK(grading::mutantsOf("bool A::f(int) const\n{\n}\n")[0].changed == "bool A::f(int) const { return {};");
    CHECK(grading::mutantsOf("struct A {\n};\n").empty());
}
