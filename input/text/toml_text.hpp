#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "input/text/document.hpp"

/// Pieces of a TOML text as the reader of cases takes them. Numbers have all their digits.
namespace tiretherm::input::toml_text {

/// "a \"b\"" with its quotation marks.
[[nodiscard]] std::string in_quotes(std::string_view text);
/// A key, quoted where it must be.
[[nodiscard]] std::string key(std::string_view key);
/// A pure number, or "12.5 W m-1 K-1" with its quotation marks. @param value in the unit
[[nodiscard]] std::string quantity(double value, std::string_view unit);
/// "90 degC" where that is exactly the temperature, otherwise in kelvin. @param kelvin K
[[nodiscard]] std::string temperature(double kelvin);
/// A value of a case as it was written, in one line.
[[nodiscard]] std::string value(const TomlValue& node);
/// A file as a text in a folder names it: from there, or whole where no way leads there.
[[nodiscard]] std::string path(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace tiretherm::input::toml_text
