#pragma once
#include "worker/message.h"
#include <chrono>
#include <cstdint>

namespace worker {

using Clock = std::chrono::steady_clock;

// One message on its way. The nonce ties an answer to its request.
struct Frame {
    enum class Kind : uint32_t { Request, Progress, Answer, Failure };

    uint64_t nonce = 0;
    Kind kind = Kind::Request;
    Message message;
};

// The file descriptor that a worker is started with.
inline constexpr int socketOfWorker = 3;

enum class Transfer { Done, Closed, TimedOut, TooLarge };

// Sends a frame over a stream socket, or gives up at the deadline.
[[nodiscard]] Transfer sendFrame(int socket, const Frame& frame, Clock::time_point deadline);

// Receives a frame of at most maxBytes, or gives up at the deadline.
[[nodiscard]] Transfer receiveFrame(int socket, Frame& frame, std::size_t maxBytes, Clock::time_point deadline);

}
