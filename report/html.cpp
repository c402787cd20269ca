#include "report/html.h"
#include "files/text.h"
#include <regex>
#include <sodium.h>

namespace report {
namespace {

    std::string toBase64(const std::string& bytes)
    {
        constexpr int variant = sodium_base64_VARIANT_ORIGINAL;
        std::string text(sodium_base64_encoded_len(bytes.size(), variant), '\0');
        sodium_bin2base64(
            text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), variant);
        text.pop_back(); // the terminating zero
        return text;
    }

    std::string mediaType(const std::filesystem::path& path)
    {
        const std::string extension = files::lowerExtension(path);
        return extension == ".svg" ? "image/svg+xml" : extension == ".png" ? "image/png" : "image/jpeg";
    }

    void replaceAll(std::string& text, std::string_view from, std::string_view to)
    {
        for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
            text.replace(at, from.size(), to);
    }

}

std::string escaped(std::string_view text)
{
    std::string safe;
    for (const char c : text)
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        default:
            safe += c;
        }
    return safe;
}

std::string dataUri(const std::filesystem::path& path)
{
    return "data:" + mediaType(path) + ";base64," + toBase64(files::readText(path));
}

std::string inlinePlot(const std::filesystem::path& svg, const std::string& label)
{
    std::string plot = files::readText(svg);
    plot.erase(0, plot.find("<svg"));
    const std::string prefix = svg.stem().string() + "-";
    replaceAll(plot, "gpPt", prefix + "gpPt");
    replaceAll(plot, "gpDot", prefix + "gpDot");
    static const std::regex title("<title>(Gnuplot|gnuplot_[^<]*)</title>|<desc>[^]*?</desc>"), ids(" id=\"(gnuplot_)");
    plot = std::regex_replace(plot, title, "");
    // The page's own script shows values; gnuplot's would have to come with each plot.
    static const std::regex value(
        R"~(onmousemove="gnuplot_svg\.showHypertext\(evt,'([^"]*)'\)"[^>]*><title> </title>)~");
    plot = std::regex_replace(plot, value, "class=\"value\" data-value=\"$1\">");
    plot = std::regex_replace(plot, ids, " id=\"" + prefix + "$1");
    static const std::regex ink(R"(rgb\( *27, *35, *48\)|rgb\( *93, *104, *120\)|"black")"); // of plotPrelude
    plot = std::regex_replace(plot, ink, "currentColor");
    replaceAll(plot, "=currentColor", "=\"currentColor\"");
    return plot.insert(plot.find("<svg") + 4, " role=\"img\" aria-label=\"" + escaped(label) + "\"");
}

}
