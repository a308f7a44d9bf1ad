// SPDX-License-Identifier: BSD-3-Clause
// Reads files while a KeyRecord listens.
#include <atomic>
#include <fstream>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "input/measurements/experiment.hpp"
#include "input/reference/case_keys.hpp"
#include "input/studies/study.hpp"
#include "input/toml/document.hpp"
#include "input/validation/validation.hpp"

namespace tiretherm::input {

namespace fs = std::filesystem;

namespace {

/// A folder of made-up files, gone when it goes.
class Folder {
public:
    Folder() {
        static std::atomic<int> count{0};
        path_ = fs::temp_directory_path() / fmt::format("tiretherm_keys_{}_{}", ::getpid(), count++);
        fs::create_directories(path_);
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    fs::path add(const MadeUpFile& file) const {
        fs::path path = path_ / file.name;
        std::ofstream(path) << file.text;
        return path;
    }

private:
    fs::path path_;
};

void read(const fs::path& file) {
    InputErrors errors;
    const std::optional<TomlValue> document = read_document(file, errors);
    if (!document) {
        return;
    }
    if (document->find("number") != nullptr) {
        static_cast<void>(read_validation(file));
    } else if (document->find("case") != nullptr) {
        static_cast<void>(read_study(file));
    } else {
        static_cast<void>(read_experiment(file, {}, ReadMode::measured));
    }
}

}  // namespace

std::vector<KeyUse> keys_asked(const std::vector<fs::path>& files) {
    const Folder folder;
    std::vector<fs::path> all = files;
    if (files.empty()) {
        for (const MadeUpFile& file : files_of_every_kind()) {
            all.push_back(folder.add(file));
        }
    }
    const KeyRecord record;
    for (const fs::path& file : all) {
        read(file);
    }
    return record.uses();
}

}  // namespace tiretherm::input
