#include "files/digest.h"
#include "files/text.h"
#include "submission/features.h"
#include "submission/handed_out.h"
#include "submission/paths.h"
#include <catch2/catch.hpp>
#include <filesystem>

TEST_CASE("Each file of student/ is known as it is handed out, and no longer when anything is written into it")
{
    for (const std::string& name : submission::features) {
        const std::string text
            = files::readText(std::filesystem::path(submission::sourceDirectory) / "student" / (name + ".cpp"));
        INFO(
            "If students are to get this file: { \"" << name << "\", \"" << files::Digest().add(text).hex() << "\" },");
        CHECK(submission::isAsHandedOut(name, text));
        CHECK_FALSE(submission::isAsHandedOut(name, text + "\n"));
        CHECK_FALSE(submission::isAsHandedOut(name, ""));
    }
}
