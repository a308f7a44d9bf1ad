// SPDX-License-Identifier: BSD-3-Clause
// Follows a path folder by folder and takes the nearest name where one is missing.

#include "input/files/nearby_file.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

/// The name in a folder that is nearest to a missing one; empty when none is near.
std::string nearest_in(const fs::path& folder, const std::string& name, bool wants_folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unknown;
        if (entry->is_directory(unknown) == wants_folder) {
            names.push_back(entry->path().filename().string());
        }
    }
    std::ranges::sort(names);  // a folder is listed in any order
    const auto with_ending = std::ranges::find_if(names, [&](const std::string& known) {
        return !name.empty() && !wants_folder && fs::path(known).stem() == name;
    });
    return with_ending != names.end() ? *with_ending : nearest(name, names);
}

}  // namespace

fs::path nearby_file(const fs::path& path) {
    std::error_code error;
    if (path.empty() || fs::exists(path, error)) {
        return {};
    }
    fs::path found;
    for (auto part = path.begin(); part != path.end(); ++part) {
        const bool is_last = std::next(part) == path.end();
        if (fs::exists(found / *part, error)) {
            found /= *part;
            continue;
        }
        const std::string name = nearest_in(found, part->string(), !is_last);
        if (name.empty()) {
            return {};
        }
        found /= name;
    }
    return found;
}

std::string nearby_file_remedy(const fs::path& path) {
    const fs::path near = nearby_file(path);
    return near.empty() ? std::string() : fmt::format("did you mean `{}`?", near.generic_string());
}

}  // namespace tiretherm::input
