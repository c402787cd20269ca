#include "app/renderer.h"
#include "submission/named_folder.h"
#include "submission/submission.h"
#include "submission/tree_folder.h"
#include "values/resident_memory.h"
#include <fmt/core.h>

namespace app {
namespace {

    std::filesystem::path build(const std::string& with)
    {
        submission::Submission submission { submission::namedFolder(with) };
        std::filesystem::path worker = submission.buildWholeWorker();
        for (const std::string& name : submission.names())
            if (const submission::Part& part = submission.part(name); part.state == submission::State::Refused)
                fmt::print(stderr, "{}.cpp is left out. {}", name, part.message);
        return worker;
    }

    worker::Limits limits(const std::string& with)
    {
        worker::Limits limits;
        limits.captureOutput = false;
        limits.answerBytes = std::size_t(16) << 30; // a picture of 32768 x 32768 pixels has 12 GiB
        limits.memoryBytes = values::availableMemory(); // beyond it, asking for more fails, which can be told
        limits.readable = { "/" };
        limits.treeFolder = submission::treeFolder(submission::namedFolder(with));
        return limits;
    }

}

Renderer::Renderer(const std::string& with)
    : m_process(build(with), limits(with))
{
}

}
