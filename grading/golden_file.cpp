#include "grading/golden_file.h"
#include "files/digest.h"
#include "files/error.h"
#include "grading/sealed_file.h"

namespace grading {

GoldenFile::GoldenFile(std::filesystem::path file)
    : m_version(files::Digest().addFile(file).hex())
    , m_file(std::move(file))
{
    const std::optional<worker::Message> whole = readSealed(m_file);
    if (!whole)
        throw files::Error(m_file, "found no answers, expected a file that --record wrote");
    worker::Reader reader { *whole };
    for (auto left = reader.read<std::size_t>(); left > 0; --left) {
        const auto key = reader.read<std::string>();
        m_answers.emplace(key, worker::Message(reader.read<std::vector<std::byte>>()));
    }
}

worker::Message GoldenFile::answer(const std::string& probe, const worker::Message& input)
{
    const auto found = m_answers.find(keyOf(probe, input));
    if (found == m_answers.end())
        throw std::runtime_error(m_file.string() + ": found no answer of " + probe
            + " to a question, expected that of this version's scenes and checks: record the file again");
    return found->second;
}

worker::Message Recorder::answer(const std::string& probe, const worker::Message& input)
{
    worker::Message answer = m_source.answer(probe, input);
    const std::lock_guard lock(m_mutex);
    m_answers.insert_or_assign(keyOf(probe, input), answer);
    return answer;
}

void Recorder::write(const std::filesystem::path& file) const
{
    worker::Message whole;
    whole << m_answers.size();
    for (const auto& [key, answer] : m_answers)
        whole << key << std::vector<std::byte>(answer.bytes().begin(), answer.bytes().end());
    writeSealed(file, whole);
}

}
