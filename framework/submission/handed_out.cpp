#include "submission/handed_out.h"
#include "files/digest.h"
#include <map>

namespace submission {

// Of student/<name>.cpp. When what students get is to be another, a test says what belongs here. Of a solution that is
// written into that folder it belongs nowhere: it would not be graded.
static const std::map<std::string, std::string> digests {
    { "bvh", "46d3011df7af11279d52bca1e34a33f4cd6d4091" },
    { "interpolate", "bc0ff67e3e138b75bdec9e89c181141af88e99aa" },
    { "light", "e88a2b9fafe2fe017faf235ae8e5e27427f98071" },
    { "recursive", "327dc162da1b7dc297c8b9fc22d09ac8c179b819" },
    { "render", "6740797dea3cfe56f9913c06de1705622ef702da" },
    { "shading", "1cf26beae1ceefaea086dc91844e6dcd01dc3b5d" },
    { "texture", "5dfe17bb01f18e57a0f4f1bf9cce651ca395d052" },
};

bool isAsHandedOut(const std::string& name, const std::string& text)
{
    const auto found = digests.find(name);
    return found != digests.end() && found->second == files::Digest().add(text).hex();
}

}
