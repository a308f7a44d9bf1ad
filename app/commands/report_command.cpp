// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm report`: shows the page that a call has written into its folder, makes pictures of its charts, and lays two
// results beside each other.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"
#include "app/terminal.hpp"
#include "calls/doing.hpp"
#include "calls/output.hpp"
#include "post/export/chart_pictures.hpp"
#include "post/page/html_page.hpp"
#include "post/pair/pair_report.hpp"
#include "post/report/file.hpp"
#include "post/report/output_folder.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* no_pictures = "no picture was written";

struct ReportOptions {
    std::string folder;
    std::vector<std::string> others{};  ///< without pictures one: the second of two
    std::string directory;              ///< of the page of two
    std::vector<std::string> charts{};  ///< those that are drawn; empty: all
    std::string at;                     ///< of fields: s, or "end"
    int width = 1600;
    double time_limit = 60.0;  ///< s
    bool png = false;
    bool dark = false;
    bool json = false;

    [[nodiscard]] fs::path page() const { return fs::path(folder) / post::page_name; }
    /// The same of each folder of the call.
    [[nodiscard]] std::vector<ReportOptions> of_folders() const {
        std::vector<ReportOptions> all{*this};
        for (const std::string& other : others) {
            all.push_back(*this);
            all.back().folder = other;
        }
        return all;
    }
};

/// A page whose charts are drawn.
struct DrawnPage {
    ReportOptions options;
    post::PageCharts page;
    std::vector<post::ChartPicture> pictures{};  ///< [charts]
};

/// Whether a folder has a page; says what to do where not.
bool has_page(const ReportOptions& options) {
    std::error_code error;
    if (fs::exists(options.page(), error)) {
        return true;
    }
    std::string what = fmt::format("there is no {} in {}", post::page_name, options.folder);
    std::string remedy = "run, compare, identify, diagnose, study and validate write it, unless --no-report is given";
    if (!fs::exists(options.folder, error)) {
        what = fmt::format("there is no folder {}", options.folder);
        remedy = "name the folder that a call has written its files to: out/<case name>, or that of --out";
    } else if (!fs::is_directory(options.folder, error)) {
        what = fmt::format("{} is a file", options.folder);
        remedy = "name the folder in which it stands";
    }
    report_error(what, remedy, options.json);
    return false;
}

/// The charts of a folder's page; nothing, after its message, where there is none or it cannot be read.
std::optional<post::PageCharts> read_charts(const ReportOptions& options) {
    if (!has_page(options)) {
        return std::nullopt;
    }
    calls::now_doing("reading " + options.page().string());
    try {
        return post::read_page(options.page());
    } catch (const std::runtime_error& error) {
        const bool unreadable = dynamic_cast<const post::FileError*>(&error) != nullptr;
        report_error(unreadable ? error.what() : fmt::format("{}: {}", options.page().string(), error.what()),
                     "make the page again with the call that has written it", options.json);
        return std::nullopt;
    }
}

/// The page as text, where its charts are, and how pictures are made of them.
void show_charts(const ReportOptions& options, const post::PageCharts& page) {
    const fs::path text = fs::path(options.folder) / post::text_page_name;
    std::error_code error;
    if (fs::exists(text, error)) {
        print_text(post::read_text(text) + "\n");
    }
    post::Report report{.title = fmt::format("Charts in {}", options.page().string())};
    post::ReportSection charts("");
    for (const post::PageChart& chart : page.charts) {
        charts.item(chart.title);
    }
    if (page.charts.empty()) {
        charts.say("none");
    } else {
        charts.say(fmt::format("Open it in a browser. As pictures: tiretherm report {} --png", options.folder));
    }
    report.add(std::move(charts));
    print_report(report, false);
}

/// What kept the browser from its pictures, with the remedy.
int report_browser(const ReportOptions& options, const post::BrowserError& error) {
    using Cause = post::BrowserError::Cause;
    std::string remedy = no_pictures;
    switch (error.cause) {
        case Cause::stopped:
            report_error(error.what(), remedy, options.json);
            return Exit::interrupted;
        case Cause::timed_out:
            remedy += "; give it longer with --time-limit";
            break;
        case Cause::failed:
            remedy += fmt::format("; open {} in a browser to see the charts", options.page().string());
            break;
    }
    report_error(error.what(), remedy, options.json);
    return Exit::numerical_failure;
}

/// The page of a folder with the charts that are to be drawn; nothing, after its message, where that cannot be.
std::optional<DrawnPage> page_to_draw(const ReportOptions& options) {
    std::optional<post::PageCharts> page = read_charts(options);
    if (!page) {
        return std::nullopt;
    }
    if (page->charts.empty()) {
        report_error(fmt::format("{} has no chart", options.page().string()), no_pictures, options.json);
        return std::nullopt;
    }
    if (const std::string unknown = post::choose_charts(*page, options.charts); !unknown.empty()) {
        std::string titles;
        for (const post::PageChart& chart : page->charts) {
            titles += fmt::format("{}\"{}\"", titles.empty() ? "" : ", ", chart.title);
        }
        report_error(fmt::format("{} has no chart \"{}\"; it has {}", options.page().string(), unknown, titles),
                     no_pictures, options.json);
        return std::nullopt;
    }
    return DrawnPage{.options = options, .page = std::move(*page)};
}

/// What was written, and which charts could not be drawn.
int tell_pictures(const std::vector<DrawnPage>& pages) {
    const bool json = pages.front().options.json;
    int exit_code = Exit::done;
    post::Report report{.title = pages.size() > 1 ? fmt::format("Charts of {} pages", pages.size())
                                                  : fmt::format("Charts of {}", pages.front().options.page().string())};
    post::Value::List of_pages;
    post::ReportSection files("");
    for (const DrawnPage& drawn : pages) {
        of_pages.push_back(post::page_data(drawn.options.folder, drawn.page, drawn.pictures));
        for (std::size_t i = 0; i < drawn.pictures.size(); ++i) {
            if (drawn.pictures[i].failure.empty()) {
                files.line(
                    (fs::path(drawn.options.folder) / post::picture_folder / drawn.page.charts[i].picture).string());
            }
        }
    }
    report.data = pages.size() > 1 ? post::Value{{"reports", std::move(of_pages)}} : std::move(of_pages.front());
    report.add(std::move(files));
    print_report(report, json);
    for (const DrawnPage& drawn : pages) {
        const std::string sentence = post::not_drawn(drawn.page, drawn.pictures);
        exit_code = sentence.empty() ? exit_code : int{Exit::input_error};
        if (!sentence.empty() && !json) {
            report_error(
                fmt::format("{}: {}", drawn.options.page().string(), sentence),
                drawn.page.version == TIRETHERM_VERSION
                    ? "make the page again with the call that has written it"
                    : fmt::format("version {} has written the page and this is {}: make it again with this one",
                                  drawn.page.version, TIRETHERM_VERSION),
                false);
        }
    }
    return exit_code;
}

/// Nothing is written before all is drawn.
int make_pictures(const ReportOptions& options) {
    std::vector<DrawnPage> pages;
    for (const ReportOptions& one : options.of_folders()) {
        std::optional<DrawnPage> page = page_to_draw(one);
        if (!page) {
            return Exit::input_error;
        }
        pages.push_back(std::move(*page));
    }
    const std::optional<fs::path> browser = post::find_browser();
    if (!browser) {
        report_error(
            "Chromium draws the pictures, and it is not installed",
            fmt::format("apt-get install chromium (as root), or open {} in any browser", options.page().string()),
            options.json);
        return Exit::input_error;
    }
    const post::PictureRequest request{.width = options.width,
                                       .dark = options.dark,
                                       .at = options.at,
                                       .limit = std::chrono::milliseconds(std::lround(1e3 * options.time_limit)),
                                       .stopped = solver::stop_requested};
    try {
        for (DrawnPage& drawn : pages) {
            calls::now_doing(fmt::format("drawing the charts of {}", drawn.options.page().string()));
            drawn.pictures = post::chart_pictures(*browser, drawn.page, request);
        }
        for (const DrawnPage& drawn : pages) {
            post::write_pictures(drawn.options.folder, drawn.page, drawn.pictures);
        }
    } catch (const post::BrowserError& error) {
        return report_browser(options, error);
    } catch (const std::runtime_error& error) {  // of a file, or another call works there
        report_error(error.what(), no_pictures, options.json);
        return Exit::input_error;
    }
    return tell_pictures(pages);
}

/// Two results on one page.
int report_pair(const ReportOptions& options) {
    if (options.others.size() > 1) {
        report_error(fmt::format("two results stand side by side, and there are {}", options.others.size() + 1),
                     "name two folders; with --png the charts of any number of them are drawn", options.json);
        return Exit::input_error;
    }
    std::vector<post::StoredResult> results;
    std::vector<std::string> read;
    for (const ReportOptions& one : options.of_folders()) {
        if (!has_page(one)) {
            return Exit::input_error;
        }
        read.push_back(one.page().string());
        try {
            results.push_back(post::read_result(one.folder));
        } catch (const std::runtime_error& failure) {
            report_error(failure.what(),
                         "run and compare leave what is needed in their folder; make it again with one of them",
                         options.json);
            return Exit::input_error;
        }
    }
    if (const std::string reason = post::nothing_in_common(results[0], results[1]); !reason.empty()) {
        report_error(reason, "name two folders of run, or two of compare, with sensors of the same names",
                     options.json);
        return Exit::input_error;
    }
    post::Report page = post::pair_report(results[0], results[1]);
    const fs::path directory =
        options.directory.empty()
            ? fs::path("out") / (results[0].folder.lexically_normal().filename().string() + "_against_" +
                                 results[1].folder.lexically_normal().filename().string())
            : fs::path(options.directory);
    Terminal terminal(options.json, false);
    const auto folder = calls::open_output(directory, read, post::page_names(), "nothing was written", terminal);
    if (!folder || !calls::write_output(*folder, {}, terminal, [&] {
            page.add(folder->homes(post::page_files(folder->stage())));
            post::write_page(folder->stage(), page, {.kind = "report", .source = {}, .files = read});
        })) {
        return Exit::input_error;
    }
    terminal.take(page);
    return Exit::done;
}

int report(const ReportOptions& options) {
    if (options.png) {
        solver::install_stop_handlers();
        return make_pictures(options);
    }
    if (!options.others.empty()) {
        return report_pair(options);
    }
    const std::optional<post::PageCharts> page = read_charts(options);
    if (!page) {
        return Exit::input_error;
    }
    if (options.json) {
        fmt::print("{}", post::json_text(post::page_data(options.folder, *page, {})));
    } else {
        show_charts(options, *page);
    }
    return Exit::done;
}

}  // namespace

void add_report_command(CLI::App& program, int& exit_code) {
    CLI::App* command =
        program.add_subcommand("report", "Show the page of a call, draw its charts, or lay two results side by side");
    const auto options = std::make_shared<ReportOptions>();
    command->add_option("DIR", options->folder, "Folder that a call has written its files to")
        ->required()
        ->option_text(" ");
    CLI::Option* other =
        command
            ->add_option("OTHER", options->others,
                         "Folder of a second result: both on one page, OTHER - DIR, of run or of compare. With --png "
                         "any number: the charts of each are drawn")
            ->option_text(" ");
    add_out_option(*command, options->directory, "Where the page of two results goes. Default: out/DIR_against_OTHER");
    command->get_option("--out")->needs(other);
    CLI::Option* png = command->add_flag("--png", options->png,
                                         "Write every chart of report.html as a picture into the folder charts in DIR");
    command
        ->add_option("--chart", options->charts,
                     "This chart alone, by its title or the name of its picture; once for each")
        ->option_text("NAME ...")
        ->allow_extra_args(false)
        ->needs(png);
    command
        ->add_option(
            "--at", options->at,
            "Fields and frames of a camera at the moment next to this, or at the \"end\". Default: the hottest "
            "moment, of a tread the last, of a camera the worst frame")
        ->option_text("SECONDS")
        ->check(CLI::NonNegativeNumber | CLI::IsMember({"end"}))
        ->needs(png);
    command->add_option("--width", options->width, "Of the pictures. Default: 1600")
        ->option_text("PX")
        ->check(CLI::Range(320, 8000))
        ->needs(png);
    command->add_flag("--dark", options->dark, "Pictures on dark paper")->needs(png);
    command->add_option("--time-limit", options->time_limit, "Of the browser. Default: 60")
        ->option_text("SECONDS")
        ->check(CLI::Range(0.1, 86400.0))
        ->needs(png);
    command->add_flag("--json", options->json, "One JSON object instead of the text");
    command->footer(
        "Without --png: prints page.txt, the page of run, compare, identify, diagnose, study or validate as it stood "
        "on\n"
        "the terminal, and says which charts report.html holds.\n"
        "With --png: Chromium without a window draws the charts (Debian package chromium; nothing is fetched from a\n"
        "network). A file is named after its chart, charts/heat-at-the-end.png; other files there are left alone. The\n"
        "files appear together at the end. A chart that cannot be drawn is named, and the others are written.\n\n"
        "With two folders of run, or two of compare: report.html and page.txt with the keys of the cases that differ, "
        "the\n"
        "channels of both over each other with the differences of final value, maximum and mean, hottest places, hot "
        "spots\n"
        "and heat side by side. They must have been made by this version, with their page.\n\n"
        "Exit code: 0 done; 1 an error in the call, no page, a damaged one, nothing in common, a chart that cannot be\n"
        "drawn, or no Chromium; 2 Chromium failed or took too long;\n"
        "130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm report out/laser --png --width 1200\n"
        "  tiretherm report out/laser out/three_watts --png \\\n"
        "      --chart \"Temperature field\" --at end\n"
        "  tiretherm report out/laser out/three_watts --out out/one_or_three");
    command->callback([options, &exit_code] { exit_code = report(*options); });
}

}  // namespace tiretherm::app
