#include "browser/browser.h"
#include <stdexcept>

namespace browser {

using nlohmann::json;

// For one step of a test: Chromium takes seconds to start where other tests run beside it.
static constexpr std::chrono::seconds patience { 60 };

Browser::Browser()
    : m_chromium((m_profile / "profile").string())
{
    const json tab = call("Target.createTarget", { { "url", "about:blank" } });
    m_session = call("Target.attachToTarget", { { "targetId", tab.at("targetId") }, { "flatten", true } })
                    .at("sessionId")
                    .get<std::string>();
    for (const char* const domain : { "Page", "Runtime", "Log", "Network" })
        call(std::string(domain) + ".enable");
}

void Browser::open(const std::filesystem::path& page)
{
    m_loaded = false;
    call("Page.navigate", { { "url", "file://" + std::filesystem::absolute(page).string() } });
    while (!m_loaded)
        note(next());
}

json Browser::evaluate(const std::string& expression)
{
    const json answer = call(
        "Runtime.evaluate", { { "expression", expression }, { "returnByValue", true }, { "awaitPromise", true } });
    if (answer.contains("exceptionDetails"))
        throw std::runtime_error(expression + ": " + answer.at("exceptionDetails").dump());
    return answer.at("result").value("value", json());
}

void Browser::setView(int width, int height, bool dark)
{
    call("Emulation.setDeviceMetricsOverride",
        { { "width", width }, { "height", height }, { "deviceScaleFactor", 1 }, { "mobile", false } });
    const json scheme = { { "name", "prefers-color-scheme" }, { "value", dark ? "dark" : "light" } };
    call("Emulation.setEmulatedMedia", { { "features", json::array({ scheme }) } });
}

void Browser::hover(Point point)
{
    mouse("mouseMoved", point, false);
}

void Browser::drag(Point from, Point to)
{
    mouse("mouseMoved", from, false);
    mouse("mousePressed", from, true);
    constexpr int numSteps = 5; // a drag is more than where it ends
    for (int i = 1; i <= numSteps; ++i) {
        const double share = static_cast<double>(i) / numSteps;
        mouse("mouseMoved", { from.x + share * (to.x - from.x), from.y + share * (to.y - from.y) }, true);
    }
    mouse("mouseReleased", to, false);
}

void Browser::press(const std::string& key)
{
    for (const char* const type : { "rawKeyDown", "keyUp" })
        call("Input.dispatchKeyEvent", { { "type", type }, { "key", key }, { "code", key } });
}

std::string Browser::screenshot(bool wholePage)
{
    return call("Page.captureScreenshot", { { "captureBeyondViewport", wholePage } }).at("data").get<std::string>();
}

void Browser::mouse(const std::string& type, Point point, bool held)
{
    const bool click = type != "mouseMoved";
    call("Input.dispatchMouseEvent",
        { { "type", type }, { "x", point.x }, { "y", point.y }, { "button", held || click ? "left" : "none" },
            { "buttons", held ? 1 : 0 }, { "clickCount", click ? 1 : 0 } });
}

json Browser::call(const std::string& method, json parameters)
{
    json request = { { "id", ++m_lastId }, { "method", method }, { "params", std::move(parameters) } };
    if (!m_session.empty())
        request["sessionId"] = m_session;
    m_chromium.send(request);
    for (;;) {
        json message = next();
        if (message.value("id", 0) != m_lastId) {
            note(message);
            continue;
        }
        if (message.contains("error"))
            throw std::runtime_error(method + ": " + message.at("error").dump());
        return message.at("result");
    }
}

json Browser::next()
{
    return m_chromium.receive(std::chrono::steady_clock::now() + patience);
}

void Browser::note(const json& event)
{
    const std::string method = event.value("method", "");
    if (method == "Page.loadEventFired")
        m_loaded = true;
    else if (method == "Network.requestWillBeSent")
        m_requests.push_back(event.at("params").at("request").at("url").get<std::string>());
    else if (method == "Runtime.exceptionThrown" || method == "Runtime.consoleAPICalled" || method == "Log.entryAdded")
        m_complaints.push_back(event.at("params").dump());
}

}
