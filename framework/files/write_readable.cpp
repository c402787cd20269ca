#include "files/write_readable.h"
#include "files/error.h"
#include "files/text.h"
#include "files/toml_text.h"

namespace files {

void writeReadable(const std::filesystem::path& to, const TomlValue::Table& document,
    const std::function<void(const TomlValue&)>& read)
{
    const std::string text = tomlText(document);
    try {
        read(parseToml(to, text));
    } catch (const Error& error) {
        throw Error(to, std::string("not written, since it could not be read: ") + error.what());
    }
    writeText(to, text);
}

}
