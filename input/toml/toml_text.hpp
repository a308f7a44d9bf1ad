// SPDX-License-Identifier: BSD-3-Clause
// Writing TOML: values as the reader of cases takes them, and whole documents.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/toml/document.hpp"

/// Pieces of a TOML text as the reader of cases takes them. Numbers have all their digits.
namespace tiretherm::input::toml_text {

/// "a \"b\"" with its quotation marks.
[[nodiscard]] std::string in_quotes(std::string_view text);
/// A key, quoted where it must be.
[[nodiscard]] std::string key(std::string_view key);
/// A pure number, or "12.5 W m-1 K-1" with its quotation marks. @param value in the unit
[[nodiscard]] std::string quantity(double value, std::string_view unit);
/// A value of a case as it was written, in one line.
[[nodiscard]] std::string value(const TomlValue& node);
/// A case as a file has it: values, then a heading with its lines for each table and each table of a list. Tables that
/// are marked as standing in braces are values.
[[nodiscard]] std::string document(const TomlValue& root);

/// Values of a document that is going to be written.
[[nodiscard]] TomlValue text_value(std::string text);
[[nodiscard]] TomlValue boolean_value(bool truth);
/// @param value in the unit; "1": a pure number
[[nodiscard]] TomlValue quantity_value(double value, std::string_view unit);
/// "90 degC" where that is exactly the temperature, otherwise in kelvin. @param kelvin K
[[nodiscard]] TomlValue temperature_value(double kelvin);
/// A file as a text in a folder names it: from there, or whole where no way leads there.
[[nodiscard]] TomlValue path_value(const std::filesystem::path& file, const std::filesystem::path& folder);
[[nodiscard]] TomlValue list_value(std::vector<TomlValue> items);
[[nodiscard]] TomlValue texts_value(const std::vector<std::string>& texts);
/// A table in braces.
[[nodiscard]] TomlValue table_value(std::vector<std::pair<std::string, TomlValue>> entries = {});

}  // namespace tiretherm::input::toml_text
