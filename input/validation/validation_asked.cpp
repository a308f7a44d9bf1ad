#include "input/validation/validation_asked.hpp"

#include <algorithm>

#include "input/text/wanted.hpp"

namespace tiretherm::input {

namespace {

void read_files(Section& section, Asked& asked) {
    Section files = section.section("files");
    if (!files.exists()) {
        return;
    }
    asked.case_name.reset();
    for (std::size_t m = 0; m < n_models; ++m) {
        const std::optional<std::string> file = files.text(model_names[m]);
        asked.files[m] = file ? std::optional(Word{*file, files.place(model_names[m])}) : std::nullopt;
    }
    if (section.has("case")) {
        section.mistake("files", "both case and files are given", "keep one of them");
    }
}

void read_times(Section& section, Asked& asked) {
    constexpr std::array keys{"at", "to", "from", "take", "time_to"};
    section.know({"at", "take", "time_to", "from", "to"});
    const auto first = std::find_if(keys.begin(), keys.end(), [&](const char* key) { return section.has(key); });
    if (first == keys.end()) {
        return;
    }
    asked.times = section.place(*first);
    asked.take = Window::Take::at;
    const Node* at = section.value("at");
    const bool at_end = at != nullptr && at->kind == Node::Kind::text && at->text == "end";
    const std::optional<double> moment = at_end ? std::nullopt : section.quantity("at", wanted::moment);
    asked.from = section.quantity("from", wanted::moment);
    asked.to = section.quantity("to", wanted::moment);
    constexpr std::array<std::string_view, 3> takes{"mean", "max", "min"};
    constexpr std::array kinds{Window::Take::mean, Window::Take::max, Window::Take::min};
    if (const std::optional<std::size_t> take = section.choice("take", takes)) {
        asked.take = kinds[*take];
    }
    constexpr Wanted share{.unit = "1", .low = 0.0, .high = 1.0, .above = true};
    if (const std::optional<double> part = section.quantity("time_to", share)) {
        asked.take = Window::Take::time_to;
        asked.share = *part;
    }
    const bool spans = section.has("take") || section.has("time_to");
    if (section.has("at") && std::any_of(first + 1, keys.end(), [&](const char* key) { return section.has(key); })) {
        section.mistake("at", "at is one moment, and a span of time is given too", "keep at, or take with from and to");
    } else if (section.has("take") && section.has("time_to")) {
        section.mistake("time_to", "both take and time_to are given", "keep one of them");
    } else if (!section.has("at") && !spans) {
        section.mistake(*first, "from and to do not say what is taken between them", "add take = \"mean\"");
    }
    if (section.has("at")) {
        asked.take = Window::Take::at;
        asked.from = asked.to = moment;
    }
}

}  // namespace

Asked read_asked(Section& section, const Asked& above) {
    Asked asked = above;
    if (const std::optional<std::string> name = section.text("case")) {
        asked.case_name = Word{*name, section.place("case")};
        asked.files = {};
    }
    read_files(section, asked);
    if (const std::optional<std::string> channel = section.text("channel")) {
        asked.channel = Word{*channel, section.place("channel")};
    }
    read_times(section, asked);
    return asked;
}

}  // namespace tiretherm::input
