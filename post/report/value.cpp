// SPDX-License-Identifier: BSD-3-Clause
// The data of a result and how JSON is written from it.
#include "post/report/value.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace tiretherm::post {

namespace {

using Json = nlohmann::ordered_json;

struct ToJson {
    Json operator()(std::monostate) const { return {}; }
    Json operator()(const Value::List& list) const {
        Json json = Json::array();
        for (const Value& item : list) {
            json.push_back(std::visit(*this, item.held()));
        }
        return json;
    }
    Json operator()(const Value::Object& object) const {
        Json json = Json::object();
        for (const Value::Member& member : object.members) {
            json[member.key] = std::visit(*this, member.value.held());
        }
        return json;
    }
    Json operator()(const auto& scalar) const { return scalar; }
};

}  // namespace

Value::Object::Object() = default;
Value::Object::Object(std::vector<Member> all) : members(std::move(all)) {}
Value::Object::Object(const Object& other) = default;
Value::Object::Object(Object&& other) noexcept = default;
Value::Object& Value::Object::operator=(const Object& other) = default;
Value::Object& Value::Object::operator=(Object&& other) noexcept = default;
Value::Object::~Object() = default;

Value::Value(std::initializer_list<Member> members) : held_(Object{std::vector<Member>(members)}) {}

void Value::set(std::string key, Value value) {
    if (std::holds_alternative<std::monostate>(held_)) {
        held_ = Object{};
    }
    std::get<Object>(held_).members.push_back({std::move(key), std::move(value)});
}

void Value::set(const Value& object) {
    for (const Member& member : std::get<Object>(object.held_).members) {
        set(member.key, member.value);
    }
}

const Value& Value::operator[](std::string_view key) const {
    static const Value nothing;
    if (const auto* object = std::get_if<Object>(&held_)) {
        const auto found = std::ranges::find(object->members, key, &Member::key);
        return found == object->members.end() ? nothing : found->value;
    }
    return nothing;
}

Value text_or_null(std::string_view text) { return where(!text.empty(), text); }

Value where(bool known, Value value) { return known ? std::move(value) : Value(); }

std::string json_text(const Value& value) {
    return std::visit(ToJson(), value.held()).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string compact_json(const Value& value) {
    return std::visit(ToJson(), value.held()).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tiretherm::post
