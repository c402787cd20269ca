#pragma once
#include "browser/chromium.h"
#include "files/temporary_folder.h"
#include <filesystem>
#include <string>
#include <vector>

namespace browser {

struct Point {
    double x = 0.0, y = 0.0; // CSS pixels from the top left of the view
};

// One tab, driven as a person would. Everything throws std::runtime_error when Chromium refuses, or does not answer in
// time.
class Browser {
public:
    Browser();

    // Loads a page, until its load event.
    void open(const std::filesystem::path& page);

    // What the page's script answers; a promise is awaited. A script that throws is an error.
    nlohmann::json evaluate(const std::string& expression);

    void setView(int width, int height, bool dark = false);
    void hover(Point point);
    void drag(Point from, Point to);
    void press(const std::string& key); // as the DOM names it, such as ArrowLeft

    // A PNG of what is in view, or of the whole page; base64.
    [[nodiscard]] std::string screenshot(bool wholePage = false);

    // Errors of scripts, and what the console or the browser complained of.
    [[nodiscard]] const std::vector<std::string>& complaints() const { return m_complaints; }
    // The addresses of all that was loaded.
    [[nodiscard]] const std::vector<std::string>& requests() const { return m_requests; }

private:
    nlohmann::json call(const std::string& method, nlohmann::json parameters = nlohmann::json::object());
    nlohmann::json next();
    void note(const nlohmann::json& event);
    void mouse(const std::string& type, Point point, bool held);

    files_test::TemporaryFolder m_profile; // outlives Chromium
    Chromium m_chromium;
    std::string m_session;
    int m_lastId = 0;
    bool m_loaded = false;
    std::vector<std::string> m_complaints;
    std::vector<std::string> m_requests;
};

}
