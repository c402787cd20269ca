#include "worker/probe.h"
#include <map>

namespace worker {
namespace {

    std::map<std::string, Probe::Function>& probes()
    {
        static std::map<std::string, Probe::Function> map; // first use may be before main
        return map;
    }

}

Probe::Probe(std::string name, Function function)
{
    probes().emplace(std::move(name), function);
}

Probe::Function Probe::find(const std::string& name)
{
    const auto found = probes().find(name);
    return found == probes().end() ? nullptr : found->second;
}

}
