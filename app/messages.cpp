#include "app/messages.hpp"

#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

namespace tiretherm::app {

namespace {

using Json = nlohmann::ordered_json;

void print(const Json& json) {
    // A byte that is not UTF-8 may stand in the user's file; it must not end the program.
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

bool on_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

bool may_be_bold() { return on_terminal(stdout) && std::getenv("NO_COLOR") == nullptr; }

void report_error(const std::string& sentence, const std::string& remedy, bool json) {
    const std::string whole = remedy.empty() ? sentence : fmt::format("{}; {}", sentence, remedy);
    if (json) {
        print({{"error", whole}, {"mistakes", Json::array()}});
    } else {
        fmt::print(stderr, "tiretherm: {}\n", whole);
    }
}

void report_errors(const input::Reading& reading, const std::string& consequence, bool json) {
    const std::size_t n = reading.errors.size();
    const std::string sentence = fmt::format("{} {}; {}", n, n == 1 ? "error" : "errors", consequence);
    if (!json) {
        fmt::print(stderr, "{}{}\n", input::render(reading), sentence);
        return;
    }
    Json errors = Json::array();
    for (const input::InputError& error : reading.errors) {
        errors.push_back({{"file", error.file},
                          {"line", error.line},
                          {"column", error.column},
                          {"length", error.length},
                          {"message", error.what},
                          {"remedy", error.remedy}});
    }
    print({{"error", sentence}, {"mistakes", errors}, {"warnings", reading.warnings}});
}

}  // namespace tiretherm::app
