// SPDX-License-Identifier: BSD-3-Clause
// Chooses HDF5 by the name of the file, binary logs by their first bytes, a table of probes by its headings, other text
// otherwise, and passes the calls on.

#include "input/tables/data_file.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "input/loggers/binary_logs.hpp"
#include "input/loggers/logger_units.hpp"
#include "input/text/enough_memory.hpp"
#include "input/text/regular_file.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

bool is_hdf5(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".h5" || ending == ".hdf5";
}

/// The first bytes of a file; empty for one that cannot be read, or is too large: `read_foreign_text` says so.
std::string first_bytes_of(const std::filesystem::path& path) {
    if (!not_readable(path, largest_text).what.empty()) {
        return {};
    }
    std::ifstream stream(path, std::ios::binary);
    std::string first(first_bytes_of_log, '\0');
    stream.read(first.data(), static_cast<std::streamsize>(first.size()));
    first.resize(static_cast<std::size_t>(stream.gcount()));
    return first;
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
    const std::string first = first_bytes_of(path);
    if (const BinaryLog* log = find_binary_log(first)) {
        std::ifstream stream(path, std::ios::binary);
        std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
        file.number_ = errors.add_file(path.generic_string(), "");
        std::optional<ChannelTable> table = log->read(std::move(bytes), path, file.number_, errors);
        if (!table) {
            return std::nullopt;
        }
        file.columns_ = std::move(*table);
        return file;
    }
    if (ErrorText unread = first.empty() ? ErrorText{} : unread_log(path, first); !unread.what.empty()) {
        const bool is_argument = mentioned.file < 0;
        const SourceLocation place =
            is_argument ? SourceLocation{.file = errors.add_file(path.generic_string(), "")} : mentioned;
        const std::string name = is_argument ? "" : path.generic_string() + " ";
        errors.add(place, fmt::format("the file {}{}", name, unread.what), std::move(unread.remedy));
        return std::nullopt;
    }
    const std::optional<TextFile> text = read_foreign_text(path, mentioned, errors);
    if (!text) {
        return std::nullopt;
    }
    file.number_ = text->number;
    file.text_ = errors.text(file.number_);
    if (std::optional<ProbeTable> table = ProbeTable::find(*text)) {
        file.columns_ = std::move(*table);
        return file;
    }
    std::optional<Csv> csv = Csv::open(*text, errors);
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

int DataFile::find(std::string_view name) const {
    const auto found = std::ranges::find_if(heads(), [&](const ColumnHead& head) { return head.heading.name == name; });
    return found == heads().end() ? -1 : static_cast<int>(found - heads().begin());
}

const LogDescription& DataFile::description() const {
    static const LogDescription of_hdf5{.format = "HDF5"};
    static const LogDescription of_probes{.format = "table of probes"};
    if (const Csv* csv = std::get_if<Csv>(&columns_)) {
        return csv->description();
    }
    if (std::holds_alternative<ProbeTable>(columns_)) {
        return of_probes;
    }
    const ChannelTable* table = channel_table();
    return table != nullptr ? table->description() : of_hdf5;
}

void DataFile::choose_rows(const std::vector<int>& columns) {
    if (ChannelTable* table = std::get_if<ChannelTable>(&columns_)) {
        table->choose(columns);
    }
}

std::string DataFile::unit_remedy(const ColumnHead& head, const QuantitySpec& spec) const {
    const std::string example = dimension(spec.unit, spec.scale).example;
    const std::size_t blank = example.find(' ');
    const std::string written = head.heading.unit.value_or("");
    if (std::string absolute = absolute_pressure_remedy(written, spec); !absolute.empty()) {
        return absolute;
    }
    const std::string guess = guess_unit(written, spec.unit, spec.scale);
    const std::string unit = !guess.empty()               ? guess
                             : blank == std::string::npos ? std::string(spec.unit)
                                                          : example.substr(blank + 1);
    const std::string& name = head.heading.name;
    const std::string key = toml_text::key(name);
    const std::string there =
        text_ != nullptr ? fmt::format("write \"{} [{}]\", or say it in the case: ", name, unit)
        : std::holds_alternative<Hdf5Columns>(columns_)
            ? fmt::format("give the dataset an attribute units = \"{}\", or say it in the case: ", unit)
            : std::string("say it in the case: ");
    // A logger that writes C writes it in all columns.
    const auto read = written.empty() ? std::variant<Conversion, UnitError>(Conversion{})
                                      : conversion(written, spec.unit, spec.scale);
    const auto* wrong = std::get_if<UnitError>(&read);
    const bool alias = wrong != nullptr && *wrong == UnitError::unknown;
    const std::string for_all =
        alias ? fmt::format(", or once for all columns in [{0}]: unit_names = {{ \"{0}\" = \"{1}\" }}", written, unit)
              : "";
    // What is written may be any other unit: taken for the usual one it would make the numbers wrong.
    const std::string where = written.empty() || !guess.empty() ? ""
                              : spec.is_pure()                  ? "if it is a pure number, "
                                                                : fmt::format("if its numbers are in {}, ", unit);
    return fmt::format("{}{}units = {{ {} = \"{}\" }}{}", where, there, key, unit, for_all);
}

ColumnReader::FieldLocation DataFile::spot(std::size_t row) const {
    if (const Csv* csv = std::get_if<Csv>(&columns_)) {
        return {.place = csv->row(row)};
    }
    if (const auto* table = std::get_if<ProbeTable>(&columns_)) {
        return {.place = table->row(row)};
    }
    return {.place = {.file = number_}, .aside = fmt::format(" (value {})", row + 1)};
}

void DataFile::parse_all() const {
    if (const Csv* csv = std::get_if<Csv>(&columns_)) {
        csv->parse_all();
    }
}

std::vector<std::vector<double>> DataFile::read(const std::vector<ColumnRequest>& requests, InputErrors& errors,
                                                bool last) const {
    return with_memory(errors.file(number_), {.file = number_}, errors, [&] {
        return std::visit(
            [&](const auto& columns) {
                if constexpr (std::is_same_v<decltype(columns), const Csv&>) {
                    return columns.read(requests, errors, last);
                } else {
                    return columns.read(requests, errors);
                }
            },
            columns_);
    });
}

}  // namespace tiretherm::input
