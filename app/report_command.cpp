// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm report`: shows the page that a call has written into its folder, makes pictures of its charts, and lays two
// results beside each other.

#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/failure.hpp"
#include "app/messages.hpp"
#include "app/output.hpp"
#include "post/export/chart_pictures.hpp"
#include "post/page/html_page.hpp"
#include "post/pair/pair_report.hpp"
#include "post/report/file.hpp"
#include "post/report/output_folder.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* picture_folder = "charts";
constexpr const char* no_pictures = "no picture was written";

struct ReportOptions {
    std::string folder;
    std::string other;      ///< the second of two; empty: there is one
    std::string directory;  ///< of the page of two
    int width = 1600;
    double time_limit = 60.0;  ///< s
    bool png = false;
    bool dark = false;
    bool json = false;

    [[nodiscard]] fs::path page() const { return fs::path(folder) / post::page_name; }
    [[nodiscard]] fs::path pictures() const { return fs::path(folder) / picture_folder; }
};

/// Why a folder has no page, and what to do.
int report_missing(const ReportOptions& options) {
    std::error_code error;
    if (!fs::exists(options.folder, error)) {
        report_error(fmt::format("there is no folder {}", options.folder),
                     "name the folder that a call has written its files to: out/<case name>, or that of --out",
                     options.json);
    } else if (!fs::is_directory(options.folder, error)) {
        report_error(fmt::format("{} is a file", options.folder), "name the folder in which it stands", options.json);
    } else {
        report_error(fmt::format("there is no {} in {}", post::page_name, options.folder),
                     "run, compare, identify, diagnose, study and validate write it, unless --no-report is given",
                     options.json);
    }
    return Exit::input_error;
}

std::optional<post::PageCharts> read_charts(const ReportOptions& options) {
    try {
        return post::read_page(options.page());
    } catch (const std::runtime_error& error) {
        const bool unreadable = dynamic_cast<const post::FileError*>(&error) != nullptr;
        report_error(unreadable ? error.what() : fmt::format("{}: {}", options.page().string(), error.what()),
                     "make the page again with the call that has written it", options.json);
        return std::nullopt;
    }
}

/// The size that the header of a PNG file states.
post::Value size_at(const std::string& png, std::size_t at) {
    std::uint32_t size = 0;
    for (std::size_t i = 0; i < 4 && at + i < png.size(); ++i) {
        size = size << 8U | static_cast<unsigned char>(png[at + i]);
    }
    return size;
}

/// Why charts have no picture: the first of them, and what to do. Empty where all have one.
std::string not_drawn(const post::PageCharts& page, const std::vector<post::ChartPicture>& pictures) {
    std::string titles;
    std::string reason;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        if (!pictures[i].failure.empty()) {
            titles += fmt::format("{}\"{}\"", titles.empty() ? "" : ", ", page.charts[i].title);
            reason = reason.empty() ? pictures[i].failure : reason;
        }
    }
    return titles.empty() ? "" : fmt::format("no picture of {}: {}", titles, reason);
}

/// @param pictures [charts], or empty: none was asked for
post::Value data_of(const ReportOptions& options, const post::PageCharts& page,
                    const std::vector<post::ChartPicture>& pictures) {
    std::error_code error;
    const fs::path text = fs::path(options.folder) / post::text_page_name;
    const std::vector<std::string> names = post::picture_names(page.charts);
    post::Value::List charts;
    post::Value::List outputs;
    for (std::size_t i = 0; i < page.charts.size(); ++i) {
        post::Value chart{{"title", page.charts[i].title}};
        if (!pictures.empty() && !pictures[i].failure.empty()) {
            chart.set("error", pictures[i].failure);
        } else if (!pictures.empty()) {
            const std::string file = (options.pictures() / names[i]).generic_string();
            const std::string& png = pictures[i].png;
            chart.set({{"file", file}, {"width", size_at(png, 16)}, {"height", size_at(png, 20)}});
            outputs.push_back(file);
        }
        charts.push_back(std::move(chart));
    }
    post::Value data{{"report", options.page().generic_string()},
                     {"page", post::where(fs::exists(text, error), text.generic_string())},
                     {"version", page.version},
                     {"charts", std::move(charts)},
                     {"outputs", std::move(outputs)}};
    if (const std::string sentence = not_drawn(page, pictures); !sentence.empty()) {
        data.set({{"error", sentence}, {"mistakes", post::Value::List{}}});
    }
    return data;
}

/// The page as text, where its charts are, and how pictures are made of them.
void show_charts(const ReportOptions& options, const post::PageCharts& page) {
    const fs::path text = fs::path(options.folder) / post::text_page_name;
    std::error_code error;
    if (fs::exists(text, error)) {
        print_text(post::read_text(text) + "\n");
    }
    post::Report report{.title = fmt::format("Charts in {}", options.page().string())};
    post::Section charts("");
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

int make_pictures(const ReportOptions& options, const post::PageCharts& page) {
    if (page.charts.empty()) {
        report_error(fmt::format("{} has no chart", options.page().string()), no_pictures, options.json);
        return Exit::input_error;
    }
    const std::optional<fs::path> browser = post::find_browser();
    if (!browser) {
        report_error(
            "Chromium draws the pictures, and it is not installed",
            fmt::format("apt-get install chromium (as root), or open {} in any browser", options.page().string()),
            options.json);
        return Exit::input_error;
    }
    const std::vector<std::string> names = post::picture_names(page.charts);
    now_doing(fmt::format("drawing the charts of {}", options.page().string()));
    std::vector<post::ChartPicture> pictures;
    try {
        post::OutputFolder folder(options.pictures());
        pictures = post::chart_pictures(*browser, page,
                                        {.width = options.width,
                                         .dark = options.dark,
                                         .limit = std::chrono::milliseconds(std::lround(1e3 * options.time_limit)),
                                         .stopped = solver::stop_requested});
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            if (pictures[i].failure.empty()) {
                post::replace_file(folder.stage() / names[i], pictures[i].png);
            }
        }
        folder.commit();
    } catch (const post::BrowserError& error) {
        return report_browser(options, error);
    } catch (const std::runtime_error& error) {  // of a file, or another call works there
        report_error(error.what(), no_pictures, options.json);
        return Exit::input_error;
    }
    post::Report report{.title = fmt::format("Charts of {}", options.page().string())};
    report.data = data_of(options, page, pictures);
    post::Section files("");
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (pictures[i].failure.empty()) {
            files.line((options.pictures() / names[i]).string());
        }
    }
    report.add(std::move(files));
    print_report(report, options.json);
    const std::string sentence = not_drawn(page, pictures);
    if (!sentence.empty() && !options.json) {
        report_error(fmt::format("{}: {}", options.page().string(), sentence),
                     page.version == TIRETHERM_VERSION
                         ? "make the page again with the call that has written it"
                         : fmt::format("version {} has written the page and this is {}: make it again with this one",
                                       page.version, TIRETHERM_VERSION),
                     false);
    }
    return sentence.empty() ? Exit::done : Exit::input_error;
}

/// Two results on one page.
int report_pair(const ReportOptions& options) {
    std::vector<post::StoredResult> results;
    for (const std::string& folder : {options.folder, options.other}) {
        ReportOptions one = options;
        one.folder = folder;
        std::error_code error;
        if (!fs::exists(one.page(), error)) {
            return report_missing(one);
        }
        try {
            results.push_back(post::read_result(folder));
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
    std::vector<std::string> read;
    for (const std::string& folder : {options.folder, options.other}) {
        read.push_back((fs::path(folder) / post::page_name).string());
    }
    const auto folder = open_output(directory, read, post::page_names(), "nothing was written", options.json);
    if (!folder || !write_output(*folder, {}, options.json, [&] {
            page.add(folder->homes(post::page_files(folder->stage())));
            post::write_page(folder->stage(), page, {.kind = "report", .source = {}, .files = read});
        })) {
        return Exit::input_error;
    }
    print_report(page, options.json);
    return Exit::done;
}

int report(const ReportOptions& options) {
    if (!options.other.empty()) {
        return report_pair(options);
    }
    std::error_code error;
    if (!fs::exists(options.page(), error)) {
        return report_missing(options);
    }
    now_doing("reading " + options.page().string());
    const std::optional<post::PageCharts> page = read_charts(options);
    if (!page) {
        return Exit::input_error;
    }
    if (options.png) {
        solver::install_stop_handlers();
        return make_pictures(options, *page);
    }
    if (options.json) {
        fmt::print("{}", post::json_text(data_of(options, *page, {})));
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
            ->add_option("OTHER", options->other,
                         "Folder of a second result: both on one page, OTHER - DIR, of run or of compare")
            ->option_text(" ");
    add_out_option(*command, options->directory, "Where the page of two results goes. Default: out/DIR_against_OTHER");
    command->get_option("--out")->needs(other);
    CLI::Option* png = command->add_flag("--png", options->png,
                                         "Write every chart of report.html as a picture into the folder charts in DIR");
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
        "network). A field is drawn at its hottest moment. A file is named after its chart, "
        "charts/heat-at-the-end.png;\n"
        "other files there are left alone. The files appear together at the end. A chart that cannot be drawn is "
        "named,\n"
        "and the others are written.\n\n"
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
        "  tiretherm report out/laser out/three_watts --out out/one_or_three");
    command->callback([options, &exit_code] { exit_code = report(*options); });
}

}  // namespace tiretherm::app
