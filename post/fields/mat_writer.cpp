// SPDX-License-Identifier: BSD-3-Clause
// channels.mat: the channels of a run for MATLAB and Octave, in the level 4 MAT-file format ("MAT-File Format", MathWorks,
// chapter 2): each variable is five int32 (type, rows, columns, imaginary, length of the name), its name and its doubles,
// column by column.
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>

#include "post/fields/output_format.hpp"
#include "post/report/file.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

namespace {

/// A matrix of doubles, or of letters as doubles. @param values [rows * columns], column by column
void add_matrix(std::string& file, const std::string& name, std::size_t rows, std::span<const double> values,
                bool is_text) {
    constexpr int byte_order = std::endian::native == std::endian::little ? 0 : 1000;
    const std::size_t columns = rows == 0 ? 0 : values.size() / rows;
    for (const std::size_t entry :
         {static_cast<std::size_t>(byte_order) + (is_text ? 1U : 0U), rows, columns, std::size_t{0}, name.size() + 1}) {
        const auto word = static_cast<std::int32_t>(entry);
        file.append(reinterpret_cast<const char*>(&word), sizeof word);
    }
    file.append(name.c_str(), name.size() + 1);
    file.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

/// Texts below each other, filled up with blanks to the longest.
void add_texts(std::string& file, const std::string& name, const std::vector<std::string>& texts) {
    std::size_t width = 0;
    for (const std::string& text : texts) {
        width = std::max(width, text.size());
    }
    std::vector<double> letters;
    for (std::size_t column = 0; column < width; ++column) {
        for (const std::string& text : texts) {
            letters.push_back(column < text.size() ? static_cast<unsigned char>(text[column]) : ' ');
        }
    }
    add_matrix(file, name, texts.size(), letters, true);
}

/// A channel's name as MATLAB takes it, not yet among `taken`: letters, digits and underscores, a letter first.
std::string variable_name(std::string name, const std::vector<std::string>& taken) {
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    if (name.empty() || std::isalpha(static_cast<unsigned char>(name.front())) == 0) {
        name.insert(0, "c_");
    }
    while (name == "variable" || name == "unit" || std::ranges::find(taken, name) != taken.end()) {
        name += '_';
    }
    return name;
}

class MatWriter final : public RunOutput {
public:
    explicit MatWriter(const RunTarget& target) : target_(target), path_(target.directory / "channels.mat") {}

    void take(const solver::Snapshot&) override {}  // the history has it

    void finish() override {
        const History& history = target_.history;
        std::string file;
        std::vector<std::string> names{"time"};
        std::vector<std::string> units{"s"};
        add_matrix(file, "time", history.rows(), history.time(), false);
        for (std::size_t c = 0; c < target_.problem.channels.size(); ++c) {
            const solver::Channel& channel = target_.problem.channels[c];
            const solver::ShownUnit unit = solver::shown_unit(channel.quantity);
            std::vector<double> values = history.channel(c);
            std::ranges::transform(values, values.begin(), [&](double si) { return unit.value(si); });
            names.push_back(variable_name(channel.name, names));
            units.emplace_back(unit.name);
            add_matrix(file, names.back(), history.rows(), values, false);
        }
        add_texts(file, "variable", names);
        add_texts(file, "unit", units);
        replace_file(path_, file);
        written_ = {path_};
    }

    [[nodiscard]] std::vector<std::filesystem::path> files() const override { return written_; }

private:
    RunTarget target_;
    std::filesystem::path path_;
    std::vector<std::filesystem::path> written_;
};

}  // namespace

namespace formats {

extern const OutputFormat mat;
const OutputFormat mat{
    .name = "mat",
    .use = OutputFormat::Use::on_request,
    .help = "Also channels.mat for MATLAB and Octave: the channels as vectors, the units of channels.csv",
    .open = [](const RunTarget& target) -> std::unique_ptr<RunOutput> { return std::make_unique<MatWriter>(target); },
    .names_in = [](const std::filesystem::path&) -> std::vector<std::string> { return {"channels.mat"}; }};

}  // namespace formats

}  // namespace tiretherm::post
