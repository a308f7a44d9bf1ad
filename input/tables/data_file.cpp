#include "input/tables/data_file.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

bool is_hdf5(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".h5" || ending == ".hdf5";
}

}  // namespace

std::optional<DataFile> DataFile::open(const std::filesystem::path& path, const Place& mentioned, Mistakes& mistakes) {
    DataFile file;
    if (is_hdf5(path)) {
        std::optional<Hdf5Columns> columns = Hdf5Columns::open(path, mentioned, mistakes);
        if (!columns) {
            return std::nullopt;
        }
        file.number_ = columns->number();
        file.columns_ = std::move(*columns);
        return file;
    }
    std::optional<TextFile> text = read_text(path, mentioned, mistakes);
    if (!text) {
        return std::nullopt;
    }
    file.text_ = std::make_unique<TextFile>(std::move(*text));
    file.number_ = file.text_->number;
    std::optional<Csv> csv = Csv::open(*file.text_, mistakes);
    if (!csv) {
        return std::nullopt;
    }
    file.columns_ = std::move(*csv);
    return file;
}

const std::vector<Head>& DataFile::heads() const {
    return std::visit([](const auto& columns) -> const std::vector<Head>& { return columns.heads(); }, columns_);
}

std::vector<Head>& DataFile::heads() {
    return std::visit([](auto& columns) -> std::vector<Head>& { return columns.heads(); }, columns_);
}

std::string DataFile::unit_remedy(const Head& head, const Wanted& wanted) const {
    const std::string example = dimension(wanted.unit, wanted.scale).example;
    const std::size_t blank = example.find(' ');
    const std::string unit = blank == std::string::npos ? std::string(wanted.unit) : example.substr(blank + 1);
    const std::string& name = head.heading.name;
    const bool bare =
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos;
    const std::string key = bare ? name : fmt::format("\"{}\"", name);
    const std::string there = std::holds_alternative<Csv>(columns_)
                                  ? fmt::format("write \"{} [{}]\"", name, unit)
                                  : fmt::format("give the dataset an attribute units = \"{}\"", unit);
    return fmt::format("{}, or say it in the case: units = {{ {} = \"{}\" }}", there, key, unit);
}

ColumnReader::Spot DataFile::spot(std::size_t row) const {
    if (const Csv* csv = std::get_if<Csv>(&columns_)) {
        return {.place = csv->row(row)};
    }
    return {.place = {.file = number_}, .aside = fmt::format(" (value {})", row + 1)};
}

std::vector<std::vector<double>> DataFile::read(const std::vector<ColumnRequest>& requests, Mistakes& mistakes) const {
    return std::visit([&](const auto& columns) { return columns.read(requests, mistakes); }, columns_);
}

}  // namespace tiretherm::input
