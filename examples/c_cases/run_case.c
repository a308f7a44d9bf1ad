/* SPDX-License-Identifier: BSD-3-Clause */
/* A whole run: what comes of it in words, and the last value of each channel.
 * Call: run_case CASE [FOLDER for the files] */
#include <stdio.h>

#include "tiretherm_cases.h"

int main(int argc, char **argv) {
    char message[4096];
    tiretherm_answer *answer = NULL;
    tiretherm_case *tire;
    int result, t, c, i;

    if (argc < 2) {
        fprintf(stderr, "run_case CASE [FOLDER]\n");
        return 1;
    }
    tire = tiretherm_open_case(argv[1], message, sizeof message);
    if (!tire) {
        fprintf(stderr, "%s\n", message);
        return 1;
    }
    result = tiretherm_run_case(tire, NULL, argc > 2 ? argv[2] : NULL, &answer);
    if (result != TIRETHERM_OK) {
        fprintf(stderr, "%s\n", tiretherm_case_message(tire)); /* and perhaps the rows up to then */
    }
    if (answer) {
        printf("%s\n", tiretherm_headline(answer));
        for (t = 0; t < tiretherm_tire_count(answer); ++t) {
            const int n = tiretherm_channel_count(answer, t);
            const size_t rows = tiretherm_row_count(answer, t);
            const double *last = tiretherm_values(answer, t) + (rows - 1) * (size_t)n;
            printf("%s after %g s, %d rows\n", tiretherm_tire_name(answer, t), tiretherm_times(answer, t)[rows - 1], (int)rows);
            for (c = 0; c < n; ++c) {
                printf("  %-24s %10.4g %s\n", tiretherm_channel_name(answer, t, c), last[c],
                       tiretherm_channel_unit(answer, t, c));
            }
        }
        for (i = 0; i < tiretherm_file_count(answer); ++i) {
            printf("%s\n", tiretherm_file(answer, i));
        }
    }
    tiretherm_free_answer(answer);
    tiretherm_close_case(tire);
    return result;
}
