#include "gui/trace_loop.h"
#include "submission/submission.h"
#include "submission/tree_folder.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gui {

namespace fs = std::filesystem;

TraceLoop::TraceLoop(Exchange& exchange, fs::path submission)
    : m_exchange(exchange)
    , m_folder(std::move(submission))
    , m_watched(m_folder)
{
}

void TraceLoop::run(const std::stop_token& stop)
{
    while (!stop.stop_requested()) {
        takeWanted();
        if (m_watched.hasChanged()) {
            m_program.clear();
            m_isHopeless = false;
        }
        try {
            work();
        } catch (const std::exception& error) { // worker::Failure, an exception of the submission, a bad scene
            giveUp(error.what());
        }
        waitForWork(stop);
    }
}

// Something else may be wanted at any time; files are looked at in between.
void TraceLoop::waitForWork(const std::stop_token& stop)
{
    constexpr std::chrono::milliseconds interval { 200 };
    const bool isBusy = !m_wanted.isPaused && m_refinement && !m_refinement->isDone();
    std::unique_lock lock(m_exchange.mutex);
    m_exchange.changed.wait_for(lock, stop, isBusy ? std::chrono::milliseconds(0) : interval, [&] {
        const Wanted& now = m_exchange.wanted;
        return now.number != m_wanted.number || now.isPaused != m_wanted.isPaused || now.pixel
            || now.tree != m_wanted.tree;
    });
}

void TraceLoop::takeWanted()
{
    const std::lock_guard lock(m_exchange.mutex);
    const bool isNew = m_exchange.wanted.number != m_wanted.number;
    if (isNew || m_exchange.wanted.tree != m_wanted.tree)
        m_isHopeless = false;
    m_wanted = m_exchange.wanted;
    m_exchange.wanted.pixel.reset();
    if (isNew)
        m_refinement.reset();
}

void TraceLoop::work()
{
    if (m_wanted.scene.empty() || m_isHopeless)
        return;
    if (m_program.empty())
        build();
    if (!m_process || m_openScene != m_wanted.scene
        || m_isOpenWithSah != m_wanted.view.features.extra.enableBvhSahBinning)
        open();
    if (m_wanted.pixel)
        follow(*std::exchange(m_wanted.pixel, std::nullopt));
    if (m_drawnTree != m_wanted.tree)
        drawTree();
    refine();
}

void TraceLoop::build()
{
    say("building " + m_folder.string());
    m_process.reset();
    m_refinement.reset();
    submission::Submission submission { m_folder };
    m_program = submission.buildWholeWorker();
    m_warning.clear();
    for (const std::string& name : submission.names())
        if (const submission::Part& part = submission.part(name); part.state == submission::State::Refused)
            m_warning += name + ".cpp is left out. " + part.message;
    m_unwritten.clear();
    say(warnings());
}

// What the one before has printed is still to be seen.
void TraceLoop::startWorker()
{
    worker::Limits limits;
    limits.captureOutput = true;
    limits.readable = { "/" }; // a scene names its meshes and textures wherever they lie
    limits.treeFolder = submission::treeFolder(m_folder);
    m_process.emplace(m_program, limits);
    const std::lock_guard lock(m_exchange.mutex);
    if (m_exchange.output)
        m_exchange.printed += m_exchange.output->take();
    m_exchange.output = m_process->output();
}

void TraceLoop::open()
{
    startWorker();
    m_openScene = m_wanted.scene;
    m_isOpenWithSah = m_wanted.view.features.extra.enableBvhSahBinning;
    m_drawnTree.reset();
    ask<void>("view.open", worker::OpenRequest { m_openScene.string(), m_isOpenWithSah });
    say(warnings()); // why the last one failed is over
}

void TraceLoop::refine()
{
    if (m_wanted.isPaused)
        return;
    if (!m_refinement)
        m_refinement.emplace(m_wanted);
    if (m_refinement->isDone())
        return;
    m_refinement->add(ask<worker::Rows>("view.rows", m_refinement->next()));
    const std::lock_guard lock(m_exchange.mutex);
    m_exchange.picture = m_refinement->picture();
}

void TraceLoop::follow(glm::ivec2 pixel)
{
    auto ray = ask<worker::DebugRay>("view.follow", worker::FollowRequest { m_wanted.view, pixel });
    const std::lock_guard lock(m_exchange.mutex);
    m_exchange.ray = std::move(ray);
}

void TraceLoop::drawTree()
{
    auto tree = ask<worker::TreeDrawing>("view.tree", m_wanted.tree);
    m_drawnTree = m_wanted.tree;
    const std::lock_guard lock(m_exchange.mutex);
    m_exchange.tree = std::move(tree);
}

template <typename Result, typename Request> Result TraceLoop::ask(const std::string& probe, const Request& request)
{
    constexpr std::chrono::seconds patience { 5 }; // for rows that are asked for a thirtieth of a second
    worker::Message input;
    input << request;
    const worker::Answer answer = m_process->ask(probe, input, patience);
    noteUnwritten(answer.unwritten);
    if constexpr (!std::is_void_v<Result>) {
        worker::Reader reader { answer.output };
        return reader.read<Result>();
    }
}

void TraceLoop::giveUp(const std::string& message)
{
    m_isHopeless = true;
    m_process.reset();
    m_refinement.reset();
    say(warnings() + message);
}

// A worker tells of each once.
void TraceLoop::noteUnwritten(const std::vector<std::string>& functions)
{
    if (functions.empty())
        return;
    m_unwritten.insert(functions.begin(), functions.end());
    say(warnings());
}

std::string TraceLoop::warnings() const
{
    if (m_unwritten.empty())
        return m_warning;
    return fmt::format("{}not written yet: {}\n", m_warning, fmt::join(m_unwritten, ", "));
}

void TraceLoop::say(const std::string& message)
{
    const std::lock_guard lock(m_exchange.mutex);
    m_exchange.message = message;
}

}
