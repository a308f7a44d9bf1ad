/* SPDX-License-Identifier: BSD-3-Clause */
/* Four tires at 1 kHz, as a vehicle model would call them: laps of straights and corners, load moving outwards in a corner.
 * Call: four_tires CASE [seconds]. Prints the bulk's temperatures each second and, at the end, the share of a core. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "tiretherm.h"

enum { tires = 4 };
static const char *const names[tires] = {"front left", "front right", "rear left", "rear right"};

static void fail(const char *what, const char *why) {
    fprintf(stderr, "four_tires: %s: %s\n", what, why);
    exit(1);
}

static void set(tiretherm_session *tire, const char *name, double value) {
    if (tiretherm_set_input(tire, tiretherm_find_input(name), value) != TIRETHERM_OK) {
        fail(name, tiretherm_message(tire));
    }
}

int main(int argc, char **argv) {
    tiretherm_session *tire[tires];
    char message[4096];
    const double dt = 0.001;
    int output[tires];
    double seconds = argc > 2 ? atof(argv[2]) : 60.0;
    long step, steps;
    clock_t begin, in_steps = 0;
    int i;

    if (argc < 2 || !(seconds > 0.0)) {
        fprintf(stderr, "four_tires CASE [seconds > 0]\n");
        return 1;
    }
    for (i = 0; i < tires; ++i) {
        tire[i] = tiretherm_open(argv[1], message, sizeof message);
        if (!tire[i]) {
            fail("the case cannot be used", message);
        }
        output[i] = tiretherm_find_output(tire[i], "bulk");
        if (output[i] < 0) {
            output[i] = 0; /* a case without a bulk has some other first output */
        }
        if (tiretherm_output_count(tire[i]) == 0) {
            fail("the case", "it has no output; give it a [[sensor]]");
        }
    }
    printf("%d temperatures a tire; %s in degC\n%6s", (int)tiretherm_temperature_count(tire[0]),
           tiretherm_output_name(tire[0], output[0]), "s");
    for (i = 0; i < tires; ++i) {
        printf("  %12s", names[i]);
    }
    printf("\n");

    steps = (long)(seconds / dt + 0.5);
    for (step = 1; step <= steps; ++step) {
        const double t = dt * (double)step;
        const double corner = sin(0.2 * t); /* > 0: to the left, load on the right */
        const double speed = 45.0 - 15.0 * corner * corner;
        for (i = 0; i < tires; ++i) {
            const double side = i % 2 == 0 ? -1.0 : 1.0;
            set(tire[i], "speed", speed);
            set(tire[i], "vertical_load", 4000.0 + 1500.0 * side * corner);
            set(tire[i], "slip_angle", 0.04 * corner);
            set(tire[i], "lateral_force", 3000.0 * corner * (1.0 + 0.3 * side * corner));
        }
        begin = clock();
        for (i = 0; i < tires; ++i) {
            if (tiretherm_step(tire[i], dt) != TIRETHERM_OK) {
                fail(names[i], tiretherm_message(tire[i]));
            }
        }
        in_steps += clock() - begin;
        if (step % 1000 == 0) {
            printf("%6.0f", t);
            for (i = 0; i < tires; ++i) {
                printf("  %12.2f", tiretherm_output(tire[i], output[i]) - 273.15);
            }
            printf("\n");
        }
    }
    printf("the steps took %.2f %% of a core\n", 100.0 * (double)in_steps / CLOCKS_PER_SEC / seconds);
    for (i = 0; i < tires; ++i) {
        tiretherm_close(tire[i]);
    }
    return 0;
}
