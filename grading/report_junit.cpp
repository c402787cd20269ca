#include "grading/report.h"
#include "grading/write_whole.h"
#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

namespace grading {
namespace {

    // Text that XML 1.0 can hold at all (section 2.2): most control characters have no spelling in it, nor have U+FFFE
    // and U+FFFF. pugixml escapes the rest.
    std::string toXmlText(const std::string& text)
    {
        std::string valid = toUtf8(text);
        for (char& c : valid)
            if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
                c = '?';
        for (const char* const noCharacter : { "\xEF\xBF\xBE", "\xEF\xBF\xBF" })
            for (std::size_t at; (at = valid.find(noCharacter)) != std::string::npos;)
                valid.replace(at, 3, 1, '?');
        return valid;
    }

    bool isFailure(const Row& row)
    {
        return !row.hidden && row.status != Status::Passed;
    }

    void setCounts(pugi::xml_node node, const std::vector<Row>& rows)
    {
        node.append_attribute("tests") = static_cast<unsigned long long>(rows.size());
        node.append_attribute("failures") = static_cast<unsigned long long>(std::ranges::count_if(rows, isFailure));
        node.append_attribute("errors") = 0;
        node.append_attribute("skipped")
            = static_cast<unsigned long long>(std::ranges::count(rows, true, &Row::hidden));
    }

    void append(pugi::xml_node suite, const Row& row)
    {
        pugi::xml_node test = suite.append_child("testcase");
        test.append_attribute("classname") = row.feature.c_str();
        test.append_attribute("name") = row.name.c_str();
        if (row.hidden) // neither passed nor failed
            test.append_child("skipped").append_attribute("message") = "hidden";
        if (!isFailure(row))
            return;
        const std::string explanation = toXmlText(explanationOf(row));
        pugi::xml_node failure = test.append_child("failure");
        failure.append_attribute("type") = std::string(toText(row.status)).c_str();
        failure.append_attribute("message") = explanation.substr(0, explanation.find('\n')).c_str();
        failure.text().set(explanation.c_str());
    }

}

void writeJunit(const std::filesystem::path& path, const Grade& grade)
{
    const std::vector<Row>& rows = grade.rows;
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node suites = document.append_child("testsuites");
    setCounts(suites, rows);
    for (const std::string& feature : featuresOf(rows)) {
        const std::vector<Row> ofFeature = rowsOf(rows, feature);
        pugi::xml_node suite = suites.append_child("testsuite");
        suite.append_attribute("name") = feature.c_str();
        setCounts(suite, ofFeature);
        for (const Row& row : ofFeature)
            append(suite, row);
    }
    std::ostringstream text;
    document.save(text, "  ");
    writeWhole(path, text.str());
}

}
