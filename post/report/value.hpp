// SPDX-License-Identifier: BSD-3-Clause
// Data of a result as programs read it: the tree that JSON is made from.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace tiretherm::post {

/// Nothing, a truth value, a number, a text, a list, or an object whose members keep their order.
/// A number that is not finite becomes null in JSON.
class Value {
public:
    struct Member;
    using List = std::vector<Value>;
    /// What makes and ends it is in value.cpp, where Member is complete: the C++ standard asks for that.
    struct Object {
        Object();
        explicit Object(std::vector<Member> all);
        Object(const Object& other);
        Object(Object&& other) noexcept;
        Object& operator=(const Object& other);
        Object& operator=(Object&& other) noexcept;
        ~Object();

        std::vector<Member> members;
    };
    using Held = std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Object>;

    // Implicit, so that a list of members reads like the JSON it becomes.
    Value() = default;
    Value(std::same_as<bool> auto truth) : held_(truth) {}
    template <std::integral T>
    requires(!std::same_as<T, bool>) Value(T whole) : held_(static_cast<std::int64_t>(whole)) {}
    Value(double number) : held_(number) {}
    Value(std::string text) : held_(std::move(text)) {}
    Value(std::string_view text) : held_(std::string(text)) {}
    Value(const char* text) : held_(std::string(text)) {}
    Value(List list) : held_(std::move(list)) {}
    Value(Object object) : held_(std::move(object)) {}
    Value(std::initializer_list<Member> members);
    template <typename T>
    requires(!std::same_as<T, Value>) Value(const std::vector<T>& items) : held_(List(items.begin(), items.end())) {}
    template <typename T>
    Value(const std::optional<T>& known) : Value(known ? Value(*known) : Value()) {}

    /// Appends a member. @pre an object or nothing
    void set(std::string key, Value value);
    /// Appends the members of another object. @pre both are objects or nothing
    void set(const Value& object);
    /// A member; nothing where there is none.
    [[nodiscard]] const Value& operator[](std::string_view key) const;
    [[nodiscard]] const Held& held() const { return held_; }

private:
    Held held_;
};

struct Value::Member {
    std::string key;
    Value value;
};

/// A text; null where it is empty.
[[nodiscard]] Value text_or_null(std::string_view text);
/// Something that may not be: a member of what follows, null where it has no meaning.
[[nodiscard]] Value where(bool known, Value value);

/// As JSON, indented by two blanks.  @returns lines, each ended by a newline
[[nodiscard]] std::string json_text(const Value& value);
/// As JSON in one line, without blanks.
[[nodiscard]] std::string compact_json(const Value& value);

}  // namespace tiretherm::post
