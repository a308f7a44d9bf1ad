// SPDX-License-Identifier: BSD-3-Clause
// Reads case or files, channel and time keys; values that are left out come from the request above.

#include "input/validation/validation_request.hpp"

#include <algorithm>

#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

void read_files(TomlTable& table, const std::vector<ValidationModel>& models, ReadoutRequest& request) {
    TomlTable files = table.subtable("files");
    if (!files.exists()) {
        return;
    }
    request.case_name.reset();
    request.files.clear();
    for (const ValidationModel& model : models) {
        if (const std::optional<std::string> file = files.text(model.key)) {
            request.files[model.key] = {*file, files.place(model.key)};
        }
    }
    if (table.has("case")) {
        table.add_error("files", "both case and files are given", "keep one of them");
    }
}

void read_time_settings(TomlTable& table, ReadoutRequest& request) {
    constexpr std::array keys{"at", "to", "from", "take", "time_to"};
    table.declare_keys({"at", "take", "time_to", "from", "to"});
    const auto first = std::find_if(keys.begin(), keys.end(), [&](const char* key) { return table.has(key); });
    if (first == keys.end()) {
        return;
    }
    request.times = table.place(*first);
    request.take = Window::Take::at;
    const TomlValue* at = table.value("at");
    const bool at_end = at != nullptr && at->kind == TomlValue::Kind::text && at->text == "end";
    const std::optional<double> moment = at_end ? std::nullopt : table.quantity("at");
    request.from = table.quantity("from");
    request.to = table.quantity("to");
    constexpr std::array kinds{Window::Take::mean, Window::Take::max, Window::Take::min};
    if (const std::optional<std::size_t> take = table.choice("take")) {
        request.take = kinds[*take];
    }
    if (const std::optional<double> part = table.quantity("time_to")) {
        request.take = Window::Take::time_to;
        request.share = *part;
    }
    const bool spans = table.has("take") || table.has("time_to");
    if (table.has("at") && std::any_of(first + 1, keys.end(), [&](const char* key) { return table.has(key); })) {
        table.add_error("at", "at is one moment, and a span of time is given too", "keep at, or take with from and to");
    } else if (table.has("take") && table.has("time_to")) {
        table.add_error("time_to", "both take and time_to are given", "keep one of them");
    } else if (!table.has("at") && !spans) {
        table.add_error(*first, "from and to do not say what is taken between them", "add take = \"mean\"");
    }
    if (table.has("at")) {
        request.take = Window::Take::at;
        request.from = request.to = moment;
    }
}

}  // namespace

ReadoutRequest read_request(TomlTable& table, const ReadoutRequest& above, const std::vector<ValidationModel>& models) {
    ReadoutRequest request = above;
    if (const std::optional<std::string> name = table.text("case")) {
        request.case_name = LocatedString{*name, table.place("case")};
        request.files = {};
    }
    read_files(table, models, request);
    if (const std::optional<std::string> channel = table.text("channel")) {
        request.channel = LocatedString{*channel, table.place("channel")};
    }
    read_time_settings(table, request);
    return request;
}

}  // namespace tiretherm::input
