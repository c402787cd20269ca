#pragma once
#include "app/progress_bar.h"
#include "worker/process.h"

namespace app {

// A submission's worker, which reads a scene's meshes and textures wherever they lie.
class Renderer {
public:
    // with: whose code, as in submission::namedFolder. Says on stderr which of its files do not compile. Throws
    // files::Error when there is no such folder.
    explicit Renderer(const std::string& with);

    // Result: what the probe answers. Throws worker::Failure and worker::ProbeError.
    template <typename Result, typename Request> Result ask(const std::string& probe, const Request& request)
    {
        constexpr std::chrono::hours patience { 24 * 365 }; // whoever waits can interrupt
        worker::Message input;
        input << request;
        const struct Bar {
            ~Bar() { clearProgressBar(); } // also before what went wrong is told
        } bar;
        const worker::Answer answer = m_process.ask(probe, input, patience, drawProgressBar);
        worker::Reader reader { answer.output };
        return reader.read<Result>();
    }

private:
    worker::Process m_process;
};

}
