/* SPDX-License-Identifier: BSD-3-Clause */
/* tiretherm in real time, for programs in C and for all that can call C: one tire a session.
 *
 *     char message[4096];
 *     tiretherm_session *tire = tiretherm_open("tire.toml", message, sizeof message);
 *     if (!tire) { fputs(message, stderr); exit(1); }
 *     int speed = tiretherm_find_input("speed"), bulk = tiretherm_find_output(tire, "bulk");
 *     for (;;) {
 *         tiretherm_set_input(tire, speed, 30.0);
 *         if (tiretherm_step(tire, 0.001) != TIRETHERM_OK) { fputs(tiretherm_message(tire), stderr); break; }
 *         printf("%g K\n", tiretherm_output(tire, bulk));
 *     }
 *     tiretherm_close(tire);
 *
 * All numbers are SI: K, m/s, N, rad, Pa, W. `tiretherm inputs` says what each input means. tiretherm_cases.h has whole runs and fits.
 *
 * Work: a step is one step of the case's method, without error control. It makes at most 50 corrections and, for steps as a
 * vehicle model makes them, one or none. It opens no file, takes no lock and, after the first steps, allocates nothing unless
 * it fails.
 *
 * Errors: a NULL in the place of a session is a bad argument. No exception of C++ leaves a function.
 *
 * Threads: a session belongs to one thread at a time; different sessions are independent.
 */
#ifndef TIRETHERM_H
#define TIRETHERM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** One tire. */
typedef struct tiretherm_session tiretherm_session;

/** What a call came to. */
enum tiretherm_result {
    TIRETHERM_OK = 0,
    TIRETHERM_BAD_ARGUMENT = 1, /**< nothing was changed */
    TIRETHERM_FAILED = 2,       /**< no solution, or no memory; a session is as it was before */
    TIRETHERM_STOPPED = 3       /**< ended before its end because it was asked for, see tiretherm_cases.h */
};

/** Version of the library, "0.2.0". */
const char *tiretherm_version(void);

/** Begins a session with the tire of a case file: its mesh, materials, effects, start temperatures and sensors. The inputs are
 * those of the case at its start; what its logs say later is not used.
 * @param case_file path
 * @param message [size] out: what is wrong with the case, all mistakes with file and line; empty when there is none. May be NULL
 * @returns NULL after an error; else to be given to tiretherm_close */
tiretherm_session *tiretherm_open(const char *case_file, char *message, size_t size);

/** Ends a session. NULL is allowed. */
void tiretherm_close(tiretherm_session *session);

/** Number of inputs, the same for all sessions. */
int tiretherm_input_count(void);
/** Name of an input, "speed"; NULL when there is no such input. @param input from 0 */
const char *tiretherm_input_name(int input);
/** Unit of an input, "m s-1"; NULL when there is no such input. */
const char *tiretherm_input_unit(int input);
/** The input of a name. @returns -1 when there is none */
int tiretherm_find_input(const char *name);

/** Number of outputs of a session: the sensors and quantities of its case. */
int tiretherm_output_count(const tiretherm_session *session);
/** Name of an output, "bulk"; NULL when there is no such output. @param output from 0 */
const char *tiretherm_output_name(const tiretherm_session *session, int output);
/** Unit of an output, "K"; NULL when there is no such output. */
const char *tiretherm_output_unit(const tiretherm_session *session, int output);
/** The output of a name. @returns -1 when there is none */
int tiretherm_find_output(const tiretherm_session *session, const char *name);

/** Sets an input for the end of the next step; between two steps the inputs go in a straight line, and stay as they are until
 * they are set again.
 * @param value SI, within the input's range: `tiretherm inputs` names it
 * @returns TIRETHERM_BAD_ARGUMENT for an unknown input, and for a value that is no number or out of range */
int tiretherm_set_input(tiretherm_session *session, int input, double value);

/** Goes on by a step. @param dt s, > 0
 * @returns TIRETHERM_BAD_ARGUMENT for such a dt, TIRETHERM_FAILED when the heat balance has no solution */
int tiretherm_step(tiretherm_session *session, double dt);

/** An output now. @returns SI; NaN when there is no such output */
double tiretherm_output(const tiretherm_session *session, int output);
/** Time since the beginning. @returns s */
double tiretherm_time(const tiretherm_session *session);

/** Number of temperatures of the field. */
size_t tiretherm_temperature_count(const tiretherm_session *session);
/** The field: cells first, then the nodes of the surfaces.
 * @returns [tiretherm_temperature_count] K, valid until the next step or the end of the session */
const double *tiretherm_temperatures(const tiretherm_session *session);

/** Number of parameters of a session: the numbers of the [[parameter]] tables of its case. */
int tiretherm_parameter_count(const tiretherm_session *session);
/** Name of a parameter, "air_convection.lambda_h"; NULL when there is no such parameter. @param parameter from 0 */
const char *tiretherm_parameter_name(const tiretherm_session *session, int parameter);
/** Unit of a parameter, "W m-2 K-1"; NULL when there is no such parameter. */
const char *tiretherm_parameter_unit(const tiretherm_session *session, int parameter);
/** A parameter now. @returns in its unit; NaN when there is no such parameter */
double tiretherm_parameter(const tiretherm_session *session, int parameter);
/** Moves a parameter; the session goes on from its present temperatures, before its first step from its beginning. An initial
 * temperature makes a difference only then. Allocates.
 * @param value in its unit, within the bounds of the [[parameter]]
 * @returns TIRETHERM_BAD_ARGUMENT for an unknown parameter, and for a value that is no number or out of bounds */
int tiretherm_set_parameter(tiretherm_session *session, int parameter, double value);

/** The state of a session, with its inputs and parameters, as numbers: what is restored goes on with the same digits.
 * @param state [size] out; may be NULL  @param size nothing is written when it is smaller than what is returned
 * @returns how many numbers a state is, which changes from step to step; 0 when there is no memory for it */
size_t tiretherm_state(tiretherm_session *session, double *state, size_t size);
/** Takes a state up again, of this session or of another of the same case.
 * @returns TIRETHERM_BAD_ARGUMENT when it is none of this case; nothing has changed then */
int tiretherm_restore(tiretherm_session *session, const double *state, size_t size);

/** Why the last call that returns a tiretherm_result did not return TIRETHERM_OK; empty when it did. */
const char *tiretherm_message(const tiretherm_session *session);

#ifdef __cplusplus
}
#endif

#endif
