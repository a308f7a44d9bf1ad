// SPDX-License-Identifier: BSD-3-Clause
// Writes CSV, HDF5 and page of a study into its folder, and removes those of an earlier study.

#include "post/study/study_files.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>

#include "input/text/unit_text.hpp"
#include "mesh/parallel.hpp"
#include "post/page/html_page.hpp"
#include "post/report/file.hpp"
#include "post/study/study_tables.hpp"

namespace tiretherm::post {

namespace fs = std::filesystem;

StudyFiles::StudyFiles(OutputFolder& folder, bool page) : folder_(folder), page_(page) {
    // Runs are added to the journal in place: one of our own, not what a link leads to.
    std::error_code error;
    if (fs::is_symlink(journal(), error)) {
        replace_file(journal(), fs::exists(journal(), error) ? read_text(journal()) : "");
    }
}

std::vector<std::string> StudyFiles::names() {
    std::vector<std::string> names = page_names();
    names.insert(names.end(), {"runs.jsonl", "study.csv", "study.h5"});
    return names;
}

void StudyFiles::write(const diagnosis::StudyRecord& study,
                       const std::function<Report(const std::vector<fs::path>&)>& report) const {
    std::vector<fs::path> written{folder_.stage() / "study.csv", folder_.stage() / "study.h5"};
    replace_file(written[0], study_csv(study));
    write_study_hdf5(written[1], study);
    std::vector<fs::path> named = folder_.homes(written);
    named.push_back(journal());
    if (page_) {
        std::ranges::copy(page_files(folder_.path()), std::back_inserter(named));
    }
    const Report result = report(named);
    if (page_) {
        write_page(folder_.stage(), result, {.kind = "study", .source = study.study_file, .files = folder_.inputs()});
    }
    folder_.commit(page_names());
}

diagnosis::StudyRecord study_record(const input::Study& study, std::vector<diagnosis::StudyOutcome> outcomes) {
    diagnosis::StudyRecord record{.title = study.title,
                                  .study_file = study.file.generic_string(),
                                  .study_text = read_text(study.file),
                                  .case_file = study.case_file.generic_string(),
                                  .case_name = study.case_name,
                                  .version = TIRETHERM_VERSION,
                                  .critical = study.critical,
                                  .columns = {},
                                  .sides = {},
                                  .samples = study.samples,
                                  .is_sampled = study.is_sampled(),
                                  .channels = study.channels,
                                  .parts = study.parts,
                                  .outcomes = std::move(outcomes),
                                  .warnings = {}};
    for (std::size_t i = 0; i < study.inputs.size(); ++i) {
        const input::StudyInput& input = study.inputs[i];
        diagnosis::StudyColumn column{.key = input.key.text,
                                      .unit = input.unit,
                                      .udunits = input::spelt_out(input.unit),
                                      .is_number = input.is_number,
                                      .is_drawn = input.is_drawn,
                                      .texts = {},
                                      .numbers = {}};
        for (std::size_t run = 0; run < study.runs.size(); ++run) {
            column.texts.push_back(study.value(run, i).text);
            column.numbers.push_back(study.value(run, i).number);
        }
        record.columns.push_back(std::move(column));
        if (!input.is_drawn) {
            record.sides.push_back(input.values.size());
        }
    }
    return record;
}

unsigned threads_used(unsigned asked, std::size_t runs) { return static_cast<unsigned>(threads_for(runs, asked)); }

}  // namespace tiretherm::post
