#include "grading/html/page.h"
#include "grading/report.h"
#include "grading/write_whole.h"
#include <algorithm>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>
#include <sodium.h>

namespace grading {
namespace {

    using Json = nlohmann::ordered_json;

    std::string toBase64(const std::vector<glm::vec3>& pixels)
    {
        constexpr int variant = sodium_base64_VARIANT_ORIGINAL;
        const std::size_t numBytes = pixels.size() * sizeof(glm::vec3);
        std::string text(sodium_base64_encoded_len(numBytes, variant), '\0');
        sodium_bin2base64(
            text.data(), text.size(), reinterpret_cast<const unsigned char*>(pixels.data()), numBytes, variant);
        text.pop_back(); // the zero that ends it
        return text;
    }

    // A submission's picture may have any size, and any number of pixels for it.
    bool areComparable(const PicturePair& pair)
    {
        if (pair.size.x <= 0 || pair.size.y <= 0)
            return false;
        const auto numPixels = static_cast<std::size_t>(pair.size.x) * static_cast<std::size_t>(pair.size.y);
        return pair.came.size() == numPixels && pair.expected.size() == numPixels;
    }

    // The floats themselves, not pictures of 8 bits: the page shows what they are, and draws them.
    Json toPageJson(const PicturePair& pair)
    {
        const glm::ivec2 worst = glm::clamp(pair.worst, glm::ivec2(0), pair.size - 1);
        return { { "width", pair.size.x }, { "height", pair.size.y }, { "worst", { worst.x, worst.y } },
            { "expected", toBase64(pair.expected) }, { "came", toBase64(pair.came) } };
    }

    Json toPageJson(const Row& row)
    {
        if (row.hidden)
            return { { "name", row.name }, { "status", "hidden" } };
        Json json { { "name", row.name }, { "status", std::string(toText(row.status)) }, { "score", row.score },
            { "maxScore", row.maxScore }, { "message", row.message }, { "cause", row.usualCause } };
        if (row.pictures && areComparable(*row.pictures))
            json["pictures"] = toPageJson(*row.pictures);
        return json;
    }

    Json toPageJson(const Grade& grade)
    {
        const std::vector<Row>& rows = grade.rows;
        const Score total = totalOf(rows);
        Json json { { "submission", grade.submission }, { "notSandboxed", grade.notSandboxed },
            { "score", total.score }, { "maxScore", total.maxScore } };
        json["features"] = Json::array();
        for (const std::string& feature : featuresOf(rows)) {
            const Score part = totalOf(rows, feature);
            Json checks = Json::array();
            for (const Row& row : rowsOf(rows, feature))
                checks.push_back(toPageJson(row));
            Json& ofFeature = json["features"].emplace_back(Json { { "name", feature }, { "score", part.score },
                { "maxScore", part.maxScore }, { "checks", std::move(checks) } });
            const auto observation = std::ranges::find(grade.observations, feature, &Observation::feature);
            if (observation != grade.observations.end()) {
                ofFeature["drawn"] = observation->drawn;
                ofFeature["solutionDraws"] = observation->expected;
            }
        }
        return json;
    }

    // For a script element, which ends at the first "</script", whatever it stands in. In JSON a "<" is part of a
    // string, so it may be spelt otherwise.
    std::string toScript(const Json& json)
    {
        std::string script;
        for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
            c == '<' ? script += "\\u003c" : script += c;
        return script;
    }

}

void writeHtml(const std::filesystem::path& path, const Grade& grade)
{
    constexpr std::string_view placeholder = "{{data}}";
    std::string page { html::page };
    page.replace(page.find(placeholder), placeholder.size(), toScript(toPageJson(grade)));
    writeWhole(path, page);
}

}
