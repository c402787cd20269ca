#include "worker/frame.h"
#include <algorithm>
#include <cerrno>
#include <poll.h>
#include <sys/socket.h>

namespace worker {
namespace {

    struct Header {
        uint64_t nonce;
        uint32_t kind;
        uint32_t reserved;
        uint64_t size; // bytes that follow
    };

    // Waits until the socket can be read or written. At time_point::max() waits for ever.
    Transfer waitFor(int socket, short events, Clock::time_point deadline)
    {
        for (;;) {
            int timeout = -1;
            if (deadline != Clock::time_point::max()) {
                const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
                if (left <= 0)
                    return Transfer::TimedOut;
                timeout = static_cast<int>(std::min<long>(left, 60'000));
            }
            pollfd poller { socket, events, 0 };
            const int ready = poll(&poller, 1, timeout);
            if (ready > 0)
                return Transfer::Done;
            if (ready < 0 && errno != EINTR)
                return Transfer::Closed;
        }
    }

    Transfer sendBytes(int socket, std::span<const std::byte> bytes, Clock::time_point deadline)
    {
        while (!bytes.empty()) {
            if (const Transfer ready = waitFor(socket, POLLOUT, deadline); ready != Transfer::Done)
                return ready;
            const ssize_t sent = send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
            if (sent > 0)
                bytes = bytes.subspan(static_cast<std::size_t>(sent));
            else if (sent < 0 && errno != EAGAIN && errno != EINTR)
                return Transfer::Closed;
        }
        return Transfer::Done;
    }

    Transfer receiveBytes(int socket, std::span<std::byte> bytes, Clock::time_point deadline)
    {
        while (!bytes.empty()) {
            if (const Transfer ready = waitFor(socket, POLLIN, deadline); ready != Transfer::Done)
                return ready;
            const ssize_t received = recv(socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
            if (received > 0)
                bytes = bytes.subspan(static_cast<std::size_t>(received));
            else if (received == 0 || (errno != EAGAIN && errno != EINTR))
                return Transfer::Closed;
        }
        return Transfer::Done;
    }

}

Transfer sendFrame(int socket, const Frame& frame, Clock::time_point deadline)
{
    const auto bytes = frame.message.bytes();
    const Header header { frame.nonce, static_cast<uint32_t>(frame.kind), 0, bytes.size() };
    const Transfer sent = sendBytes(socket, std::as_bytes(std::span(&header, 1)), deadline);
    return sent == Transfer::Done ? sendBytes(socket, bytes, deadline) : sent;
}

Transfer receiveFrame(int socket, Frame& frame, std::size_t maxBytes, Clock::time_point deadline)
{
    Header header;
    const Transfer received = receiveBytes(socket, std::as_writable_bytes(std::span(&header, 1)), deadline);
    if (received != Transfer::Done)
        return received;
    if (header.size > maxBytes)
        return Transfer::TooLarge;
    constexpr std::size_t step = std::size_t(16) << 20; // memory is taken for what comes, not for what is announced
    std::vector<std::byte> bytes;
    while (bytes.size() < header.size) {
        const std::size_t before = bytes.size();
        bytes.resize(before + std::min<std::size_t>(header.size - before, step));
        if (const Transfer part = receiveBytes(socket, std::span(bytes).subspan(before), deadline);
            part != Transfer::Done)
            return part;
    }
    frame = { header.nonce, static_cast<Frame::Kind>(header.kind), Message(std::move(bytes)) };
    return Transfer::Done;
}

}
