// SPDX-License-Identifier: BSD-3-Clause
// Frames of a camera as a CSV: a row for each of them, a column for each pixel.
#include <algorithm>
#include <charconv>
#include <memory>
#include <numeric>

#include <fmt/format.h>

#include "input/cameras/frame_file.hpp"
#include "input/tables/data_file.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

constexpr int pixels_of_a_line = 100'000;  // in a row or a column of an image

/// Row and column of the pixel that a heading names: "r3c17".
std::optional<std::array<int, 2>> pixel_of(std::string_view name) {
    std::array<int, 2> place{};
    const char* at = name.data();
    const char* end = name.data() + name.size();
    for (const auto& [letter, number] : {std::pair{'r', &place[0]}, {'c', &place[1]}}) {
        if (at == end || *at != letter) {
            return std::nullopt;
        }
        const auto [after, error] = std::from_chars(at + 1, end, *number);
        if (error != std::errc() || *number < 0 || *number >= pixels_of_a_line) {
            return std::nullopt;
        }
        at = after;
    }
    return at == end ? std::optional(place) : std::nullopt;
}

/// The columns of a file of frames.
struct Columns {
    int time = -1;
    std::vector<std::array<int, 2>> place;
    std::vector<int> column;
    int rows = 0;
    int columns = 0;
};

Columns classify_columns(const DataFile& file, InputErrors& errors) {
    Columns found;
    for (std::size_t i = 0; i < file.heads().size(); ++i) {
        const ColumnHead& head = file.heads()[i];
        if (head.heading.name == "time") {
            found.time = static_cast<int>(i);
        } else if (const auto place = pixel_of(head.heading.name)) {
            found.place.push_back(*place);
            found.column.push_back(static_cast<int>(i));
            found.rows = std::max(found.rows, (*place)[0] + 1);
            found.columns = std::max(found.columns, (*place)[1] + 1);
        } else if (!head.heading.name.empty() || i + 1 < file.heads().size()) {
            errors.add(head.place, fmt::format("the column {} is neither time nor a pixel", head.heading.name),
                       "call pixels by row and column, r0c0 [degC], r0c1 [degC] ..., and the clock time [s]");
            return found;
        }
    }
    return found;
}

/// Every pixel once. @returns whether that is so
bool check_shape(const Columns& found, const DataFile& file, InputErrors& errors) {
    const std::string remedy = "give every pixel of the image one column";
    std::vector<std::size_t> order(found.place.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return found.place[k]; });
    for (std::size_t k = 1; k < order.size(); ++k) {
        const auto [row, column] = found.place[order[k]];
        if (found.place[order[k - 1]] == found.place[order[k]]) {
            errors.add(file.heads()[static_cast<std::size_t>(found.column[order[k]])].place,
                       fmt::format("the pixel r{}c{} has two columns", row, column), remedy);
            return false;
        }
    }
    const auto wanted = [&](std::size_t k) {
        const auto width = static_cast<std::size_t>(found.columns);
        return std::array{static_cast<int>(k / width), static_cast<int>(k % width)};
    };
    const std::size_t all = static_cast<std::size_t>(found.rows) * static_cast<std::size_t>(found.columns);
    std::size_t k = 0;
    while (k < order.size() && found.place[order[k]] == wanted(k)) {
        ++k;
    }
    if (k < all) {
        errors.add({.file = file.number()},
                   fmt::format("{} x {} pixels need {} columns, and there are {}: r{}c{} is missing", found.rows,
                               found.columns, all, found.place.size(), wanted(k)[0], wanted(k)[1]),
                   remedy);
        return false;
    }
    return true;
}

}  // namespace

std::optional<FrameFile> open_csv_frames(const std::filesystem::path& path, const SourceLocation& mentioned,
                                         InputErrors& errors) {
    const std::size_t before = errors.count();
    const std::optional<DataFile> file = DataFile::open(path, mentioned, errors);
    if (!file) {
        return std::nullopt;
    }
    const Columns found = classify_columns(*file, errors);
    if (errors.count() > before) {
        return std::nullopt;
    }
    if (found.time < 0 || found.place.empty()) {
        return errors.add({.file = file->number()},
                          found.time < 0 ? "the file has no column time" : "the file has no column of a pixel",
                          "write a column time [s] and one for each pixel, r0c0 [degC], r0c1 [degC] ...");
    }
    if (!check_shape(found, *file, errors)) {
        return std::nullopt;
    }
    std::vector<ColumnRequest> requests{
        {.column = found.time, .name = "time", .spec = quantity_specs::moment, .purpose = Purpose::clock}};
    for (std::size_t k = 0; k < found.place.size(); ++k) {
        requests.push_back({.column = found.column[k],
                            .name = file->heads()[static_cast<std::size_t>(found.column[k])].heading.name,
                            .spec = quantity_specs::temperature,
                            .purpose = Purpose::measured});
    }
    auto values = std::make_shared<std::vector<std::vector<double>>>(file->read(requests, errors));
    if (errors.count() > before || values->empty()) {
        return std::nullopt;
    }
    FrameFile frames{.number = file->number(),
                     .shown = path.generic_string(),
                     .rows = found.rows,
                     .columns = found.columns,
                     .time = values->front(),
                     .read = {}};
    frames.read = [values, places = found.place, columns = found.columns](std::size_t frame,
                                                                          std::vector<double>& kelvin) {
        kelvin.resize(places.size());
        for (std::size_t k = 0; k < places.size(); ++k) {
            kelvin[static_cast<std::size_t>(places[k][0] * columns + places[k][1])] = (*values)[k + 1][frame];
        }
        return true;
    };
    return frames;
}

}  // namespace tiretherm::input
