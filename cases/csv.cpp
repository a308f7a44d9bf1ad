#include "cases/csv.hpp"

#include <algorithm>

#include "cases/words.hpp"

namespace tiretherm::cases {

namespace {

std::string_view unquoted(std::string_view field) {
    field = trim(field);
    return field.size() > 1 && field.front() == '"' && field.back() == '"' ? trim(field.substr(1, field.size() - 2))
                                                                           : field;
}

/// Which separator the headings use; a comma when there is only one heading.
char separator_of(std::string_view headings) {
    for (const char candidate : {'\t', ';'}) {
        if (headings.find(candidate) != std::string_view::npos) {
            return candidate;
        }
    }
    return ',';
}

int count_characters(std::string_view text) { return static_cast<int>(split_characters(text).size()); }

}  // namespace

std::optional<std::string_view> next_line(std::string_view& text) {
    if (text.empty()) {
        return std::nullopt;
    }
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) {
        line.remove_suffix(1);
    }
    return line;
}

void Csv::split(std::string_view line, std::vector<std::string_view>& fields) const {
    fields.clear();
    while (true) {
        const std::size_t end = std::min(line.find(separator_), line.size());
        fields.push_back(unquoted(line.substr(0, end)));
        if (end == line.size()) {
            return;
        }
        line.remove_prefix(end + 1);
    }
}

Place Csv::place(const Line& line, std::string_view field) const {
    const std::string_view before = line.text.substr(0, static_cast<std::size_t>(field.data() - line.text.data()));
    return {.file = file_,
            .line = line.number,
            .column = count_characters(before) + 1,
            .length = std::max(1, count_characters(field))};
}

std::optional<Csv> Csv::open(const TextFile& file, Mistakes& mistakes) {
    Csv csv;
    csv.file_ = file.number;
    csv.body_ = file.text;
    if (csv.body_.starts_with("\xEF\xBB\xBF")) {
        csv.body_.remove_prefix(3);
    }
    Line head;
    while (trim(head.text).empty()) {
        head = {next_line(csv.body_).value_or(""), head.number + 1};
    }
    csv.first_line_ = head.number + 1;
    csv.separator_ = separator_of(head.text);
    std::vector<std::string_view> fields;
    csv.split(head.text, fields);
    for (const std::string_view field : fields) {
        csv.heads_.push_back({read_heading(field), csv.place(head, field)});
    }
    if (leading_number(fields.front())) {
        mistakes.add(csv.heads_.front().place, "the first line holds numbers; it must name the columns",
                     "write a first line such as time [s],speed [km/h]");
        return std::nullopt;
    }
    return csv;
}

int Csv::find(std::string_view name) const {
    const auto found =
        std::find_if(heads_.begin(), heads_.end(), [&](const Head& head) { return head.heading.name == name; });
    return found == heads_.end() ? -1 : static_cast<int>(found - heads_.begin());
}

}  // namespace tiretherm::cases
