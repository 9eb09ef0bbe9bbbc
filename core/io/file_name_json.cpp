#include "core/io/file_name_json.h"

#include <fmt/format.h>

#include <cctype>

namespace texloom {

namespace {

constexpr const char* kBytes = "Bytes";

bool isUtf8(const std::string& text) {
    try {
        const std::string ignored = JsonField::Json(text).dump();
        return true;
    } catch (const JsonField::Json::exception&) {
        return false;
    }
}

std::string hexadecimal(const std::string& bytes) {
    std::string text;
    for (const char byte : bytes)
        text += fmt::format("{:02x}", static_cast<unsigned char>(byte));
    return text;
}

std::string bytesFrom(const JsonField& field) {
    const std::string text = field.text();
    std::string bytes;
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
        if (std::isxdigit(static_cast<unsigned char>(text[i])) == 0 ||
            std::isxdigit(static_cast<unsigned char>(text[i + 1])) == 0)
            field.wrong(TR("bytes in hexadecimal"));
        bytes += static_cast<char>(std::stoi(text.substr(i, 2), nullptr, 16));
    }
    if (text.size() % 2 != 0)
        field.wrong(TR("bytes in hexadecimal, two digits each"));
    return bytes;
}

} // namespace

void putFileName(JsonField::Json& object, const std::string& key, const std::filesystem::path& name) {
    const std::string text = name.generic_string();
    object[key] = text;
    if (!isUtf8(text))
        object[key + kBytes] = hexadecimal(text);
}

std::filesystem::path fileNameFrom(const JsonField& object, const std::string& key) {
    const JsonField field = object.at(object.has(key + kBytes) ? key + kBytes : key);
    const std::string name = object.has(key + kBytes) ? bytesFrom(field) : field.text();
    if (name.empty())
        field.wrong(TR("the name of a file"));
    if (name.find('\0') != std::string::npos)
        field.wrong(TR("text without a zero byte"));
    return name;
}

} // namespace texloom
