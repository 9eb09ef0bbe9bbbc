#pragma once

#include "core/base/message.h"
#include "core/base/value.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// A value in a JSON document that someone may have written by hand, with the names by which messages call
/// it: the document ("recipe") and the path to the value ("exemplars[0].file"). Refers to the document; owns
/// nothing. Every function throws UsageError, with both names and the value, where the value is not what was
/// asked for.
class JsonField {
public:
    using Json = nlohmann::ordered_json;

    JsonField(Message document, const Json& json) : JsonField(std::move(document), json, {}) {}

    const Json& json() const { return m_json; }
    std::size_t size() const { return m_json.size(); }
    bool has(const std::string& key) const { return m_json.contains(key); }
    JsonField at(const std::string& key) const;
    JsonField at(std::size_t index) const;

    [[noreturn]] void wrong(const Message& expected) const;
    /// Refuses fields that are not among these.
    void only(const std::vector<std::string>& known) const;
    void needObject() const;
    void needArray(std::size_t least, std::size_t most) const;

    std::string text() const;
    int whole() const;
    /// A finite number.
    double number() const;
    /// A number, text, true or false.
    Value value() const;
    /// An object of such values.
    Values values() const;

private:
    JsonField(Message document, const Json& json, std::string name)
        : m_document(std::move(document)), m_json(json), m_name(std::move(name)) {}

    Message m_document;
    const Json& m_json;
    std::string m_name;
};

/// The text as JSON. @throws UsageError where it is none, holds numbers that are too large, or is nested too
/// deep.
JsonField::Json parseJson(const Message& document, std::string_view text);

JsonField::Json toJson(const Value& value);
JsonField::Json toJson(const Values& values);

} // namespace texloom
