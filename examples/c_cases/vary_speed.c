/* SPDX-License-Identifier: BSD-3-Clause */
/* The same case at several speeds: a value is set by its address and with its unit, as in a case file.
 * Call: vary_speed CASE [CHANNEL] */
#include <stdio.h>

#include "tiretherm_cases.h"

int main(int argc, char **argv) {
    const char *const speeds[] = {"80 km/h", "100 km/h", "120 km/h"};
    const char *channel = argc > 2 ? argv[2] : "bulk_temperature";
    char message[4096];
    tiretherm_case *tire;
    size_t i;

    if (argc < 2) {
        fprintf(stderr, "vary_speed CASE [CHANNEL]\n");
        return 1;
    }
    tire = tiretherm_open_case(argv[1], message, sizeof message);
    if (!tire) {
        fprintf(stderr, "%s\n", message);
        return 1;
    }
    printf("the case has %s\n", tiretherm_value(tire, "drive.speed"));
    for (i = 0; i < sizeof speeds / sizeof *speeds; ++i) {
        tiretherm_answer *answer = NULL;
        int c;
        size_t rows;
        if (tiretherm_set_value(tire, "drive.speed", speeds[i]) != TIRETHERM_OK ||
            tiretherm_run_case(tire, NULL, NULL, &answer) != TIRETHERM_OK) {
            fprintf(stderr, "%s\n", tiretherm_case_message(tire));
            return 1;
        }
        c = tiretherm_find_channel(answer, 0, channel);
        rows = tiretherm_row_count(answer, 0);
        if (c < 0) {
            fprintf(stderr, "the case has no channel %s\n", channel);
            return 1;
        }
        printf("%-9s %s ends at %.1f degC\n", speeds[i], channel,
               tiretherm_values(answer, 0)[(rows - 1) * (size_t)tiretherm_channel_count(answer, 0) + (size_t)c] - 273.15);
        tiretherm_free_answer(answer);
    }
    tiretherm_close_case(tire);
    return 0;
}
