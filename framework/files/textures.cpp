#include "files/textures.h"
#include "files/picture.h"

namespace files {

const Image* Textures::load(const std::filesystem::path& path)
{
    std::error_code failed; // leaves the key empty; openPicture then says what is wrong with the file
    const Image*& image = m_loaded[std::filesystem::weakly_canonical(path, failed)];
    if (image == nullptr || failed) {
        m_scene.textures.push_back(openPicture(path));
        image = m_scene.textures.back().get();
    }
    return image;
}

}
