// SPDX-License-Identifier: BSD-3-Clause
// Fingerprint of all that a run depends on, so that a study need not repeat runs that have not changed.
#pragma once

#include <map>
#include <string>

#include "input/toml/document.hpp"

namespace tiretherm::input {

/// What a run is made from, in sixteen digits: two runs of equal fingerprints have equal results.
class Fingerprints {
public:
    /// Over all that a case says, without its title, sources and measured numbers, and the content of the files that it
    /// names. Comments, layout and the division into included files do not count.
    /// @param document merged  @param errors knows the names of its files
    [[nodiscard]] std::string of(const TomlValue& document, const InputErrors& errors);

private:
    /// Of a file's content; empty where no file is called that.
    const std::string& of_file(const std::string& path);
    void spell(const TomlValue& node, const InputErrors& errors, std::string& into);

    std::map<std::string, std::string> files_;
};

}  // namespace tiretherm::input
