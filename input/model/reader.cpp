#include "input/model/reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/text/document.hpp"
#include "input/model/draft.hpp"
#include "input/effects/own_effects.hpp"
#include "input/measurements/runs.hpp"

namespace tiretherm::input {

namespace fs = std::filesystem;

std::string case_name(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error).lexically_normal();
    fs::path below;
    bool found = false;
    for (const fs::path& part : whole.parent_path()) {
        if (part == "cases") {
            found = true;
            below.clear();
        } else if (found) {
            below /= part;
        }
    }
    return ((found ? below : fs::path()) / whole.stem()).generic_string();
}

void read_tables(Section& root, Draft& draft) {
    solver::Problem& problem = draft.problem;
    problem.title = root.text("title").value_or(problem.name);
    for (const Word& source : root.texts("sources")) {
        problem.sources.push_back(source.text);
    }
    // A later table may speak about an earlier one: patches and layers of the mesh, channels, the run's start and end.
    draft.followed = followed_names(root.table());
    read_tire(root, draft);
    read_materials(root, draft);
    read_mesh(root, draft);
    read_drive(root, draft);
    read_effects(root, draft);
    read_times(root, draft);
    read_fields(root, draft);
    read_travelling(root, draft);
    read_own_effects(root, draft);
    read_initial(root, draft);
    read_sensors(root, draft);
    read_cameras(root, draft);
    bind_readings(root, draft);
    read_measured(root, draft);
    check_laws(root, draft);
}

Reading read_case(const fs::path& file) {
    Mistakes mistakes;
    std::optional<solver::Problem> problem;
    if (const std::optional<Node> document = read_document(file, mistakes)) {
        problem = read_runs(*document, case_name(file), {}, Occasion::measured, mistakes).problem;
    }
    Reading reading{.problem = std::nullopt, .mistakes = mistakes.in_order(), .warnings = unique(mistakes.warnings())};
    if (reading.mistakes.empty()) {
        take_away_cameras(*problem);
        reading.problem = std::move(problem);
    }
    return reading;
}

std::string render(const Reading& reading) {
    std::string text;
    for (const Mistake& mistake : reading.mistakes) {
        text += render(mistake);
    }
    for (const std::string& warning : reading.warnings) {
        text += fmt::format("warning: {}\n", warning);
    }
    return text;
}

}  // namespace tiretherm::input
