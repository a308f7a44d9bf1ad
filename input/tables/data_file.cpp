// SPDX-License-Identifier: BSD-3-Clause
// Chooses CSV or HDF5 by the name of the file and passes the calls on.

#include "input/tables/data_file.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "input/text/regular_file.hpp"

namespace tiretherm::input {

namespace {

bool is_hdf5(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".h5" || ending == ".hdf5";
}

}  // namespace

std::optional<DataFile> DataFile::open(const std::filesystem::path& path, const SourceLocation& mentioned,
                                       InputErrors& errors) {
    return with_memory(path.generic_string(), mentioned, errors, [&] { return open_any(path, mentioned, errors); });
}

std::optional<DataFile> DataFile::open_any(const std::filesystem::path& path, const SourceLocation& mentioned,
                                           InputErrors& errors) {
    DataFile file;
    if (is_hdf5(path)) {
        std::optional<Hdf5Columns> columns = Hdf5Columns::open(path, mentioned, errors);
        if (!columns) {
            return std::nullopt;
        }
        file.number_ = columns->number();
        file.columns_ = std::move(*columns);
        return file;
    }
    std::optional<TextFile> text = read_text(path, mentioned, errors);
    if (!text) {
        return std::nullopt;
    }
    file.text_ = std::make_unique<TextFile>(std::move(*text));
    file.number_ = file.text_->number;
    std::optional<Csv> csv = Csv::open(*file.text_, errors);
    if (!csv) {
        return std::nullopt;
    }
    file.columns_ = std::move(*csv);
    return file;
}

const std::vector<ColumnHead>& DataFile::heads() const {
    return std::visit([](const auto& columns) -> const std::vector<ColumnHead>& { return columns.heads(); }, columns_);
}

std::vector<ColumnHead>& DataFile::heads() {
    return std::visit([](auto& columns) -> std::vector<ColumnHead>& { return columns.heads(); }, columns_);
}

std::string DataFile::unit_remedy(const ColumnHead& head, const QuantitySpec& spec) const {
    const std::string example = dimension(spec.unit, spec.scale).example;
    const std::size_t blank = example.find(' ');
    const std::string unit = blank == std::string::npos ? std::string(spec.unit) : example.substr(blank + 1);
    const std::string& name = head.heading.name;
    const bool bare =
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos;
    const std::string key = bare ? name : fmt::format("\"{}\"", name);
    const std::string there = std::holds_alternative<Csv>(columns_)
                                  ? fmt::format("write \"{} [{}]\"", name, unit)
                                  : fmt::format("give the dataset an attribute units = \"{}\"", unit);
    // A logger that writes C writes it in all columns.
    const std::string written = head.heading.unit.value_or("");
    const auto read = written.empty() ? std::variant<Conversion, UnitError>(Conversion{})
                                      : conversion(written, spec.unit, spec.scale);
    const auto* wrong = std::get_if<UnitError>(&read);
    const bool coulomb = signature(spec.unit) == "K" && (written == "C" || written == "F");
    const bool alias = wrong != nullptr && (coulomb || *wrong == UnitError::unknown);
    const std::string for_all =
        alias ? fmt::format(", or once for all columns in [{0}]: unit_names = {{ \"{0}\" = \"{1}\" }}", written,
                            coulomb && written == "F" ? "degF" : unit)
              : "";
    return fmt::format("{}, or say it in the case: units = {{ {} = \"{}\" }}{}", there, key, unit, for_all);
}

ColumnReader::FieldLocation DataFile::spot(std::size_t row) const {
    if (const Csv* csv = std::get_if<Csv>(&columns_)) {
        return {.place = csv->row(row)};
    }
    return {.place = {.file = number_}, .aside = fmt::format(" (value {})", row + 1)};
}

std::vector<std::vector<double>> DataFile::read(const std::vector<ColumnRequest>& requests, InputErrors& errors) const {
    return with_memory(errors.file(number_), {.file = number_}, errors, [&] {
        return std::visit([&](const auto& columns) { return columns.read(requests, errors); }, columns_);
    });
}

}  // namespace tiretherm::input
