// A process that runs a submission's functions for somebody who does not trust them: worker [FOLDER FOR TREES]. It
// answers requests on one socket until that is closed; nothing else that the submission does matters to the other side.
#include "accel/kept_trees.h"
#include "values/unwritten.h"
#include "worker/frame.h"
#include "worker/probe.h"
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

namespace {

constexpr auto never = worker::Clock::time_point::max();
constexpr std::size_t unlimited = static_cast<std::size_t>(-1); // the parent is trusted

worker::Frame failure(const worker::Frame& request, const std::string& what)
{
    worker::Message message;
    message << what;
    return { request.nonce, worker::Frame::Kind::Failure, std::move(message) };
}

worker::Frame answer(const worker::Frame& request, const std::function<void(float)>& progress)
{
    using Kind = worker::Frame::Kind;
    try {
        worker::Reader input { request.message };
        const auto probe = input.read<std::string>();
        const worker::Probe::Function function = worker::Probe::find(probe);
        if (!function)
            throw std::invalid_argument("no probe is called " + probe);
        worker::Message output;
        worker::Call call { input, output, progress };
        function(call);
        worker::Message whole;
        whole << values::takeUnwritten();
        whole.append(output.bytes().data(), output.bytes().size());
        return { request.nonce, Kind::Answer, std::move(whole) };
    } catch (const std::bad_alloc&) {
        return failure(request, "there is too little memory for this: a smaller scene or picture takes less");
    } catch (const std::exception& error) {
        return failure(request, error.what());
    }
}

}

int main(int argc, char** argv)
{
    if (argc > 1)
        accel::keepTreesIn(argv[1]);
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ); // of a crash, all lines before it are known
    worker::Frame request;
    while (worker::receiveFrame(worker::socketOfWorker, request, unlimited, never) == worker::Transfer::Done) {
        const auto progress = [&](float fraction) {
            worker::Message message;
            message << fraction;
            (void)worker::sendFrame(
                worker::socketOfWorker, { request.nonce, worker::Frame::Kind::Progress, message }, never);
        };
        const worker::Frame reply = answer(request, progress);
        std::cout.flush(); // a buffer of its own, if it is not synchronised
        std::fflush(stdout);
        if (worker::sendFrame(worker::socketOfWorker, reply, never) != worker::Transfer::Done)
            return 1;
    }
    return 0;
}
