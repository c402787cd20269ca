#pragma once
#include "grading/expected.h"
#include <filesystem>

namespace grading {

// Answers by a worker that is started for the question, and remembers them in a folder for the next grade. Any number
// of graders may share the folder; a file in it that is not whole counts as none.
class LiveReference : public ExpectedAnswers {
public:
    // The folder is made. If it holds many answers, the oldest go.
    LiveReference(std::filesystem::path worker, std::filesystem::path folder);

    [[nodiscard]] worker::Message answer(const std::string& probe, const worker::Message& input) override;
    [[nodiscard]] std::string version() const override { return m_version; }

private:
    [[nodiscard]] worker::Message ask(const std::string& probe, const worker::Message& input) const;

    std::filesystem::path m_worker;
    std::filesystem::path m_folder;
    std::string m_version; // of the worker: a digest
};

}
