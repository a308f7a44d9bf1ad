// SPDX-License-Identifier: BSD-3-Clause
// A page with the charts alone and export.js is loaded; what the script leaves in the document is printed by --dump-dom.
#include "post/export/chart_pictures.hpp"

#include <stdlib.h>  // mkdtemp
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <sstream>

#include <fmt/format.h>

#include "post/export/child_process.hpp"
#include "post/page/assets.hpp"
#include "post/page/html_page.hpp"
#include "post/report/base64.hpp"
#include "post/report/file.hpp"
#include "post/report/output_folder.hpp"

namespace tiretherm::post {

namespace fs = std::filesystem;

namespace {

/// A folder of its own for the browser, gone at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "tiretherm_report_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw FileError("create the directory", name, system_reason(errno));
        }
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// The charts, and the scripts that draw them. Its policy lets nothing in from elsewhere.
std::string drawing_page(const PageCharts& page, const PictureRequest& request) {
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
        "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; style-src "
        "'unsafe-inline'; img-src data:\">\n<style>\n";
    text += assets::style();
    text += fmt::format("</style>\n</head>\n<body data-width=\"{}\"{}{}>\n<main>\n", request.width,
                        request.dark ? " data-dark" : "",
                        request.at.empty() ? "" : fmt::format(" data-at=\"{}\"", request.at));
    for (const PageChart& chart : page.charts) {
        text += chart.element + "\n";
    }
    text += "</main>\n";
    for (const std::string_view script : {assets::charting_library(), assets::script(), assets::export_script()}) {
        text += "<script>\n";
        text += script;
        text += "</script>\n";
    }
    return text + "</body>\n</html>\n";
}

/// A path as an address: what means something else there, such as # and %, by its code.
std::string file_address(const fs::path& file) {
    std::string address = "file://";
    for (const char c : file.string()) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           std::string_view("/-_.~").find(c) != std::string_view::npos;
        address += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return address;
}

std::vector<std::string> call_of(const fs::path& browser, const fs::path& page, const fs::path& profile) {
    std::vector<std::string> call{browser.string(),
                                  "--headless=new",
                                  "--dump-dom",
                                  "--disable-gpu",
                                  "--disable-dev-shm-usage",
                                  "--disable-background-networking",
                                  "--disable-extensions",
                                  "--disable-breakpad",
                                  "--no-first-run",
                                  "--host-resolver-rules=MAP * ~NOTFOUND",
                                  "--window-size=1280,900",
                                  "--user-data-dir=" + profile.string()};
    if (geteuid() == 0) {
        call.emplace_back("--no-sandbox");  // Chromium refuses to run as root with it
    }
    call.push_back(file_address(page));
    return call;
}

/// The last line that says something.
std::string last_line(const std::string& text) {
    std::istringstream lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        last = line.empty() ? last : line;
    }
    return last;
}

/// What the browser printed, or why that is nothing.
std::string printed(const fs::path& browser, const ChildResult& done, const PictureRequest& request) {
    const std::string said = done.err.empty() ? "" : fmt::format(": {}", last_line(done.err));
    switch (done.end) {
        case ChildResult::End::not_started:
            throw BrowserError(BrowserError::Cause::failed,
                               fmt::format("{} cannot be started: {}", browser.string(), system_reason(done.code)));
        case ChildResult::End::timed_out:
            throw BrowserError(BrowserError::Cause::timed_out,
                               fmt::format("{} has not drawn the charts within {:g} s", browser.string(),
                                           std::chrono::duration<double>(request.limit).count()));
        case ChildResult::End::stopped:
            throw BrowserError(BrowserError::Cause::stopped, "stopped");
        case ChildResult::End::killed_by_signal:
            throw BrowserError(BrowserError::Cause::failed,
                               fmt::format("{} was ended by signal {}{}", browser.string(), done.code, said));
        case ChildResult::End::exited:
            break;
    }
    if (done.code != 0) {
        throw BrowserError(BrowserError::Cause::failed,
                           fmt::format("{} failed with exit code {}{}", browser.string(), done.code, said));
    }
    return done.out;
}

/// The lines of export.js.
std::vector<ChartPicture> pictures_of(const std::string& document, const PageCharts& page, const std::string& browser) {
    const std::size_t begin = document.find("<pre id=\"pictures\">");
    if (begin == std::string::npos) {
        throw BrowserError(BrowserError::Cause::failed, fmt::format("{} has drawn nothing", browser));
    }
    std::vector<ChartPicture> pictures(page.charts.size());
    std::istringstream lines(document.substr(begin));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && !line.starts_with("</pre>")) {
        std::size_t chart = page.charts.size();
        const auto [blank, error] = std::from_chars(line.data(), line.data() + line.size(), chart);
        if (error != std::errc() || chart >= page.charts.size()) {
            continue;
        }
        const std::string content = line.substr(static_cast<std::size_t>(blank - line.data()) + 1);
        if (content.starts_with("- ")) {
            pictures[chart].failure = content.substr(2);
        } else {
            pictures[chart].png = from_base64(content).value_or("");
        }
    }
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        if (pictures[i].failure.empty() && !pictures[i].png.starts_with("\x89PNG")) {
            throw BrowserError(BrowserError::Cause::failed,
                               fmt::format("{} gave no picture of the chart \"{}\"", browser, page.charts[i].title));
        }
    }
    return pictures;
}

/// The size that the header of a PNG file states.
Value size_at(const std::string& png, std::size_t at) {
    std::uint32_t size = 0;
    for (std::size_t i = 0; i < 4 && at + i < png.size(); ++i) {
        size = size << 8U | static_cast<unsigned char>(png[at + i]);
    }
    return size;
}

}  // namespace

std::optional<fs::path> find_browser() {
    return find_program({"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"});
}

std::vector<ChartPicture> chart_pictures(const fs::path& browser, const PageCharts& page,
                                         const PictureRequest& request) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "charts.html";
    replace_file(file, drawing_page(page, request));
    const ChildResult done =
        run_child(call_of(browser, file, folder.path() / "profile"), request.limit, request.stopped);
    return pictures_of(printed(browser, done, request), page, browser.string());
}

void write_pictures(const fs::path& folder, const PageCharts& page, const std::vector<ChartPicture>& pictures) {
    OutputFolder output(folder / picture_folder);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        if (pictures[i].failure.empty()) {
            replace_file(output.stage() / page.charts[i].picture, pictures[i].png);
        }
    }
    output.commit();
}

std::string not_drawn(const PageCharts& page, const std::vector<ChartPicture>& pictures) {
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

Value page_data(const fs::path& folder, const PageCharts& page, const std::vector<ChartPicture>& pictures) {
    std::error_code error;
    const fs::path text = folder / text_page_name;
    Value::List charts;
    Value::List outputs;
    for (std::size_t i = 0; i < page.charts.size(); ++i) {
        Value chart{{"title", page.charts[i].title}};
        if (!pictures.empty() && !pictures[i].failure.empty()) {
            chart.set("error", pictures[i].failure);
        } else if (!pictures.empty()) {
            const std::string file = (folder / picture_folder / page.charts[i].picture).generic_string();
            const std::string& png = pictures[i].png;
            chart.set({{"file", file}, {"width", size_at(png, 16)}, {"height", size_at(png, 20)}});
            outputs.emplace_back(file);
        }
        charts.push_back(std::move(chart));
    }
    Value data{{"report", (folder / page_name).generic_string()},
               {"page", where(fs::exists(text, error), text.generic_string())},
               {"version", page.version},
               {"charts", std::move(charts)},
               {"outputs", std::move(outputs)}};
    if (const std::string sentence = not_drawn(page, pictures); !sentence.empty()) {
        data.set({{"error", sentence}, {"errors", Value::List{}}, {"mistakes", Value::List{}}});
    }
    return data;
}

}  // namespace tiretherm::post
