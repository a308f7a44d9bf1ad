// SPDX-License-Identifier: BSD-3-Clause
// Walks through values and errors.

#include "python/extension/values.hpp"

#include <type_traits>
#include <variant>

namespace tiretherm::python {

namespace py = pybind11;

py::object object_of(const post::Value& value) {
    return std::visit(
        [](const auto& held) -> py::object {
            using Held = std::decay_t<decltype(held)>;
            if constexpr (std::is_same_v<Held, std::monostate>) {
                return py::none();
            } else if constexpr (std::is_same_v<Held, post::Value::List>) {
                py::list list;
                for (const post::Value& item : held) {
                    list.append(object_of(item));
                }
                return list;
            } else if constexpr (std::is_same_v<Held, post::Value::Object>) {
                py::dict dict;
                for (const post::Value::Member& member : held.members) {
                    dict[py::str(member.key)] = object_of(member.value);
                }
                return dict;
            } else {
                return py::cast(held);
            }
        },
        value.held());
}

py::list findings_of(const std::vector<input::InputError>& errors) {
    py::list findings;
    for (const input::InputError& error : errors) {
        py::dict finding;
        finding["code"] = error.code == input::ErrorCode::missing_input ? "missing_input" : "other";
        finding["message"] = error.what;
        finding["file"] = error.file;
        finding["line"] = error.line;
        finding["column"] = error.column;
        finding["remedy"] = error.remedy;
        finding["source"] = error.source;
        findings.append(std::move(finding));
    }
    return findings;
}

}  // namespace tiretherm::python
