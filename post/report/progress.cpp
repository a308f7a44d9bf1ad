// SPDX-License-Identifier: BSD-3-Clause
// Writes lines of progress, cut to the width of the terminal, as often as the stream bears.

#include "post/report/progress.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "input/text/characters.hpp"
#include "physics/celsius.hpp"
#include "post/report/table.hpp"

namespace tiretherm::post {

namespace {

constexpr double at_once = 0.1;     // s, for a person who waits
constexpr double in_a_pipe = 60.0;  // s
constexpr double first_in_a_pipe = 10.0;

/// A longer line would wrap, and then it could not be rewritten.
std::string cut_to_width(const std::string& line, std::size_t width) {
    std::size_t seen = 0;
    for (std::size_t byte = 0; byte < line.size(); ++byte) {
        const bool starts_character = (static_cast<unsigned char>(line[byte]) & 0xC0) != 0x80;
        if (starts_character && ++seen > width) {
            return line.substr(0, byte);
        }
    }
    return line;
}

/// Seconds, minutes or hours, to the precision that an estimate has.
std::string duration(double seconds) {
    if (seconds < 9.95) {
        return fmt::format("{:.1f} s", seconds);
    }
    if (seconds < 120.0) {
        return fmt::format("{:.0f} s", seconds);
    }
    return seconds < 7200.0 ? fmt::format("{:.0f} min", seconds / 60.0) : fmt::format("{:.1f} h", seconds / 3600.0);
}

ProgressLine::Kind kind_for(std::FILE* stream, bool quiet) {
    using Kind = ProgressLine::Kind;
    return quiet ? Kind::silent : isatty(fileno(stream)) == 1 ? Kind::rewritten : Kind::each_minute;
}

}  // namespace

std::size_t terminal_width(std::FILE* stream) {
    if (const char* columns = std::getenv("COLUMNS")) {
        if (const long said = std::strtol(columns, nullptr, 10); said > 0 && said < 10000) {
            return static_cast<std::size_t>(said);
        }
    }
    winsize size{};
    return ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80u;
}

std::string progress_line(const std::string& name, const Advance& advance) {
    const double done = advance.time - advance.start;
    const double whole = advance.end - advance.start;
    std::string line = fmt::format("{}  {:.0f} %", name, whole > 0.0 ? 100.0 * done / whole : 100.0);
    if (done > 0.0) {  // before what a narrow terminal cuts off
        line += fmt::format("  about {} left", duration(advance.elapsed * (whole - done) / done));
    }
    line += fmt::format("  t = {:.0f} s of {:.0f} s  hottest {:.1f} °C", advance.time, advance.end,
                        celsius(advance.hottest));
    if (done > 0.0) {
        line += fmt::format("  {} x real time", grouped(done / advance.elapsed));
    }
    return line;
}

namespace {

/// Before what a narrow terminal cuts off.
std::string stage_text(const WorkDone::Stage& stage) {
    if (stage.doing.empty()) {
        return "";
    }
    std::string text = stage.doing;
    if (stage.count > 0) {
        text += fmt::format(" {} of {}", stage.number, stage.count);
    }
    if (!stage.of.empty()) {
        text += ": " + stage.of;
    }
    if (stage.count > 0 && stage.number > 1) {
        const auto done = static_cast<double>(stage.number - 1);
        text +=
            fmt::format(", about {} left", duration(stage.elapsed * (static_cast<double>(stage.count) - done) / done));
    }
    return text + ", ";
}

}  // namespace

std::string work_line(const WorkDone& work, double elapsed) {
    const auto grouped_count = [](std::size_t n) { return grouped(static_cast<double>(n)); };
    std::string line = stage_text(work.stage);
    const std::string total =
        grouped_count(work.total) + (work.at_most > work.total ? " to " + grouped_count(work.at_most) : std::string());
    line += work.total > 0 ? fmt::format("{} of {} {}s", grouped_count(work.done), total, work.thing)
                           : fmt::format("{} {}{}", grouped_count(work.done), work.thing, work.done == 1 ? "" : "s");
    const auto made = static_cast<double>(work.done - std::min(work.kept, work.done));
    if (made > 0.0 && elapsed > 0.0) {
        const double rate = made / elapsed;
        line += rate >= 0.1 ? fmt::format(", {:.2g} {}s/s", rate, work.thing)
                            : fmt::format(", {} a {}", duration(1.0 / rate), work.thing);
        if (work.at_most > work.total) {
            const auto seconds = [&](std::size_t to) { return static_cast<double>(to - work.done) / rate; };
            return line + (work.total > work.done ? fmt::format(", {} to {} left", duration(seconds(work.total)),
                                                                duration(seconds(work.at_most)))
                                                  : fmt::format(", at most {} left", duration(seconds(work.at_most))));
        }
        if (work.total > work.done) {
            return line + fmt::format(", about {} left", duration(static_cast<double>(work.total - work.done) / rate));
        }
    }
    return line + fmt::format(", {} so far", duration(elapsed));
}

double ProgressLine::wall_clock() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ProgressLine::ProgressLine(std::FILE* stream, Kind kind, Clock clock)
    : stream_(stream), kind_(kind), clock_(std::move(clock)), begun_(clock_()), written_(begun_) {}

ProgressLine::ProgressLine(std::FILE* stream, bool quiet) : ProgressLine(stream, kind_for(stream, quiet)) {}

ProgressLine::ProgressLine(Listener listener) : ProgressLine(nullptr, Kind::listened) {
    listener_ = std::move(listener);
}

void ProgressLine::show(const std::function<std::string(double elapsed)>& line, double share) {
    if (kind_ == Kind::silent) {
        return;
    }
    const double now = clock_();
    const double in_this_pipe = written_ == begun_ ? first_in_a_pipe : in_a_pipe;
    if (now - written_ < (kind_ == Kind::each_minute ? in_this_pipe : at_once)) {
        return;
    }
    written_ = now;
    const std::string text = input::printable(line(now - begun_));
    if (kind_ == Kind::listened) {
        listener_(text, share);
        return;
    }
    if (kind_ == Kind::rewritten) {
        fmt::print(stream_, "\r{}\033[K", cut_to_width(text, terminal_width(stream_) - 1));
        stands_ = true;
    } else {
        fmt::print(stream_, "{}\n", text);
    }
    std::fflush(stream_);
}

void ProgressLine::show(const WorkDone& work) {
    const double share = work.total > 0 ? static_cast<double>(work.done) / static_cast<double>(work.total)
                                        : std::numeric_limits<double>::quiet_NaN();
    show([&](double elapsed) { return work_line(work, elapsed); }, share);
}

void ProgressLine::wipe() {
    if (stands_) {
        fmt::print(stream_, "\r\033[K");
        std::fflush(stream_);
        stands_ = false;
    }
}

Progress::Progress(ProgressLine& line, std::string name, double start, double end)
    : line_(&line), name_(std::move(name)), start_(start), end_(end) {}

void Progress::update(double time, std::span<const double> temperature) {
    const auto line = [&](double elapsed) {
        return progress_line(name_, {.start = start_,
                                     .end = end_,
                                     .time = time,
                                     .hottest = *std::max_element(temperature.begin(), temperature.end()),
                                     .elapsed = elapsed});
    };
    line_->show(line, end_ > start_ ? (time - start_) / (end_ - start_) : 1.0);
}

}  // namespace tiretherm::post
