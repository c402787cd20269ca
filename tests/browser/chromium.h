#pragma once
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/types.h>

namespace browser {

// A Chromium without a window and its messages: JSON, each ended by a zero byte, on a pipe each way ("--remote-
// debugging-pipe"). Killed when this goes, all its processes with it.
class Chromium {
public:
    // profile: an empty folder that it may fill.
    explicit Chromium(const std::string& profile);
    ~Chromium();
    Chromium(const Chromium&) = delete;
    Chromium& operator=(const Chromium&) = delete;

    void send(const nlohmann::json& message);
    // The next message. Throws std::runtime_error if none comes until the deadline.
    [[nodiscard]] nlohmann::json receive(std::chrono::steady_clock::time_point deadline);

private:
    void read(std::chrono::steady_clock::time_point deadline);

    pid_t m_pid = -1;
    int m_to = -1;
    int m_from = -1;
    std::string m_received; // not yet a whole message
};

}
