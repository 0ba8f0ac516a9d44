/* Many runners at once: from different starts and with different parameters, over threads, and side by side
 * in the vector registers of the processor. A library of its own, tdmf_slip_ensemble, beside the core. */
#ifndef TDMF_SLIP_ENSEMBLE_H
#define TDMF_SLIP_ENSEMBLE_H

#include "tdmf_slip/reduced_map.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How runners are stepped: one by one, which is the native solver, or so many of them side by side, in the
 * lanes of an instruction set. Results differ by rounding. */
typedef enum {
    TDMF_BEST_INSTRUCTIONS, /* the best that this processor and this build have */
    TDMF_ONE_BY_ONE,        /* the native solver */
    TDMF_TWO_LANES,         /* two lanes, on any processor */
    TDMF_AVX2,              /* four lanes, with fused multiply-add */
    TDMF_AVX512,            /* eight */
    TDMF_INSTRUCTIONS_COUNT
} tdmf_instructions;

/* When a runner counts as settled: its apex is this near that of a gait, over the section's scales; and how
 * many strides it has to get there. The distance has to be so small that the gait attracts everything within
 * it. Without gaits every runner makes the most strides, or falls. */
typedef struct {
    const double (*gaits)[TDMF_SECTION_COUNT]; /* their apices */
    int gait_count;                            /* how many */
    double distance;                           /* a pure number */
    int most_strides;                          /* then the runner is undecided */
    double roughness; /* m: at each apex, the start's too, the ground's height gains a step, normal with mean
                         0 and this standard deviation; see tdmf_ground_step. A runner below its step for a
                         whole stride has fallen. Of the return map only */
    uint64_t seed;    /* of the steps */
} tdmf_ensemble_rules;

/* What takes a runner from apex to apex: the return map, or the reduced map, which goes by an apex's height
 * and speed alone and, so that the apices are of one shape, writes of the leg how it is placed there. */
typedef enum { TDMF_RETURN_MAP, TDMF_REDUCED_MAP } tdmf_ensemble_map;

/* What a runner is given, besides its start. Inputs are held, but for the height of rough ground. */
typedef struct {
    const tdmf_model *model;   /* its parameters */
    tdmf_inputs inputs;        /* throughout */
    tdmf_ensemble_rules rules; /* when it is done */
} tdmf_ensemble_case;

/* What is to be run, and how. */
typedef struct {
    const tdmf_ensemble_case *cases;            /* what the runners are given */
    int case_count;                             /* how many cases */
    const int *case_of;                         /* each runner's case; NULL: all the first */
    const double (*starts)[TDMF_SECTION_COUNT]; /* apices */
    int64_t count;                              /* of runners */
    uint64_t first_number;                      /* of the first; by their numbers rough ground is drawn */
    double relative_tolerance;                  /* as in tdmf_solver */
    int threads;                                /* at the most so many work at once */
    tdmf_instructions instructions;             /* how they are stepped */
    tdmf_ensemble_map map;                      /* by which all of them go */
} tdmf_ensemble;

/* How a runner ends. */
typedef enum {
    TDMF_FATE_SETTLED,   /* on a gait */
    TDMF_FATE_FELL,      /* the body or the leg is down */
    TDMF_FATE_UNDECIDED, /* neither within the strides allowed, or one takes longer than 1e4 sqrt(m/k) */
    TDMF_FATE_NO_START,  /* the start is no apex above the ground, or the inputs are out of range */
    TDMF_FATE_UNSOLVED,  /* the solver could not follow it: too stiff, or too many steps or events */
    TDMF_FATE_NO_STRIDE  /* the reduced map has no stride from the last apex: see tdmf_reduced_outcome */
} tdmf_fate;

/* What became of a runner. */
typedef struct {
    int fate;                                 /* a tdmf_fate */
    int gait;                                 /* which, counted from 0; -1 for none */
    int strides;                              /* how many closed */
    int word_code;                            /* of the last stride, see tdmf_stride */
    double apex[TDMF_SECTION_COUNT];          /* the last; the start while no stride has closed */
    double time, distance;                    /* s and m, that the strides took */
    double work;                              /* J, of all strides, as all that follows: of hip and leg */
    double hip_work, leg_work, external_work; /* J, work of each */
    double damper_loss, friction_loss, impact_loss; /* J, what each took */
} tdmf_ensemble_end;

/* Work done in a run, for whoever wants to know. */
typedef struct {
    int64_t strides, events; /* of all runners */
    int64_t steps;           /* of runners */
    int64_t places;          /* lanes stepped; the steps in them over their number is how full they were */
    int64_t evaluations;     /* coefficients of series, as in tdmf_solver */
} tdmf_ensemble_work;

/* Runs all; `ends` has room for one of each. A runner's end depends neither on its neighbours nor on the
 * number of threads. `work` may be NULL. False, with nothing written, where the instructions are not to be
 * had, the tolerance is not above 0 and below 1, the number of threads is not positive, a runner's case is
 * none of those given, a roughness is not finite, below 0 or above 0 in the reduced map, the map is none, or
 * there is no memory. */
bool tdmf_run_ensemble(const tdmf_ensemble *ensemble, tdmf_ensemble_end *ends, tdmf_ensemble_work *work);

/* The step of rough ground, over its roughness, with which a runner's stride begins: the first stride is 0.
 * Normal with mean 0 and standard deviation 1, and the same bits on every machine. */
double tdmf_ground_step(uint64_t seed, uint64_t runner, uint32_t stride);

/* Whether this processor and this build have them. */
bool tdmf_has_instructions(tdmf_instructions instructions);

/* Which TDMF_BEST_INSTRUCTIONS stands for. */
tdmf_instructions tdmf_best_instructions(void);

/* "avx512" and so on. */
const char *tdmf_instructions_name(tdmf_instructions instructions);

#ifdef __cplusplus
}
#endif
#endif
