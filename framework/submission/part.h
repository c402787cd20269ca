#pragma once
#include <string>

namespace submission {

// How far a file of a submission got.
enum class State {
    Missing, // no such file: where a worker has all files, stubs stand in
    Taken, // read, and not compiled so far
    Built,
    Refused, // not a plain file, does not compile, or does not link
};

struct Part {
    State state = State::Missing;
    std::string message; // why it was refused: a compiler's or linker's words
    std::string undeclared; // where it defines functions that no header declares: helpers, or a changed signature
};

[[nodiscard]] inline Part refused(const std::string& message)
{
    return { State::Refused, message, "" };
}

}
