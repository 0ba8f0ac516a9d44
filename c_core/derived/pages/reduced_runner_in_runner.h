/* Places of what ReducedRunner has in the tables of Runner. */
#ifndef REDUCED_RUNNER_IN_RUNNER_H
#define REDUCED_RUNNER_IN_RUNNER_H

static const int reduced_modes_in_whole[] = {0, -1, 3, 4, 1, 2, -1, -1, 6};
static const int reduced_parameters_in_whole[] = {0, 1, 8, 9, 10, 11, 12, 13, 14, 15, 17, 18, 19, 20, 23, 25,
    27, 28};
static const int reduced_states_in_whole[] = {0, 1, 2, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20,
    21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46,
    47, 48, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79,
    80, 82, 83, 87, 88, 89, 90, 92, 93, 94, 95, 96, 97, 101, 103};
static const int reduced_events_in_whole[] = {4, 7, 8, 9, 11, 14, 15, 16, 17, 18, 19, 20, 21};

#endif
