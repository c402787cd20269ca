#include "report/figure_html.h"
#include "report/html.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace report {
namespace {

    using nlohmann::json;
    namespace fs = std::filesystem;

    std::string text(const json& object, const char* name)
    {
        return escaped(object.at(name).get<std::string>());
    }

    std::string labelOf(const json& panel)
    {
        const std::string label = text(panel, "label");
        return label.empty() ? label : "<p class=\"label\">" + label + "</p>";
    }

    // Drawings as they are, so that their lines stay lines.
    std::string imageOf(const json& panel, const fs::path& folder)
    {
        const fs::path file = folder / panel.value("svg", panel.at("png").get<std::string>());
        return fmt::format("<img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\">", dataUri(file),
            text(panel, "label"), panel.at("width").get<int>(), panel.at("height").get<int>());
    }

    // --width in pixels of the PNG: on paper it is not to have less than 150 an inch.
    std::string openPanel(const char* kind, const json& panel)
    {
        return fmt::format("<div class=\"panel {}\" style=\"--width: {}; --ratio: {} / {}\">", kind,
            panel.at("width").get<int>(), panel.at("width").get<int>(), panel.at("height").get<int>());
    }

    std::string picture(const json& panel, const fs::path& folder)
    {
        return openPanel("picture", panel) + "<button class=\"zoom\" aria-label=\"Enlarge\">" + imageOf(panel, folder)
            + "</button>" + labelOf(panel) + "</div>";
    }

    std::string plot(const json& panel, const fs::path& folder)
    {
        return openPanel("plot", panel)
            + inlinePlot(folder / panel.at("svg").get<std::string>(), panel.at("label").get<std::string>())
            + labelOf(panel) + "</div>";
    }

    // On paper its pictures stand side by side, each with its label.
    std::string slider(const json& panel, const fs::path& folder)
    {
        const json &before = panel.at("before"), &after = panel.at("after");
        return openPanel("slider", before)
            + fmt::format("<div class=\"stage\"><div class=\"before\">{}{}</div><div class=\"after\">{}{}</div>"
                          "<i class=\"divider\"></i><input class=\"split\" type=\"range\" min=\"0\" max=\"100\" "
                          "step=\"0.5\" value=\"50\" aria-label=\"How much of {} lies over {}\"></div></div>",
                imageOf(before, folder), labelOf(before), imageOf(after, folder), labelOf(after), text(before, "label"),
                text(after, "label"));
    }

    std::string rowOf(const json& cells, const char* tag)
    {
        std::string row;
        for (const json& cell : cells)
            row += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell.get<std::string>()));
        return "<tr>" + row + "</tr>";
    }

    std::string table(const json& panel)
    {
        std::string rows;
        for (const json& row : panel.at("rows"))
            rows += rowOf(row, "td");
        return "<div class=\"panel table\"><table><thead>" + rowOf(panel.at("head"), "th") + "</thead><tbody>" + rows
            + "</tbody></table>" + labelOf(panel) + "</div>";
    }

    std::string panelOf(const json& panel, const fs::path& folder)
    {
        const auto kind = panel.at("kind").get<std::string>();
        if (kind == "slider")
            return slider(panel, folder);
        if (kind == "table")
            return table(panel);
        return kind == "plot" ? plot(panel, folder) : picture(panel, folder);
    }

    std::string panelsOf(const json& figure, const fs::path& folder)
    {
        std::string panels;
        for (const json& panel : figure.at("panels"))
            panels += panelOf(panel, folder);
        return fmt::format(
            "<div class=\"panels in-{0}\" style=\"--columns: {0}\">{1}</div>", figure.at("columns").get<int>(), panels);
    }

    std::string claimsOf(const json& figure)
    {
        std::string claims;
        for (const json& claim : figure.at("claims"))
            claims
                += fmt::format("<li class=\"{}\">{}</li>", claim.at("holds") ? "holds" : "fails", text(claim, "text"));
        return claims.empty() ? claims : "<ul class=\"claims\">" + claims + "</ul>";
    }

    std::string factsOf(const json& figure)
    {
        std::string facts;
        for (const json& fact : figure.at("facts"))
            facts += fmt::format("<span>{} <b>{}</b></span> ", escaped(fact.at(0).get<std::string>()),
                escaped(fact.at(1).get<std::string>()));
        std::string stubs;
        for (const json& stub : figure.at("stubs"))
            stubs += (stubs.empty() ? "" : ", ") + escaped(stub.get<std::string>());
        return stubs.empty() ? facts : facts + "<span>with stubs for <b>" + stubs + "</b></span> ";
    }

    std::string contentOf(const json& figure, const fs::path& folder)
    {
        const auto state = figure.at("state").get<std::string>();
        if (state == "drawn")
            return panelsOf(figure, folder);
        return fmt::format("<p class=\"instead\"><b>{}</b> {}</p>",
            state == "failed" ? "The code failed." : "Not written yet:", text(figure, "message"));
    }

    std::string captionOf(const json& figure, const std::string& again)
    {
        const bool isDrawn = figure.at("state") == "drawn";
        return fmt::format("<figcaption>{}<p class=\"facts\">{}<code>{}</code></p></figcaption>",
            isDrawn ? claimsOf(figure) : "", isDrawn ? factsOf(figure) : "", escaped(again));
    }

}

std::string toHtml(const json& figure, const fs::path& folder, const std::string& again)
{
    return fmt::format("<figure id=\"{0}\" data-state=\"{1}\"><h4>{2}</h4>{3}{4}</figure>\n", text(figure, "name"),
        text(figure, "state"), text(figure, "title"), contentOf(figure, folder), captionOf(figure, again));
}

}
