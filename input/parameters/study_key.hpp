#pragma once

#include "input/text/document.hpp"
#include "input/text/toml_table.hpp"

namespace tiretherm::input {

/// Writes a value into a case where a path of keys leads: "drive.speed", "effects.air_convection.lambda_h",
/// "mesh.layer.tread.thickness" or "material.tread rubber.density" for lists whose tables have names. Tables that are
/// missing are made, as if the user had written the value there: whether a key exists is for the reader of the case to
/// say, and it says so at the key's place in the path.
/// @param path as written, with its place  @param value with the place that messages about it show
/// @returns false after an error: the path meets a value, or a table that is not in its list
bool write_at(TomlValue& document, const LocatedString& path, const TomlValue& value, InputErrors& errors);

/// The value to which such a path leads, null where the case does not say it.
[[nodiscard]] const TomlValue* find_at(const TomlValue& document, const LocatedString& path);

}  // namespace tiretherm::input
