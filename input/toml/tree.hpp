// SPDX-License-Identifier: BSD-3-Clause
// Values of a document by the keys that lead to them: to be found, written and taken away.
#pragma once

#include <string>
#include <vector>

#include "input/toml/document.hpp"

namespace tiretherm::input {

/// The keys from the root of a document to one of its values, each with the place that messages about it show. In a list whose
/// tables have names, the name is the key: "material", "tread rubber", "density".
using TomlPath = std::vector<LocatedString>;

/// Splits a text at its dots, those within a name of the document's lists excepted.
[[nodiscard]] TomlPath split_path(const LocatedString& text, const TomlValue& document);
/// The first `n` keys of a path with dots between them.
[[nodiscard]] std::string joined(const TomlPath& path, std::size_t n);

/// The value at the path, null where the document does not give it.
[[nodiscard]] const TomlValue* find(const TomlValue& document, const TomlPath& path);
/// Writes a value at the path. Tables that are missing are made, as if the user had written the value there: whether
/// a key exists is for the reader of the case to say, and it says so at the key's place in the path.
/// @returns false after an error: the path meets a value, ends at a table, or names what its list does not have
bool set(TomlValue& document, const TomlPath& path, const TomlValue& value, InputErrors& errors);
/// Takes the value at the path away: what the key `unset` does to the files that a case includes. An error where there is none.
/// @param path as the user has written it
void unset(TomlValue& document, const LocatedString& path, InputErrors& errors);

}  // namespace tiretherm::input
