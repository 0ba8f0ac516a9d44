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

/* The ends by an instruction set, until the end of the test. */
tdmf_ensemble_end *ends_of(crowd *crowd, tdmf_instructions instructions);

/* Asserts that runners end alike, bit for bit, in any number of threads and, every `step`-th of them, alone.
 * Returns their ends. */
const tdmf_ensemble_end *assert_independent_runners(crowd *crowd, int step);

/* Strides of a runner by the native solver; at each apex a function sets parameters and inputs, if there is
 * one, and the ground steps by the roughness of the crowd's first case. */
enum { BY_HAND_LIMIT = 12 };
typedef struct {
    int begun, closed;
    int waited, passed; /* strides that began with a new line waiting, and those in which it took effect */
    double heights[BY_HAND_LIMIT];      /* of the ground, for each stride begun */
    tdmf_motion motions[BY_HAND_LIMIT]; /* ends of closed strides */
} strides_by_hand;

typedef void set_at_apex(void *context, int number, int stride, const double apex[TDMF_SECTION_COUNT],
                         tdmf_parameters *parameters, tdmf_inputs *inputs);

void stride_by_hand(const crowd *crowd, int number, set_at_apex *set, void *context,
                    strides_by_hand *by_hand);

/* Asserts that the crowd's noted strides and its end are those by hand. */
void assert_strides_by_hand(const crowd *crowd, int number, const strides_by_hand *by_hand);

/* Asserts that its ensemble is refused, and that nothing is written. */
void assert_crowd_is_refused(crowd *crowd);

/* Loops over the instruction sets that the processor has, one by one first. */
#define FOR_INSTRUCTIONS(set)                                                                                \
    for (tdmf_instructions set = TDMF_ONE_BY_ONE; set < TDMF_INSTRUCTIONS_COUNT; set = next_instructions(set))

tdmf_instructions next_instructions(tdmf_instructions set);

#endif
