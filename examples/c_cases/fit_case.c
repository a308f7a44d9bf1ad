/* SPDX-License-Identifier: BSD-3-Clause */
/* Fits the [[parameter]] values of a case to its measured runs, with progress, and prints them with their 95 % intervals.
 * Call: fit_case CASE [measured file ...] */
#include <stdio.h>

#include "tiretherm_cases.h"

static int show(double done, const char *line, void *user) {
    (void)done;
    (void)user;
    fprintf(stderr, "%s\n", line);
    return 0; /* other than 0 stops the fit */
}

int main(int argc, char **argv) {
    char message[4096];
    tiretherm_answer *answer = NULL;
    tiretherm_case *tire;
    int result, i;

    if (argc < 2) {
        fprintf(stderr, "fit_case CASE [measured file ...]\n");
        return 1;
    }
    tire = tiretherm_open_case(argv[1], message, sizeof message);
    if (!tire) {
        fprintf(stderr, "%s\n", message);
        return 1;
    }
    tiretherm_watch_case(tire, show, NULL);
    /* argv ends with NULL, as the list of files does */
    result = tiretherm_identify_case(tire, argc > 2 ? (const char *const *)(argv + 2) : NULL, NULL, &answer);
    if (result != TIRETHERM_OK) {
        fprintf(stderr, "%s\n", tiretherm_case_message(tire));
    }
    if (answer) {
        printf("%s\n", tiretherm_headline(answer));
    }
    for (i = 0; i < tiretherm_fitted_count(answer); ++i) {
        printf("%-32s %12.5g  %.5g to %.5g %s  (%s)\n", tiretherm_fitted_name(answer, i),
               tiretherm_fitted_value(answer, i), tiretherm_fitted_low(answer, i), tiretherm_fitted_high(answer, i),
               tiretherm_fitted_unit(answer, i), tiretherm_fitted_word(answer, i));
    }
    tiretherm_free_answer(answer);
    tiretherm_close_case(tire);
    return result;
}
