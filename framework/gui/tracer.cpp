#include "gui/tracer.h"
#include "gui/trace_loop.h"
#include <utility>

namespace gui {

Tracer::Tracer(const std::filesystem::path& submission)
    : m_thread([this, submission](const std::stop_token& stop) { TraceLoop(m_exchange, submission).run(stop); })
{
}

uint64_t Tracer::show(const std::filesystem::path& scene, const worker::View& view)
{
    const std::lock_guard lock(m_exchange.mutex);
    m_exchange.wanted.scene = scene;
    m_exchange.wanted.view = view;
    m_exchange.changed.notify_one();
    return ++m_exchange.wanted.number;
}

void Tracer::follow(glm::ivec2 pixel)
{
    const std::lock_guard lock(m_exchange.mutex);
    m_exchange.wanted.pixel = pixel;
    m_exchange.changed.notify_one();
}

void Tracer::drawTree(const worker::TreeRequest& request)
{
    const std::lock_guard lock(m_exchange.mutex);
    m_exchange.wanted.tree = request;
    m_exchange.changed.notify_one();
}

void Tracer::setPaused(bool isPaused)
{
    const std::lock_guard lock(m_exchange.mutex);
    m_exchange.wanted.isPaused = isPaused;
    m_exchange.changed.notify_one();
}

std::optional<Picture> Tracer::takePicture()
{
    const std::lock_guard lock(m_exchange.mutex);
    return std::exchange(m_exchange.picture, std::nullopt);
}

std::optional<worker::DebugRay> Tracer::takeRay()
{
    const std::lock_guard lock(m_exchange.mutex);
    return std::exchange(m_exchange.ray, std::nullopt);
}

std::optional<worker::TreeDrawing> Tracer::takeTree()
{
    const std::lock_guard lock(m_exchange.mutex);
    return std::exchange(m_exchange.tree, std::nullopt);
}

std::string Tracer::takePrinted()
{
    const std::lock_guard lock(m_exchange.mutex);
    std::string printed = std::exchange(m_exchange.printed, "");
    return m_exchange.output ? printed + m_exchange.output->take() : printed;
}

std::string Tracer::message()
{
    const std::lock_guard lock(m_exchange.mutex);
    return m_exchange.message;
}

}
