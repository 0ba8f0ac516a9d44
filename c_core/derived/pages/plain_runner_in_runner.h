/* Places of what PlainRunner has in the tables of Runner. */
#ifndef PLAIN_RUNNER_IN_RUNNER_H
#define PLAIN_RUNNER_IN_RUNNER_H

static const int modes_in_whole[] = {0, 1, 2, 3, 4, 5};
static const int parameters_in_whole[] = {8, 9, 10, 11, 12, 13, 14, 16, 20, 21, 22, 23, 24, 26};
static const int states_in_whole[] = {0, 1, 2, 3, 4, 5, 6, 7, 9, 10, 11, 13, 14, 15, 16, 17, 18, 19, 20, 21,
    22, 23, 24, 25, 26, 27, 28, 29, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 59, 60,
    61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 83, 87, 88, 89, 90, 92, 93,
    94, 95, 96, 97, 98, 99, 100, 101, 103};
static const int events_in_whole[] = {4, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 19, 20, 21, 23, 24};

#endif
