/* Runners with a case each, which an ensemble runs by any of the processor's instruction sets. */
#ifndef TDMF_TESTS_CROWD_H
#define TDMF_TESTS_CROWD_H

#include "tdmf_slip/ensemble.h"

typedef struct {
    int count;
    tdmf_model *models;
    tdmf_ensemble_case *cases;
    int *case_of;
    double (*starts)[TDMF_POINT_LIMIT];
    tdmf_ensemble_end *ends;
    tdmf_ensemble_stride *strides; /* see note_strides */
    tdmf_ensemble_checkpoint *checkpoints;
    tdmf_ensemble ensemble; /* runs in one thread */
} crowd;

/* Default runners at the apex of the default gait, until the end of the test. */
crowd *make_crowd(int count, int max_strides, double relative_tolerance);

/* Places one of them; asserts that its parameters are accepted. */
void place_runner(crowd *crowd, int number, const tdmf_parameters *parameters, const tdmf_inputs *inputs,
                  const double section[TDMF_SECTION_COUNT]);

/* Gives all runners the first case, which may be changed. */
tdmf_ensemble_case *share_case(crowd *crowd);

/* Has the ensemble record up to `count` strides and a checkpoint of each runner. */
void note_strides(crowd *crowd, int count);

/* Runs all runners to their ends; asserts that the ensemble is accepted. */
void run_crowd(crowd *crowd, tdmf_instructions instructions);

/* Asserts that its ensemble is refused, and that nothing is written. */
void assert_crowd_is_refused(crowd *crowd);

/* Loops over the instruction sets that the processor has, one by one first. */
#define FOR_INSTRUCTIONS(set)                                                                                \
    for (tdmf_instructions set = TDMF_ONE_BY_ONE; set < TDMF_INSTRUCTIONS_COUNT; set = next_instructions(set))

tdmf_instructions next_instructions(tdmf_instructions set);

#endif
