// SPDX-License-Identifier: BSD-3-Clause
// Cases, data, parameters, noise and verdicts: the keys and words of the readers and of the diagnosis, with their sentences.

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "app/help/help_text.hpp"
#include "app/help/topics.hpp"
#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/fit/identification.hpp"
#include "input/schema/all_tables.hpp"

namespace tiretherm::app {

namespace {

/// Up to the end of the first sentence; backticks are for pages.
std::string plain_sentence(std::string_view text) {
    std::string sentence(text.substr(0, text.find(". ")));
    std::erase(sentence, '`');
    if (!sentence.ends_with('.')) {
        sentence += '.';
    }
    return sentence;
}

/// The keys of a table, each with its sentence.
std::string keys_text(std::string_view path, std::size_t column) {
    const std::vector<input::TableKeys>& tables = input::all_tables();
    const auto table = std::ranges::find(tables, path, &input::TableKeys::path);
    std::string text;
    if (table != tables.end()) {
        for (const input::Key& key : table->keys) {
            text += entry_text(std::string(key.name), plain_sentence(key.sentence), column);
        }
    }
    return text;
}

std::string meaning_of(diagnosis::Identifiability word) {
    using diagnosis::Identifiability;
    switch (word) {
        case Identifiability::determined:
            return "its interval comes from the data";
        case Identifiability::doubtful:
            return "the same, but the model may lack something that has moved it";
        case Identifiability::with_prior:
            return "its interval comes from the data and from what was known before";
        case Identifiability::prior_only:
            return "the data do not see it: its interval is what was known before";
        case Identifiability::not_determined:
            return "the data do not see it, and nothing was known: its value means nothing";
        case Identifiability::at_bound:
            return "the data favour a value beyond the bound";
    }
    return "";
}

std::string meaning_of(diagnosis::Verdict verdict) {
    using diagnosis::Verdict;
    switch (verdict) {
        case Verdict::named:
            return "One effect or one pair explains the differences, and predicts data that it was not fitted to. Is "
                   "its size plausible? Then use extended.toml.";
        case Verdict::confounded:
            return "Several effects that these data cannot tell apart, each with its size. Do the test that the page "
                   "recommends, or rule some out by what you know.";
        case Verdict::unknown:
            return "Something is missing that is no effect of the catalogue. The page says where, how many watts, and "
                   "which signal they follow; extended.toml has it as a [[source]].";
        case Verdict::consistent:
            return "Nothing significant is left. The page has an upper limit for each effect.";
        case Verdict::cannot_tell:
            return "The mesh or the data are too poor; the page says which.";
        case Verdict::partial:
            return "The largest improvement that was found; an error is left beside it, or the prediction does not "
                   "prove it. Go on looking.";
    }
    return "";
}

}  // namespace

std::string cases_topic() {
    std::string text = paragraphs_text(
        "A case is one TOML file. The shortest way to one of your own: tiretherm new \"225/50 R17\" --out mine.toml, "
        "or tiretherm new drive.csv. Every line of it has a comment. Paths in a case are relative to it.\n\n");
    for (const input::TableKeys& table : input::all_tables()) {
        if (table.path == "study:") {
            break;  // what follows belongs to other files
        }
        if (!table.path.empty() && table.path.find('.') == std::string::npos && table.path != "law") {
            text += entry_text(
                fmt::format(fmt::runtime(table.form == input::TableForm::list ? "[[{}]]" : "[{}]"), table.path),
                plain_sentence(table.sentence.substr(0, table.sentence.find(": "))), 18);
        }
    }
    return text +
           paragraphs_text(
               "\nAll keys of a table: tiretherm keys mesh. All errors of a case at once: tiretherm check CASE.\n");
}

std::string data_topic() {
    return paragraphs_text(
               "A measured run is a CSV or HDF5 file (.h5, .hdf5). A CSV has one line of headings with units, then a "
               "line for each sample:\n\n"
               "  time [s],speed [km/h],vertical_load [N],bulk_temperature [degC]\n"
               "  0,100,4000,23.4\n\n"
               "Commas, semicolons or tabs separate columns. Exports of MoTeC i2 are read as they are. Times ascend; "
               "two lines at one time are a jump. An empty field or nan is a missing sample. Columns that bear the "
               "name of an input or of a sensor of the case are used; all others are kept, and a diagnosis tries "
               "whether they drive what is missing.\n\n"
               "Give the files with --data, or in the case as [[run]]. Keys of [[run]]:\n\n") +
           keys_text("run", 19) +
           paragraphs_text(
               "\nWhat holds for all files is said once in [data]. Is a file sound? tiretherm check CASE --data "
               "FILE\n");
}

std::string parameters_topic() {
    std::string text =
        paragraphs_text(
            "A parameter is a number of the case. A [[parameter]] table makes one free: identify and diagnose may "
            "change it. Say what is known of it before, as a standard deviation. For example:\n\n"
            "  [[parameter]]\n  effect = \"air_convection\"\n  key = \"lambda_h\"\n"
            "  standard_deviation = 0.1\n\nKeys of [[parameter]]:\n\n") +
        keys_text("parameter", 22) + "\nWhat a fit says of each parameter:\n\n";
    using diagnosis::Identifiability;
    for (const Identifiability word :
         {Identifiability::determined, Identifiability::doubtful, Identifiability::with_prior,
          Identifiability::prior_only, Identifiability::not_determined, Identifiability::at_bound}) {
        text += entry_text(std::string(diagnosis::word_of(word)), meaning_of(word), 22);
    }
    return text;
}

std::string noise_topic() {
    return paragraphs_text(
               "Noise is what a sensor adds to the truth. Its standard deviation for one sample stands in the case, as "
               "standard_deviation of the [[sensor]]; take it from the data sheet. A fit estimates the noise again "
               "from what no parameter explains and compares the two.\n\n"
               "It has two parts: a white part that is new in every sample, and a correlated part that decays over "
               "some seconds, an AR(1) process. Its share of the variance is the white-noise share. Correlated samples "
               "say less: 1000 of them may count as 30. That number is the effective sample size.\n\n"
               "Much more noise than the data sheet says, or noise that is as slow as the run, is rather an error of "
               "the model. Parameters are then called doubtful: run tiretherm diagnose.\n\nKeys of [identify]:\n\n") +
           keys_text("identify", 12) +
           paragraphs_text(
               "\nBefore anything is measured, tiretherm identify CASE --plan says which accuracy the sensors and "
               "their noise allow.\n");
}

std::string verdicts_topic() {
    std::string text =
        paragraphs_text("tiretherm diagnose answers with one of these words (\"verdict\" in diagnosis.json):\n\n");
    using diagnosis::Verdict;
    for (const Verdict verdict : {Verdict::named, Verdict::confounded, Verdict::unknown, Verdict::consistent,
                                  Verdict::partial, Verdict::cannot_tell}) {
        text += entry_text(std::string(diagnosis::word_of(verdict)), meaning_of(verdict), 16);
    }
    return text + paragraphs_text(
                      "\nThe strength of a cause is given in standard deviations (sigma) from \"absent\". "
                      "docs/diagnosis.md says how to read the page and how often it is right.\n");
}

}  // namespace tiretherm::app
