// SPDX-License-Identifier: BSD-3-Clause
// The pictures of a run: the last field.
#include "post/fields/output_format.hpp"
#include "post/pictures/picture.hpp"

namespace tiretherm::post {

namespace {

class RunPictures final : public RunOutput {
public:
    explicit RunPictures(const RunTarget& target) : target_(target) {}

    void take(const solver::Snapshot& snapshot) override {
        if (snapshot.field) {
            time_ = snapshot.time;
            field_.assign(snapshot.temperature.begin(), snapshot.temperature.end());
        }
    }

    void finish() override {
        const solver::Problem& problem = target_.problem;
        if (has_section(problem.mesh) && !field_.empty()) {
            draw_field(add("picture.png"), problem, time_, field_);
        } else if (!problem.mesh.columns.empty() && !field_.empty()) {
            draw_folded(add("picture.png"), problem, time_, field_);
            if (problem.mesh.sectors > 1) {
                draw_tread(add("tread.png"), problem, time_, field_);
            }
        }
    }

    [[nodiscard]] std::vector<std::filesystem::path> files() const override { return written_; }

private:
    std::filesystem::path add(const char* name) { return written_.emplace_back(target_.directory / name); }

    RunTarget target_;
    double time_ = 0.0;
    std::vector<double> field_;  ///< [n_nodes] K
    std::vector<std::filesystem::path> written_;
};

}  // namespace

namespace formats {

extern const OutputFormat pictures;
const OutputFormat pictures{
    .name = "pictures",
    .use = OutputFormat::Use::unless_refused,
    .help = "No picture.png and tread.png",
    .open = [](const RunTarget& target) -> std::unique_ptr<RunOutput> { return std::make_unique<RunPictures>(target); },
    .names_in = [](const std::filesystem::path&) -> std::vector<std::string> {
        return {"picture.png", "tread.png"};
    }};

}  // namespace formats

}  // namespace tiretherm::post
