#pragma once
#include "gui/refinement.h"
#include "submission/watched_folder.h"
#include "worker/process.h"
#include <set>
#include <stop_token>

namespace gui {

// What a tracer's thread does: keeps a worker that has the wanted scene open, and refines the picture of the wanted
// view. A worker that fails says why, and is not started again until something else is wanted or the submission
// changes.
class TraceLoop {
public:
    TraceLoop(Exchange& exchange, std::filesystem::path submission);

    void run(const std::stop_token& stop);

private:
    void waitForWork(const std::stop_token& stop);
    void takeWanted();
    void work();
    void build();
    void open();
    void startWorker();
    void refine();
    void follow(glm::ivec2 pixel);
    void drawTree();
    void giveUp(const std::string& message);
    void noteUnwritten(const std::vector<std::string>& functions);
    void say(const std::string& message);
    [[nodiscard]] std::string warnings() const;

    template <typename Result, typename Request> Result ask(const std::string& probe, const Request& request);

    Exchange& m_exchange;
    std::filesystem::path m_folder;
    submission::WatchedFolder m_watched;
    std::filesystem::path m_program; // empty: to be built
    std::optional<worker::Process> m_process;
    std::filesystem::path m_openScene; // of the process
    bool m_isOpenWithSah = false;
    std::optional<worker::TreeRequest> m_drawnTree; // of the process
    Wanted m_wanted;
    std::optional<Refinement> m_refinement;
    bool m_isHopeless = false; // what is wanted: it failed
    std::string m_warning; // of the build
    std::set<std::string> m_unwritten; // functions of the submission that were called and are not there
};

}
