// SPDX-License-Identifier: BSD-3-Clause
// Reads camera frames from HDF5: dataset `frames` with its units and pixel size, dataset `time`; chooses between HDF5
// and CSV.

#include "input/cameras/frame_file.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/files/regular_file.hpp"
#include "input/tables/hdf5_datasets.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

constexpr const char* wanted_form =
    "write the images as frames [n, rows, columns], with the attribute units = \"degC\"";

constexpr std::size_t most_pixels = 100'000;  // in a row or a column of an image

/// Rows and columns of the images: dimensions of their own, or in attributes where each image is one long row.
std::optional<std::array<std::size_t, 2>> image_of(const Hdf5Stack& frames, int number, InputErrors& errors) {
    const std::vector<std::size_t>& shape = frames.shape();
    const std::vector<double> rows = frames.numbers("rows");
    const std::vector<double> columns = frames.numbers("columns");
    if (shape.size() == 3) {
        if (std::max(shape[1], shape[2]) > most_pixels) {
            return errors.add({.file = number},
                              fmt::format("an image has {} x {} pixels, and at most {} x {} are read", shape[1],
                                          shape[2], most_pixels, most_pixels),
                              wanted_form);
        }
        return std::array{shape[1], shape[2]};
    }
    if (shape.size() != 2 || rows.empty() || columns.empty()) {
        return errors.add(
            {.file = number},
            shape.size() == 2
                ? std::string("frames has two dimensions and no attributes rows and columns")
                : fmt::format("frames has {} dimension{}, not three", shape.size(), shape.size() == 1 ? "" : "s"),
            wanted_form);
    }
    const double pixels = rows.front() * columns.front();
    const auto counts = [](double size) { return size >= 1.0 && size == std::floor(size); };
    if (!counts(rows.front()) || !counts(columns.front()) || pixels != static_cast<double>(shape[1])) {
        return errors.add({.file = number},
                          fmt::format("an image of {:g} x {:g} pixels has {:g} values, and frames has {} in a row",
                                      rows.front(), columns.front(), pixels, shape[1]),
                          "correct the attributes rows and columns, or write three dimensions");
    }
    return std::array{static_cast<std::size_t>(rows.front()), static_cast<std::size_t>(columns.front())};
}

/// How an attribute's unit turns numbers into SI; a missing or wrong one is an error.
std::optional<Conversion> unit_of(const Hdf5Stack& stack, const std::string& dataset, const std::string& attribute,
                                  const QuantitySpec& spec, const std::string& example, int number,
                                  InputErrors& errors) {
    const std::string unit = stack.text(attribute);
    const std::string remedy =
        fmt::format("give the dataset {} the attribute {} = \"{}\"", dataset, attribute, example);
    if (unit.empty()) {
        return errors.add({.file = number}, fmt::format("the dataset {} has no attribute {}", dataset, attribute),
                          remedy);
    }
    const UnitRead read = read_unit(unit, spec, fmt::format("the dataset {} is in \"{}\"", dataset, unit));
    if (read.error) {
        return errors.add({.file = number}, read.error->what, remedy);
    }
    return read.conversion;
}

std::vector<double> read_time_settings(const std::filesystem::path& path, std::size_t frames, int number,
                                       InputErrors& errors) {
    ErrorText defect;
    const auto stack = Hdf5Stack::open(path, "time", defect);
    if (!defect.what.empty()) {
        errors.add({.file = number}, std::move(defect));
        return {};
    }
    if (!stack || stack->shape().size() != 1) {
        errors.add({.file = number},
                   stack ? fmt::format("the dataset time has {} dimensions, not one", stack->shape().size())
                         : "the file has no dataset time",
                   "write the moment of each frame as time [n], with the attribute units = \"s\"");
        return {};
    }
    const auto conversion = unit_of(*stack, "time", "units", quantity_specs::moment, "s", number, errors);
    if (stack->shape().front() != frames) {
        errors.add({.file = number}, fmt::format("time has {} values for {} frames", stack->shape().front(), frames),
                   "give each frame one moment");
        return {};
    }
    std::vector<double> time;
    std::vector<double> one;
    for (std::size_t i = 0; conversion && i < frames; ++i) {
        if (!stack->read(i, one)) {
            errors.add({.file = number}, "the dataset time cannot be read: the file is damaged or cut off",
                       "copy or export it again");
            return {};
        }
        time.push_back(conversion->to_si(one.front()));
    }
    return time;
}

std::optional<std::array<double, 2>> read_pixel_size(const Hdf5Stack& frames, int number, InputErrors& errors) {
    const std::vector<double> written = frames.numbers("pixel_size");
    if (written.empty()) {
        return std::nullopt;  // the case may say it
    }
    const auto conversion = unit_of(frames, "frames", "pixel_size_units", quantity_specs::length, "mm", number, errors);
    if (!conversion) {
        return std::nullopt;
    }
    const double x = conversion->to_si(written.front());
    const double y = conversion->to_si(written.size() > 1 ? written[1] : written.front());
    if (written.size() > 2 || !(x > 0.0) || !(y > 0.0)) {
        return errors.add(
            {.file = number},
            written.size() > 2 ? fmt::format("pixel_size has {} numbers", written.size()) : "pixel_size is not above 0",
            "give one number, or two: along a row and along a column");
    }
    return std::array{x, y};
}

}  // namespace

bool report_times_not_ascending(const std::vector<double>& time, int number, InputErrors& errors) {
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!std::isfinite(time[i])) {
            errors.add({.file = number}, fmt::format("the time of frame {} is not a number", i),
                       "give each frame one moment");
            return true;
        }
        if (i > 0 && !(time[i] > time[i - 1])) {
            errors.add({.file = number},
                       fmt::format("time goes back from frame {} ({:.6g} s) to frame {} ({:.6g} s)", i - 1, time[i - 1],
                                   i, time[i]),
                       "sort the frames by time, each moment once");
            return true;
        }
    }
    return false;
}

std::optional<FrameFile> open_hdf5_frames(const std::filesystem::path& path, int number, InputErrors& errors) {
    const std::size_t before = errors.count();
    const SourceLocation place{.file = number};
    ErrorText defect;
    auto stack = Hdf5Stack::open(path, "frames", defect);
    if (!stack) {
        return errors.add(place, defect.what.empty()
                                     ? ErrorText{"the file has no dataset frames of numbers", wanted_form}
                                     : std::move(defect));
    }
    const std::vector<std::size_t>& shape = stack->shape();
    const std::optional<std::array<std::size_t, 2>> image = image_of(*stack, number, errors);
    FrameFile file{.number = number, .shown = path.generic_string(), .time = {}, .read = {}};
    const auto conversion = unit_of(*stack, "frames", "units", quantity_specs::temperature, "degC", number, errors);
    file.pixel_size = read_pixel_size(*stack, number, errors);
    file.time = read_time_settings(path, shape.empty() ? 0 : shape.front(), number, errors);
    const bool bad_times = report_times_not_ascending(file.time, number, errors);
    if (image && shape[0] * (*image)[0] * (*image)[1] == 0) {
        errors.add(place, "frames is empty", wanted_form);
    }
    if (bad_times || errors.count() > before) {
        return std::nullopt;
    }
    file.rows = static_cast<int>((*image)[0]);
    file.columns = static_cast<int>((*image)[1]);
    file.read = [frames = std::move(*stack), scale = *conversion](std::size_t frame, std::vector<double>& kelvin) {
        if (!frames.read(frame, kelvin)) {
            return false;
        }
        for (double& value : kelvin) {
            value = scale.to_si(value);
        }
        return true;
    };
    return file;
}

std::optional<FrameFile> open_frames(const std::filesystem::path& path, const SourceLocation& mentioned,
                                     InputErrors& errors) {
    const std::string ending = path.extension().string();
    if (ending != ".h5" && ending != ".hdf5") {
        return open_csv_frames(path, mentioned, errors);
    }
    if (ErrorText error = hdf5_defect(path); !error.what.empty()) {
        refuse_file(path, mentioned, std::move(error), errors);
        return std::nullopt;
    }
    return open_hdf5_frames(path, errors.add_file(path.generic_string(), ""), errors);
}

}  // namespace tiretherm::input
