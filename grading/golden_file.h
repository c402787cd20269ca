#pragma once
#include "grading/expected.h"
#include <filesystem>
#include <map>
#include <mutex>

namespace grading {

using Answers = std::map<std::string, worker::Message>; // by keyOf

// Answers from a file that was recorded before; no reference is needed.
class GoldenFile : public ExpectedAnswers {
public:
    // Throws files::Error when it is no such file.
    explicit GoldenFile(std::filesystem::path file);

    [[nodiscard]] worker::Message answer(const std::string& probe, const worker::Message& input) override;
    [[nodiscard]] std::string version() const override { return m_version; }

private:
    std::string m_version; // of the file: a digest
    std::filesystem::path m_file;
    Answers m_answers;
};

// Passes questions on, and keeps the answers for such a file.
class Recorder : public ExpectedAnswers {
public:
    explicit Recorder(ExpectedAnswers& source)
        : m_source(source)
    {
    }

    [[nodiscard]] worker::Message answer(const std::string& probe, const worker::Message& input) override;
    [[nodiscard]] std::string version() const override { return m_source.version(); }
    [[nodiscard]] bool wantsAll() const override { return true; }

    // Throws std::runtime_error when it cannot be written.
    void write(const std::filesystem::path& file) const;

private:
    ExpectedAnswers& m_source;
    std::mutex m_mutex; // of what follows
    Answers m_answers;
};

}
