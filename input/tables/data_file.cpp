// SPDX-License-Identifier: BSD-3-Clause
// Reads the file's table where nobody has yet, and its columns into SI values.

#include "input/tables/data_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "input/clock/clock_times.hpp"
#include "input/files/enough_memory.hpp"
#include "input/files/regular_file.hpp"
#include "input/loggers/binary_logs.hpp"
#include "input/loggers/logger_units.hpp"
#include "input/tables/channel_rows.hpp"
#include "input/tables/csv.hpp"
#include "input/tables/dead_codes.hpp"
#include "input/tables/hdf5_datasets.hpp"
#include "input/tables/probe_table.hpp"
#include "input/text/characters.hpp"
#include "input/text/source_text.hpp"
#include "input/text/table_shelf.hpp"
#include "input/toml/document.hpp"
#include "input/toml/toml_text.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t most_errors = 500;                  // of a file; who made it reads no more
constexpr std::size_t most_values_at_once = 300'000'000;  // 2.4 GB

bool is_hdf5(const std::filesystem::path& path) {
    const std::string ending = in_small_letters(path.extension().string());
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

/// HDF5 is known by the name of the file, a binary log by its first bytes, a table of probes by its headings; other text is a CSV.
std::shared_ptr<const LogTable> read_table(const std::filesystem::path& path, const SourceLocation& mentioned,
                                           InputErrors& errors) {
    InputErrors found;
    int number = found.add_file(path.generic_string(), "");
    std::optional<LogTable> table;
    const std::string first = is_hdf5(path) ? std::string() : first_bytes_of(path);
    ErrorText defect = is_hdf5(path) ? hdf5_defect(path) : ErrorText{};
    const BinaryLog* log = find_binary_log(first);
    if (log == nullptr && !first.empty()) {
        defect = unread_log(path, first);
    }
    if (!defect.what.empty()) {
        refuse_file(path, mentioned, std::move(defect), errors);
        return nullptr;
    }
    if (is_hdf5(path)) {
        table = read_hdf5_columns(path, found);
    } else if (log != nullptr) {
        std::ifstream stream(path, std::ios::binary);
        table = log->read(std::string(std::istreambuf_iterator<char>(stream), {}), path, found);
    } else {
        const std::optional<TextFile> file = read_foreign_text(path, mentioned, errors);
        if (!file) {
            return nullptr;
        }
        const std::shared_ptr<const SourceText> text = errors.text(file->number);
        table = find_probe_table(text);
        table = table ? std::move(table) : read_csv(text, found);
        number = file->number;
        if (!table) {
            errors.take(found, number);
            return nullptr;
        }
    }
    if (!table) {
        errors.take(found, errors.add_file(path.generic_string(), ""));
        return nullptr;
    }
    table->remarks = std::move(found);
    return std::make_shared<const LogTable>(std::move(*table));
}

/// The table of a file, which is read where it stands on no shelf.
std::shared_ptr<const LogTable> table_of(const std::filesystem::path& path, const SourceLocation& mentioned,
                                         InputErrors& errors) {
    std::error_code ignored;
    const std::string key = std::filesystem::absolute(path, ignored).lexically_normal().string();
    TableShelf& shelf = errors.tables();
    const std::lock_guard lock(shelf.reading);
    const auto known = shelf.tables.find(key);
    if (known != shelf.tables.end()) {
        return known->second;
    }
    std::shared_ptr<const LogTable> table = read_table(path, mentioned, errors);
    if (table != nullptr) {
        ++shelf.files_read;
        shelf.tables.emplace(key, table);
    }
    return table;
}

/// Numbers with decimal commas beside numbers with points. @param marks of some columns, the first of each
void report_both_marks(const DecimalMark& comma, const DecimalMark& point, int file, InputErrors& errors) {
    if (comma.place.line == 0 || point.place.line == 0) {
        return;
    }
    const bool comma_is_later = comma.place.line > point.place.line;
    const DecimalMark& later = comma_is_later ? comma : point;
    const DecimalMark& first = comma_is_later ? point : comma;
    SourceLocation place = later.place;
    place.file = file;
    errors.add(place,
               fmt::format("\"{}\" has a decimal {}, \"{}\" in line {} a decimal {}", later.field,
                           comma_is_later ? "comma" : "point", first.field, first.place.line,
                           comma_is_later ? "point" : "comma"),
               "export the file with one of them, and without marks between thousands");
}

void take_earlier(DecimalMark& earliest, const DecimalMark& mark) {
    if (mark.place.line > 0 && (earliest.place.line == 0 || mark.place.line < earliest.place.line)) {
        earliest = mark;
    }
}

}  // namespace

std::optional<DataFile> DataFile::open(const std::filesystem::path& path, const SourceLocation& mentioned,
                                       InputErrors& errors) {
    const std::string shown = path.generic_string();
    return with_memory(shown, mentioned, errors, [&]() -> std::optional<DataFile> {
        DataFile file;
        file.table_ = table_of(path, mentioned, errors);
        if (file.table_ == nullptr) {
            return std::nullopt;
        }
        file.number_ = errors.add_table(shown, *file.table_, file.table_->text);
        errors.take(file.table_->remarks, file.number_);
        for (const TableColumn& column : file.table_->columns) {
            ColumnHead& head = file.heads_.emplace_back(column.head);
            head.place.file = file.number_;
            head.unit_place.file = head.unit_place.file < 0 ? -1 : file.number_;
        }
        file.choose_rows({});
        return file;
    });
}

int DataFile::find(std::string_view name) const {
    const auto found = std::ranges::find_if(heads_, [&](const ColumnHead& head) { return head.heading.name == name; });
    return found == heads_.end() ? -1 : static_cast<int>(found - heads_.begin());
}

void DataFile::choose_rows(const std::vector<int>& columns) {
    if (table_->has_own_clocks()) {
        times_ = row_times(*table_, columns);
    }
}

void DataFile::take_times(std::vector<double> times) {
    times_ = std::move(times);
    heads_.front().heading = {"time", "s"};
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
        table_->units == LogTable::Units::in_headings
            ? fmt::format("write \"{} [{}]\", or say it in the case: ", name, unit)
        : table_->units == LogTable::Units::in_attributes
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

ColumnRequest DataFile::request(int column, std::string name, const QuantitySpec& spec, Purpose purpose) const {
    return {.column = column,
            .name = std::move(name),
            .spec = spec,
            .purpose = purpose,
            .unit_remedy = unit_remedy(heads_[static_cast<std::size_t>(column)], spec)};
}

FieldLocation DataFile::spot(std::size_t row, int column, double written) const {
    if (table_->has_own_clocks()) {
        return {.place = {.file = number_}, .aside = fmt::format(" (at {:.6g} s)", times_[row])};
    }
    FieldLocation found = table_->where(row, column);
    found.place.file = number_;
    if (column == 0 && !times_.empty()) {
        found.text = fmt::format("{:.10g}", written);
    }
    return found;
}

const std::vector<double>& DataFile::numbers_of(const ColumnRequest& request, std::vector<double>& room,
                                                InputErrors& errors) const {
    const TableColumn& column = table_->columns[static_cast<std::size_t>(request.column)];
    const ColumnHead& head = heads_[static_cast<std::size_t>(request.column)];
    const bool is_time = request.purpose == Purpose::clock;
    if (request.column == 0 && !times_.empty()) {
        return times_;
    }
    if (column.rate > 0.0) {
        room = in_rows(column, times_);
        return room;
    }
    if (head.form != FieldForm::number) {
        const bool is_picture = request.purpose == Purpose::frame || request.purpose == Purpose::point;
        ClockTimes found = clock_times(column.stamp, head.form, head.heading, !is_picture);
        for (const std::string& remark : is_time ? found.remarks : std::vector<std::string>{}) {
            errors.warn(head.place, remark);
        }
        if (is_time && found.question) {
            errors.add(head.place, std::move(*found.question));
        }
        room = std::move(found.seconds);
        return room;
    }
    if (!is_time || !is_text()) {
        return column.number;
    }
    // Of numbers, two at one time are a jump and three a mistake, unless the clock is too coarse for all the lines.
    constexpr std::size_t least = 3;
    constexpr std::size_t looked_at = 5000;  // lines, before all are
    room.assign(column.number.begin(),
                column.number.begin() + static_cast<std::ptrdiff_t>(std::min(looked_at, column.number.size())));
    if (share_out(room, least).empty()) {
        return column.number;
    }
    room = column.number;
    if (const std::string remark = share_out(room, least); !remark.empty()) {
        errors.warn(head.place, "{}: {}", head.heading.name, remark);
    }
    return room;
}

std::vector<double> DataFile::read_column(const ColumnRequest& request, InputErrors& errors) const {
    const TableColumn& column = table_->columns[static_cast<std::size_t>(request.column)];
    ColumnReader reader(heads_[static_cast<std::size_t>(request.column)], request, errors);
    std::vector<double> room;
    const std::vector<double>& numbers = numbers_of(request, room, errors);
    const DeadCodes dead(numbers, heads_[static_cast<std::size_t>(request.column)], request);
    if (!dead.sentence.empty()) {
        errors.warn(heads_[static_cast<std::size_t>(request.column)].place, dead.sentence);
    }
    reader.values.reserve(numbers.size());
    auto text = column.text.begin();
    for (std::size_t row = 0; row < numbers.size(); ++row) {
        const bool is_unread = text != column.text.end() && *text == row;
        text += is_unread ? 1 : 0;
        const bool is_no_day =
            row < column.stamp.size() && !std::isnan(column.stamp[row].seconds) && std::isnan(numbers[row]);
        const double written = dead.has(numbers[row]) ? std::nan("") : numbers[row];
        reader.take(written, !is_unread && !is_no_day, [&] { return spot(row, request.column, written); });
    }
    reader.close();
    return std::move(reader.values);
}

std::vector<std::vector<double>> DataFile::read(const std::vector<ColumnRequest>& requests, InputErrors& errors) const {
    return with_memory(errors.file(number_), {.file = number_}, errors, [&] { return read_columns(requests, errors); });
}

std::vector<std::vector<double>> DataFile::read_columns(const std::vector<ColumnRequest>& requests,
                                                        InputErrors& errors) const {
    const std::size_t before = errors.count();
    errors.take(table_->defects, number_);
    if (requests.size() > most_values_at_once / std::max<std::size_t>(times_.size(), 1)) {
        errors.add({.file = number_},
                   fmt::format("{} channels at {} times are more values than are read at once ({:.0e})",
                               requests.size(), times_.size(), static_cast<double>(most_values_at_once)),
                   "export a part of the session, or fewer channels");
        return {};
    }
    std::vector<std::vector<double>> values;
    DecimalMark comma;
    DecimalMark point;
    for (const ColumnRequest& request : requests) {
        if (errors.count() > before + most_errors) {
            errors.add({.file = number_}, fmt::format("after {} errors the file is read no further", most_errors),
                       "correct those first");
            break;
        }
        values.push_back(read_column(request, errors));
        if (request.purpose != Purpose::unused) {
            take_earlier(comma, table_->columns[static_cast<std::size_t>(request.column)].comma);
            take_earlier(point, table_->columns[static_cast<std::size_t>(request.column)].point);
        }
    }
    report_both_marks(comma, point, number_, errors);
    if (errors.count() != before) {
        return {};
    }
    return values;  // moved, which ? : would not do
}

DataFile::Samples DataFile::samples(int column, const std::vector<double>& time, const InputErrors& errors) const {
    if (const TableColumn& channel = table_->columns[static_cast<std::size_t>(column)]; channel.rate > 0.0) {
        Samples own{.time = {}, .value = channel.number};
        for (std::size_t k = 0; k < own.value.size(); ++k) {
            own.time.push_back(static_cast<double>(k) / channel.rate);
        }
        return own;
    }
    InputErrors unheard = errors;
    std::vector<std::vector<double>> values =
        read({{.column = column, .name = "", .spec = {.unit = "1"}, .purpose = Purpose::unused}}, unheard);
    const bool is_whole = !values.empty() && values.front().size() == time.size();
    return is_whole ? Samples{.time = time, .value = std::move(values.front())} : Samples{};
}

}  // namespace tiretherm::input
