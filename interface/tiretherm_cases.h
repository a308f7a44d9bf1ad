/* SPDX-License-Identifier: BSD-3-Clause */
/* tiretherm's calls for programs in C: a case with values set, its runs, comparisons with measured data, fits and diagnoses.
 *
 *     char message[4096];
 *     tiretherm_answer *answer;
 *     tiretherm_case *tire = tiretherm_open_case("tire.toml", message, sizeof message);
 *     if (!tire) { fputs(message, stderr); exit(1); }
 *     tiretherm_set_value(tire, "drive.speed", "120 km/h");
 *     if (tiretherm_run_case(tire, NULL, NULL, &answer) != TIRETHERM_OK) fputs(tiretherm_case_message(tire), stderr);
 *     if (answer) puts(tiretherm_headline(answer));
 *     tiretherm_free_answer(answer);
 *     tiretherm_close_case(tire);
 *
 * They are the calls of the command line and of the Python package, with the same numbers. Numbers are SI: K, m/s, N, W.
 *
 * Memory: what a function returns belongs to the case or the answer that it was asked of, and nothing else is to be freed. Texts of
 * a case are valid until the next call with it, all of an answer until tiretherm_free_answer. An answer needs its case no longer,
 * but files of a call without a folder go with the case.
 *
 * Errors: a NULL in the place of a case, an answer, an address or a value is a bad argument. What a function says of something that
 * is not there is NULL, NaN, 0 or -1. No exception of C++ leaves a function; where memory runs out, it fails.
 *
 * Threads: a case belongs to one thread at a time, different cases are independent. An answer does not change.
 */
#ifndef TIRETHERM_CASES_H
#define TIRETHERM_CASES_H

#include "tiretherm.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A case file, or a text, with values laid over it. The file is not changed. */
typedef struct tiretherm_case tiretherm_case;
/** What a call came to. */
typedef struct tiretherm_answer tiretherm_answer;

/** The case of a file. What is wrong in the file is said by the calls that read it.
 * @param message [size] out: why there is no case; empty when there is one. May be NULL
 * @returns NULL when there is no such file; else to be given to tiretherm_close_case */
tiretherm_case *tiretherm_open_case(const char *case_file, char *message, size_t size);
/** The case of a text in TOML, which is copied. Paths in it are absolute.
 * @param name of the case on its pages and in messages, without a "/"; the rest as tiretherm_open_case */
tiretherm_case *tiretherm_open_text(const char *text, const char *name, char *message, size_t size);
/** Ends a case. NULL is allowed. */
void tiretherm_close_case(tiretherm_case *tire);

/** Gives a value of the case another one, by its address as studies and `tiretherm run --change` have it: "drive.speed",
 * "mesh.layer.tread.thickness". What is wrong with it is said by the calls that read the case.
 * @param value as in a case file, a text without quotation marks: "120 km/h", "0.9", "true", "[1, 2]"
 * @returns TIRETHERM_BAD_ARGUMENT without an address or a value */
int tiretherm_set_value(tiretherm_case *tire, const char *address, const char *value);
/** Takes a value away, of the file or one that was set: the case then has its default.
 * @returns TIRETHERM_BAD_ARGUMENT without an address */
int tiretherm_unset_value(tiretherm_case *tire, const char *address);
/** A value of the case as it is written, "80 km/h"; NULL where the case has none there. */
const char *tiretherm_value(tiretherm_case *tire, const char *address);
/** Reads the case as tiretherm_run_case does, without running it.
 * @param run name of a [[run]]; NULL: the first
 * @returns TIRETHERM_BAD_ARGUMENT when there are errors: tiretherm_case_message has all of them. Otherwise it has the warnings */
int tiretherm_check_case(tiretherm_case *tire, const char *run);
/** Why the last call with the case that returns a tiretherm_result did not return TIRETHERM_OK: all mistakes with file, line and
 * remedy, those in a value that was set with its address. Empty when it did, but for warnings of tiretherm_check_case. */
const char *tiretherm_case_message(const tiretherm_case *tire);

/** Is told ten times a second at most, in the thread of the call, how far it is. It leaves the case alone.
 * @param done 0 to 1, of each tire of a car or of each stage of its own; NaN where it is not known
 * @param line says it in words, valid during the call; @param user as given
 * @returns other than 0 to stop the call */
typedef int tiretherm_progress(double done, const char *line, void *user);
/** From now on the calls with the case tell how far they are. @param progress NULL: no longer */
int tiretherm_watch_case(tiretherm_case *tire, tiretherm_progress *progress, void *user);

/** Simulates the case, of a car all its tires, as `tiretherm run` does.
 * @param run name of a [[run]]; NULL: the first   @param folder for the files; NULL: none are written
 * @param answer out: to be given to tiretherm_free_answer. NULL when there is none; after TIRETHERM_FAILED and
 * TIRETHERM_STOPPED it may hold the rows up to then. The address may be NULL
 * @returns TIRETHERM_BAD_ARGUMENT when the case, the folder or the call is wrong, TIRETHERM_FAILED when the heat balance has no
 * solution, TIRETHERM_STOPPED when progress asked for it */
int tiretherm_run_case(tiretherm_case *tire, const char *run, const char *folder, tiretherm_answer **answer);
/** Simulates the measured runs of the case without fitting, as `tiretherm compare` does.
 * @param data paths of measured files in the place of the case's own runs, the last followed by NULL; NULL: the case's own
 * @param folder for the files; NULL: one that goes with the case. The rest as tiretherm_run_case */
int tiretherm_compare_case(tiretherm_case *tire, const char *const *data, const char *folder,
                           tiretherm_answer **answer);
/** Fits the [[parameter]] values of the case to measured runs, as `tiretherm identify` does. The same call goes on from one that
 * was stopped. @returns TIRETHERM_FAILED also when the search did not converge; there is an answer then. The rest as
 * tiretherm_compare_case */
int tiretherm_identify_case(tiretherm_case *tire, const char *const *data, const char *folder,
                            tiretherm_answer **answer);
/** Finds which effects the case lacks, as `tiretherm diagnose` does.
 * @param time_limit s, after which the best answer so far is given, or TIRETHERM_FAILED where there is none; 0: none. The rest
 * as tiretherm_compare_case */
int tiretherm_diagnose_case(tiretherm_case *tire, const char *const *data, const char *folder, double time_limit,
                            tiretherm_answer **answer);

/** Ends an answer. NULL is allowed. */
void tiretherm_free_answer(tiretherm_answer *answer);
/** The answer in a few sentences, a line each: the first thing on its page. */
const char *tiretherm_headline(const tiretherm_answer *answer);
/** The page as the command line prints it. */
const char *tiretherm_page(const tiretherm_answer *answer);
/** The data of the answer in JSON, as `--json` prints it. */
const char *tiretherm_json(const tiretherm_answer *answer);
/** What the call said beside its answer, a line each; empty where it said nothing. */
const char *tiretherm_notes(const tiretherm_answer *answer);
/** Number of files that were written. */
int tiretherm_file_count(const tiretherm_answer *answer);
/** Path of a file. @param file from 0 */
const char *tiretherm_file(const tiretherm_answer *answer, int file);

/** Number of tires of a run: one, or those of a car; 0 for other calls. */
int tiretherm_tire_count(const tiretherm_answer *answer);
/** Name of a tire: its corner, "FL", or the run's name, which is empty where the case has no [[run]]. @param tire from 0 */
const char *tiretherm_tire_name(const tiretherm_answer *answer, int tire);
/** Number of channels of a tire: its sensors and quantities. */
int tiretherm_channel_count(const tiretherm_answer *answer, int tire);
/** Name of a channel, "bulk_temperature". @param channel from 0 */
const char *tiretherm_channel_name(const tiretherm_answer *answer, int tire, int channel);
/** Unit of a channel, "K". */
const char *tiretherm_channel_unit(const tiretherm_answer *answer, int tire, int channel);
/** The channel of a name. @returns -1 when there is none */
int tiretherm_find_channel(const tiretherm_answer *answer, int tire, const char *name);
/** Number of rows of a tire: the output times of its run. */
size_t tiretherm_row_count(const tiretherm_answer *answer, int tire);
/** @returns [tiretherm_row_count] s */
const double *tiretherm_times(const tiretherm_answer *answer, int tire);
/** The channels at these times, row by row: channel j in row i is [i * tiretherm_channel_count + j].
 * @returns [tiretherm_row_count * tiretherm_channel_count] SI */
const double *tiretherm_values(const tiretherm_answer *answer, int tire);
/** Number of temperatures of the field of a tire. */
size_t tiretherm_final_temperature_count(const tiretherm_answer *answer, int tire);
/** The field in the last row: cells first, then the nodes of the surfaces. @returns [tiretherm_final_temperature_count] K */
const double *tiretherm_final_temperatures(const tiretherm_answer *answer, int tire);

/** Number of parameters of a fit; 0 for other calls. */
int tiretherm_fitted_count(const tiretherm_answer *answer);
/** Name of a fitted parameter, "air_convection.lambda_h". @param parameter from 0 */
const char *tiretherm_fitted_name(const tiretherm_answer *answer, int parameter);
/** Unit of its numbers, "W m-2 K-1". */
const char *tiretherm_fitted_unit(const tiretherm_answer *answer, int parameter);
/** What the data say of it: "determined", "not determined", "at bound". */
const char *tiretherm_fitted_word(const tiretherm_answer *answer, int parameter);
/** Its value. */
double tiretherm_fitted_value(const tiretherm_answer *answer, int parameter);
/** Lower end of its 95 % interval; minus infinity where it reaches beyond the parameter's bound. */
double tiretherm_fitted_low(const tiretherm_answer *answer, int parameter);
/** Upper end of its 95 % interval; infinity where it reaches beyond the bound. */
double tiretherm_fitted_high(const tiretherm_answer *answer, int parameter);

#ifdef __cplusplus
}
#endif

#endif
