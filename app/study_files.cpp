#include "app/study_files.hpp"

#include <algorithm>
#include <system_error>
#include <thread>

#include "cases/unit_text.hpp"
#include "post/file.hpp"
#include "post/study_picture.hpp"
#include "post/study_tables.hpp"

namespace tiretherm::app {

namespace fs = std::filesystem;

StudyFiles::StudyFiles(fs::path directory, bool pictures) : directory_(std::move(directory)), pictures_(pictures) {
    std::error_code error;
    fs::create_directories(directory_, error);
    if (error) {
        throw post::FileError("create the directory", directory_, error.message());
    }
}

void StudyFiles::remove_old() const {
    for (const char* name : {"study.csv", "study.h5", "study.png"}) {
        std::error_code error;
        fs::remove(directory_ / name, error);
    }
}

std::vector<fs::path> StudyFiles::write(const post::StudyRecord& study) const {
    std::vector<fs::path> written{directory_ / "study.csv", directory_ / "study.h5"};
    post::replace_file(written[0], post::study_csv(study));
    const fs::path draft = directory_ / "study.h5.part";
    post::write_study_hdf5(draft, study);
    std::error_code error;
    fs::rename(draft, written[1], error);
    if (error) {
        throw post::FileError("rename", draft, error.message());
    }
    const fs::path picture = directory_ / "study.png";
    if (pictures_ && post::has_study_picture(study)) {
        post::draw_study(picture, study);
        written.push_back(picture);
    } else {
        fs::remove(picture, error);
    }
    written.push_back(journal());
    return written;
}

post::StudyRecord study_record(const cases::Study& study, std::vector<post::StudyOutcome> outcomes) {
    post::StudyRecord record{.title = study.title,
                             .study_file = study.file.generic_string(),
                             .study_text = post::read_text(study.file),
                             .case_file = study.case_file.generic_string(),
                             .case_name = study.case_name,
                             .version = TIRETHERM_VERSION,
                             .critical = study.critical,
                             .columns = {},
                             .sides = {},
                             .samples = study.samples,
                             .is_sampled = study.is_sampled(),
                             .channels = study.channels,
                             .outcomes = std::move(outcomes),
                             .warnings = {}};
    for (std::size_t i = 0; i < study.inputs.size(); ++i) {
        const cases::StudyInput& input = study.inputs[i];
        post::StudyColumn column{.key = input.key.text,
                                 .unit = input.unit,
                                 .udunits = cases::spelt_out(input.unit),
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

unsigned threads_used(unsigned asked, std::size_t runs) {
    const unsigned wanted = asked > 0 ? asked : std::max(1U, std::thread::hardware_concurrency());
    return static_cast<unsigned>(std::clamp<std::size_t>(runs, 1, wanted));
}

}  // namespace tiretherm::app
