// SPDX-License-Identifier: BSD-3-Clause
// A table of words by code; that they suit what a remark is about is checked when it is compiled.
#include "post/report/remark_text.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <type_traits>

#include <fmt/args.h>
#include <fmt/format.h>

#include "input/text/word_lists.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose remarks are worded here

namespace {

/// Numbers are formatted by the words; the rest is text by then.
template <typename About>
using Shown = std::conditional_t<std::is_arithmetic_v<About>, About, std::string>;

struct Wording {
    RemarkCode code;
    std::string_view words;
};

template <typename... About>
Wording words(const RemarkKind<About...>& kind, fmt::format_string<const Shown<About>&...> words) {
    return {kind.code, {fmt::string_view(words).data(), fmt::string_view(words).size()}};
}

const std::array wordings{
    words(remark::noise_of_data_sheet,
          "{}: its {} samples leave nothing to estimate noise from, the data sheet's {:.3g} {} is taken"),
    words(remark::noise_assumed,
          "{}: its {} samples leave nothing to estimate noise from and no standard deviation is stated, {:.3g} {} is "
          "assumed; state it with the sensor"),
    words(remark::noise_above_data_sheet,
          "{0}: the noise of {1:.3g} {2} is {3:.1f} times what the data sheet says ({4:.3g} {2}): either the sensor is "
          "worse than that, or an error of the model is counted as noise"),
    words(
        remark::noise_as_slow_as_tire,
        "{}: the noise's correlation time of {} is close to the tire's time constant of {}: an error of the model may "
        "be counted as noise"),
    words(remark::noise_as_slow_as_allowed,
          "{}: the noise's correlation time reached its upper limit, {} or a tenth of the longest run: a drift of the "
          "sensor or an error of the model is taken for noise"),
    words(remark::band_above_data_sheet, "{}: the noise of {:.3g} K is {:.1f} times what the data sheet says"),
    words(remark::band_above_pixels,
          "{}: {:.1f} times what the pixels' own noise makes of it: a drift that they share, or a missing effect"),
    words(remark::noise_above_stated,
          "{}: its noise is {:.1f} times what the sensor is said to have: part of it may be a missing effect"),
    words(remark::channel_is_missed,
          "{0}: after the fit it is {1:.2g} {2} rms off, {3:.1f} times the sensor's {4:.2g} {2}: the model does not "
          "describe it, and no parameter is determined; see compare and diagnose"),
    words(remark::rms_rose,
          "{}: its rms rose with the fit, from {:.2g} to {:.2g} {}: a missing effect passes for slow noise, and the "
          "values and intervals are not to be trusted; see compare, and fit with noise = \"white\" beside it"),
    words(remark::numbers_are_missed,
          "the single measured numbers are off by {:.1f} of their standard uncertainties (rms): the model does not "
          "describe them, and no parameter is determined; run diagnose"),
    words(remark::number_of_car,
          "{}: temperatures tell a number of the car only as well as its model knows the slips of the tires. The "
          "interval does not hold the errors of that model; it has missed the mass of a car that was known"),
    words(remark::not_left_out, "{} could not be left out: the model fails with a fit to the rest"),
    words(
        remark::white_noise_predicts_better,
        "data that were left out are predicted better, by {:.0f} % of the rms, when the fit takes the noise as white: "
        "the slow noise was an error of the model. The fit with white noise is shown; diagnose says what the model "
        "lacks."),
    words(remark::parameter_is_unexpected, "{}: the data pull it to {:.3g}{}, {}: {}"),
    words(remark::at_bound_of_allowed, "the bound of what is allowed"),
    words(remark::above_prior, "{:.1f} standard deviations above the {:.3g} +- {:.2g} that were known before"),
    words(remark::below_prior, "{:.1f} standard deviations below the {:.3g} +- {:.2g} that were known before"),
    words(remark::outside_expected, "outside {:.3g} to {:.3g}, where it is expected ({})"),
    words(remark::start_is_unlike_log,
          "the run began earlier than the log, or the sensors were not at the tire's temperature: start the log before "
          "the tire rolls, or state the start by the first readings"),
    words(
        remark::compensates_for_car,
        "it may compensate for another value of [vehicle] or for an error of the tire model: weigh or measure it, log "
        "wheel loads or slips, or run diagnose"),
    words(
        remark::prior_is_too_narrow,
        "the prior is too narrow, or the parameter stands in for an effect that the model lacks: check where the prior "
        "comes from, then run diagnose"),
    words(remark::slow_sensor, "a lag or delay of {} can do this, as it flattens what sliding makes: free {}"),
    words(remark::slow_sensors,
          "a lag or delay of the {} infrared sensors can do this, as it flattens what sliding makes: free {}"),
    words(remark::known_reason, "{}"),
    words(remark::thinned,
          "{}: {:.3g} Hz thinned to {:.3g} Hz by means of {} samples; the inputs are as they were logged"),
    words(
        remark::images_as_rings,
        "{}: its images are taken as the means of {} rings about the spot, each {:.1f} mm wide, where the case says "
        "that they lie; identify takes every pixel and fits where they lie. The rings' noise counts as independent: a "
        "drift that they share makes sigmas up to {:.1f} times too large"),
    words(remark::not_tried, "{} is listed in [diagnose] candidates and was not tried: {}"),
    words(remark::no_such_effect, "there is no such effect"),
    words(remark::no_sensor_of_surfaces, "no measured sensor sees nothing but a surface"),
    words(remark::no_sensor_of_its_kind, "no measured sensor is of its kind"),
    words(remark::is_on_already, "it is on, and its parameters are free or differ from place to place"),
    words(remark::needs_grid, "it needs a grid, and the mesh is of lumps"),
    words(remark::needs_signal, "it needs {}, which {} does not give"),
    words(remark::nothing_to_act_on, "the mesh, the tire or the runs have nothing that it acts on"),
    words(remark::no_sensor_changes, "no sensor changes ({})."),
    words(remark::sensor_of_run, "{} of {}"),
    words(
        remark::too_few_values,
        "{} values for {} free parameters and {} noises leave nothing to judge the model by. Longer runs, more sensors "
        "or fewer free parameters would help."),
    words(remark::best_so_far, "Best so far, not fitted: {}."),
    words(remark::may_be_absent,
          "the largest improvement that was found, {}, may be chance. Its interval reaches to where it is absent, and "
          "its "
          "gain on data that were left out ({:.1f} % of the mean square) is not confirmed."),
    words(remark::without_cause, "without any cause, {}"),
    words(remark::fits_at_end_of_range,
          "{} fits better only with {} = {:.3g}, at the end of its plausible range: excluded from the verdict"),
    words(remark::fits_at_bound_only,
          "{} fits better only at a parameter bound or with a negligible component: excluded from the verdict"),
    words(remark::more_is_missing, "something significant is left beside it: there is more than one thing missing"),
    words(remark::grid_is_kept,
          "the grid's error is {:.1f} standard deviations, but {} gave no gain on data that were left out: the case's "
          "grid is kept, and a cause may stand for its error"),
    words(remark::run_ended_early,
          "The run ended early: nothing is said of steady states, of further steps and of what drives the hot spots."),
    words(remark::drivers_not_known, "What drives the hot spots is not known: {}."),
    words(remark::at_kink, "{} is at a kink: its derivative is one-sided."),
    words(remark::key_is_left_out, "{} is left out: the case does not run on the same mesh with its other values."),
    words(remark::nothing_to_change, "{} {}."),
    words(remark::moves_nothing, "{} moves nothing: {}."),
    words(remark::no_effect_looks_at_it, "no effect that is on looks at it"),
    words(remark::may_read_it, "{} may read it and does not use it here"),
    words(remark::no_effect_reads_it, "no effect that is on reads it"),
    words(remark::others_would_read_it, "no effect that is on reads it; {} would"),
    words(remark::left_range, "{} in {} of {} runs"),
    words(remark::noise_alone, "Sensors are noisier than stated: {}; nothing in these data asks for a cause."),
    words(remark::noise_of_channel,
          "the noise of {0} is {1:.2g} {2}, {3:.1f} times ({4:.1f} to {5:.1f}) the {6:.2g} {2} of the data sheet"),
    words(remark::unit_is_other,
          "The numbers of {0} look like {1} under a heading of {2}: read so, the rms of all temperatures after the fit "
          "falls from {3:.2g} to {4:.2g} K{5}. Correct the heading of {6} in {7}, or write units = {{ {8} }} in {9}."),
    words(remark::parameters_come_back,
          ", and the free parameters come back from {:.1f} to {:.1f} standard deviations of what was known of them"),
    words(
        remark::columns_are_exchanged,
        "{0} look exchanged (swapped): read the other way round, the rms of all temperatures after the fit falls from "
        "{1:.2g} to {2:.2g} K. Correct the headings of {3} in {4}, or write columns = {{ {5} }} in {6}."),
    words(
        remark::inputs_are_mirrored,
        "{0} in {1} look mirrored, those of the wheel on the other side: with its load, as much below the mean as this "
        "one's is above, the rms of all temperatures after the fit falls from {2:.2g} to {3:.2g} K. Give the case the "
        "inputs of the wheel whose temperatures were measured; until then there is no extended case."),
    words(remark::number_of_run_differs,
          "{} has another {}: {:.3g} times that of the other runs ({:.3g} to {:.3g}). {}. Ask what was changed before "
          "that run. The extended case has the value of the other runs"),
    words(remark::reading_of_run_differs,
          "{} alone has {}: {} {:.3g} ({:.3g} to {:.3g}) {}, beside the other runs. An instrument was replaced, moved "
          "or set anew for that run, or what it stands for was changed. The extended case is without it"),
    words(remark::changes_from_run_to_run,
          "{} changes from run to run, from {:.4g} in the first to {:.4g} in the last: wear, ageing, a sensor that "
          "drifts. The extended case has the value of the last run"),
    words(remark::other_compound, "Another compound, another pressure or a worn tread would do this"),
    words(remark::other_air, "Another wind, another wheel or other bodywork would do this"),
    words(remark::other_road, "Another road, rain or another compound would do this"),
    words(remark::other_setup, "Something was changed between the runs"),
    words(remark::rain_would_do_this,
          "rain or a wet road from {1:.0f} s to {2:.0f} s of {0} would take this heat: the tire moves there. Was the "
          "road "
          "wet? Log it as `wet`"),
    words(remark::warmed_standing,
          "the tire stands from {1:.0f} s to {2:.0f} s of {0}: tire blankets or hot brakes would warm it like this"),
    words(remark::cooled_standing,
          "the tire stands from {1:.0f} s to {2:.0f} s of {0}: a fan, wind or water would cool it like this"),
    words(
        remark::looks_like_number,
        "{0} with {1} = {2:.3g} would look like {3} at its fitted {4:.3g} in the place of the {5:.3g} that was known: "
        "these data cannot tell them apart"),
};
static_assert(std::tuple_size_v<decltype(wordings)> == static_cast<std::size_t>(RemarkCode::count),
              "a remark has no words");

/// 12 s, 3.4 min, 1.2 h
std::string shown(Seconds time) {
    const double seconds = time.count();
    return seconds < 120.0    ? fmt::format("{:.2g} s", seconds)
           : seconds < 7200.0 ? fmt::format("{:.2g} min", seconds / 60.0)
                              : fmt::format("{:.2g} h", seconds / 3600.0);
}
std::string shown(const Remarks& remarks) { return input::listed(texts_of(remarks)); }
std::string shown(const std::string& text) { return text; }
double shown(double number) { return number; }
long shown(long number) { return number; }

}  // namespace

std::string text_of(const Remark& remark) {
    const auto found = std::ranges::find(wordings, remark.code, &Wording::code);
    assert(found != wordings.end());
    fmt::dynamic_format_arg_store<fmt::format_context> about;
    for (const auto& one : remark.about) {
        std::visit([&](const auto& value) { about.push_back(shown(value)); }, one);
    }
    return fmt::vformat({found->words.data(), found->words.size()}, about);
}

std::vector<std::string> texts_of(const Remarks& remarks) {
    std::vector<std::string> texts;
    std::ranges::transform(remarks, std::back_inserter(texts), text_of);
    return texts;
}

}  // namespace tiretherm::post
