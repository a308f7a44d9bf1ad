// SPDX-License-Identifier: BSD-3-Clause
// Writes the document and the contents of its files into one text and hashes it with FNV-1a, 64 bit.

#include "input/studies/study_fingerprint.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

/// FNV-1a, 64 bit (G. Fowler, L. C. Noll, K.-P. Vo). Against an accident, not against ill will.
std::uint64_t hash(std::string_view text) {
    std::uint64_t value = 0xcbf29ce484222325U;
    for (const char c : text) {
        value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    }
    return value;
}

}  // namespace

const std::string& Fingerprints::of_file(const std::string& path) {
    const auto [place, is_new] = files_.try_emplace(path);
    std::error_code error;
    if (is_new && std::filesystem::is_regular_file(path, error)) {
        std::ifstream file(path, std::ios::binary);
        const std::string content{std::istreambuf_iterator<char>(file), {}};
        place->second = fmt::format("{:016x}", hash(content));
    }
    return place->second;
}

void Fingerprints::spell(const TomlValue& node, const InputErrors& errors, std::string& into) {
    switch (node.kind) {
        case TomlValue::Kind::nothing:
        case TomlValue::Kind::date:
            into += '?';
            break;
        case TomlValue::Kind::text: {
            into += fmt::format("t{}:{}", node.text.size(), node.text);
            // Whichever key it stands at: a path is taken from the folder of the file where it is written.
            if (node.place.file >= 0 && node.text.size() < 1000 && !node.text.empty()) {
                into += of_file(errors.beside(node.place, node.text).string());
            }
            break;
        }
        case TomlValue::Kind::integer:
        case TomlValue::Kind::real:
            into += fmt::format("n{:a}", node.number);
            break;
        case TomlValue::Kind::boolean:
            into += node.truth ? "b1" : "b0";
            break;
        case TomlValue::Kind::array:
            into += '[';
            for (const TomlValue& item : node.items) {
                spell(item, errors, into);
                into += ',';
            }
            into += ']';
            break;
        case TomlValue::Kind::table:
            into += '{';
            for (const Entry& entry : node.entries) {
                into += fmt::format("{}:{}=", entry.key.size(), entry.key);
                spell(entry.value, errors, into);
            }
            into += '}';
            break;
    }
}

std::string Fingerprints::of(const TomlValue& document, const InputErrors& errors) {
    constexpr std::array<std::string_view, 4> words{"title", "sources", "measured", "pyrometer"};
    std::string text;
    for (const Entry& entry : document.entries) {
        if (std::find(words.begin(), words.end(), entry.key) == words.end()) {
            text += fmt::format("{}:{}=", entry.key.size(), entry.key);
            spell(entry.value, errors, text);
        }
    }
    return fmt::format("{:016x}", hash(text));
}

}  // namespace tiretherm::input
