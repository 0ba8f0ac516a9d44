/* Many runners at once: from different starts and with different parameters, over threads, and side by side
 * in the vector registers of the processor. A library of its own, tdmf_slip_ensemble, beside the core. */
#ifndef TDMF_SLIP_ENSEMBLE_H
#define TDMF_SLIP_ENSEMBLE_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/page.h"
#include "tdmf_slip/return_map.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How runners are stepped: one by one, or so many of them side by side, in the lanes of an instruction set.
 * Results are the same, bit for bit. */
typedef enum {
    TDMF_BEST_INSTRUCTIONS, /* the best that this processor and this build have */
    TDMF_ONE_BY_ONE,        /* without lanes */
    TDMF_TWO_LANES,         /* two lanes, on any processor */
    TDMF_AVX2,              /* four lanes */
    TDMF_AVX512,            /* eight */
    TDMF_INSTRUCTIONS_COUNT
} tdmf_instructions;

/* Coordinates of a point of a section, of any model, at the most. Rows of points are as wide. */
enum { TDMF_POINT_LIMIT = 8 };

/* The number of a setting of the runner, which may be set anew at each apex: a tunable parameter or an input,
 * by its name in the unit, as in "hip.kp" and "ground.friction". -1 where there is none of this name, or it
 * is NULL. No law sets more than TDMF_SETTING_LIMIT, which is how many there are.
 *
 * Settings of another page are its parameters by their numbers, and its states by theirs after these. */
TDMF_API int tdmf_setting_of(const char *name);

/* A law from apex to settings, which a controller has that measures each apex and sets what the stride from
 * there is made with:
 *
 *     setting i = nominal i + sum of gain ij (measured j - apex j), not below low i nor above high i,
 *     measured j = coordinate j of the section + noise j tdmf_sensor_noise(seed, runner, stride, j).
 *
 * The coordinates are those of the ensemble's apices: heights above the ground in force, as a sensor sees it
 * before the ground steps. Gain and noise of coordinates that the section does not have are 0. */
typedef struct {
    int count;                              /* of settings, up to TDMF_SETTING_LIMIT */
    const int *settings;                    /* each by tdmf_setting_of, and not twice */
    double apex[TDMF_POINT_LIMIT];          /* where they are nominal */
    const double *nominal;                  /* values, in the units of the settings, as the limits */
    const double (*gain)[TDMF_POINT_LIMIT]; /* per m, m/s and so on */
    const double *low, *high;               /* within the ranges of the settings */
    double noise[TDMF_POINT_LIMIT];         /* standard deviations of what the sensor adds */
    uint64_t seed;                          /* of the noise */
} tdmf_affine_law;

/* What the law sets, `count` values, for one of the strides of a runner: the first stride is 0. */
TDMF_API void tdmf_affine_settings(const tdmf_affine_law *law, const double apex[TDMF_POINT_LIMIT],
                                   uint64_t runner, uint32_t stride, double *values);

/* A ball of attraction: apices x, the gait's being g, with a Euclidean norm of matrix (x - g) of 1 or less.
 */
typedef struct {
    double matrix[TDMF_POINT_LIMIT][TDMF_POINT_LIMIT]; /* per m, m/s and so on; rows and columns of the
                                                          section's coordinates */
} tdmf_ball;

/* Terrain: level segments of one length, segment k from x = k length up to, without it, (k + 1) length;
 * an edge belongs to the segment ahead. The foot comes down on the segment below it, and no edge is missed. A
 * stance belongs to the segment on which it began: a foot that slips over an edge keeps its height and its
 * friction until it lifts off. A foot that swings into the face of a segment passes that step on its way up;
 * until then the segment from which it came goes on below it. With `trips` a foot that swings or slips into a
 * face has fallen there. */
#define TDMF_MIN_SEGMENT 1e-3 /* over l0 */
typedef struct {
    double length;         /* m, of a segment; 0: the ground is set by stride */
    const double *heights; /* m, over the inputs' height; after the last the first comes again. Runner n
                              begins on segment n. NULL: heights are drawn as steps by stride are, each by the
                              number of its segment, with the roughness as their standard deviation */
    int64_t height_count;  /* how many there are; 0 where heights is NULL */
} tdmf_terrain;

/* When a runner counts as settled: its apex is this near that of a gait, over the section's scales, or in the
 * gait's ball; and how many strides it has to get there. Distance and balls have to be so small that the gait
 * attracts everything within. Without gaits every runner makes the most strides, or falls. */
typedef struct {
    const double (*gaits)[TDMF_POINT_LIMIT]; /* their apices */
    int gait_count;                          /* how many */
    double distance;                         /* a pure number */
    const tdmf_ball *balls;                  /* one for each gait, the start's apex may be in it; or NULL */
    int max_strides;                         /* then the runner is undecided */
    double roughness; /* m: at each apex, the start's too, the ground's height gains a step, normal with mean
                         0 and this standard deviation; see tdmf_ground_step. A runner below its step for a
                         whole stride has fallen. Of the return map only */
    /* Steps that hang together: a step is the roughness times the sum of weight j times the deviate of j
     * strides before. NULL: each is its own deviate. */
    const double *step_weights;
    int step_weight_count;
    bool trips; /* a foot that is below a step as it comes has met it: a fall. Else it may pass it on its way
                   up */
    /* The friction of a stride is the case's times exp(friction_spread times such a sum, of deviates of its
     * own), within its range; see tdmf_friction_deviate. Of the return map only */
    double friction_spread;
    const double *friction_weights;
    int friction_weight_count;
    /* With a length, heights and frictions are of segments, no longer of strides. Ground is level then and
     * the body is not pushed; heights of apices are above the segment below the foot. Of the return map only
     */
    tdmf_terrain terrain;
    uint64_t seed;              /* of steps and friction */
    const tdmf_affine_law *law; /* by which it sets at each apex, the start's too; NULL: nothing */
} tdmf_ensemble_rules;

/* What a runner is given, besides its start. Inputs are held, but for those that are set at apices and for
 * the height of rough ground. */
typedef struct {
    const tdmf_model *model;           /* its parameters */
    tdmf_inputs inputs;                /* throughout */
    const double *parameters, *states; /* or of another page: the numbers with which each stride begins */
    tdmf_ensemble_rules rules;         /* when it is done */
} tdmf_ensemble_case;

/* Settings that are given for each runner and stride. They are in force from the apex on at which the stride
 * begins; a runner whose ground still waits at the next is below it and has fallen. */
typedef struct {
    int count;            /* of settings */
    const int *settings;  /* each by tdmf_setting_of, not twice, and none that a law sets */
    int first, strides;   /* of so many strides from this one on; those that follow are made as the last */
    const double *values; /* of each runner, of each of these strides: all settings */
} tdmf_given_settings;

/* One stride of a runner. */
typedef struct {
    int began;                                      /* 1 where it did: else all of it is as it was */
    double apex[TDMF_POINT_LIMIT];                  /* at which it closed */
    double foot_x;                                  /* m, where the foot is there */
    tdmf_stride stride;                             /* its quantities */
    double liftoff_angle;                           /* theta_LO, rad */
    double external_work;                           /* J, of the stride, as the losses */
    double damper_loss, friction_loss, impact_loss; /* J in the stride */
    double ground_height;                           /* m, that was set at the apex at which it began */
    double set[TDMF_SETTING_LIMIT];                 /* there by the law, in the order of its settings */
} tdmf_ensemble_stride;

/* Where a runner stands that has made the most strides, to go on from. Its states are of use to the library
 * only. */
enum { TDMF_CHECKPOINT_STATES = 112 };
typedef struct {
    bool stands;                           /* else its run is over */
    int mode, chain;                       /* at the apex */
    double time, time_rest;                /* s */
    double ground_height, ground_slope;    /* m and rad, of the ground at the apex */
    uint64_t taken, above, late;           /* bits of events: taken; with a guard seen above zero; late */
    double states[TDMF_CHECKPOINT_STATES]; /* of its page */
} tdmf_ensemble_checkpoint;

/* What is noted of a page's strides besides, in rows of all runners and their strides. */
typedef struct {
    int count;             /* states */
    const int *states;     /* their numbers */
    double *values;        /* at the crossing where the stride closes */
    int event_room;        /* events of a stride that there is room for */
    unsigned char *events; /* their numbers, each plus 1; 0 behind the last */
} tdmf_ensemble_notes;

/* What is to be run, and how. */
typedef struct {
    const tdmf_page *page; /* a model that runs by the return map of a section, always from a point of it on;
                              NULL: the runner, which goes by `map` */
    int section;           /* of the page */
    const tdmf_ensemble_notes *notes;         /* of a page; or NULL */
    const tdmf_ensemble_case *cases;          /* what the runners are given */
    int case_count;                           /* how many cases */
    const int *case_of;                       /* each runner's case; NULL: all the first */
    const double (*starts)[TDMF_POINT_LIMIT]; /* apices */
    const double *foot_x;                     /* m, where their feet are; NULL: 0 */
    int64_t count;                            /* of runners */
    uint64_t first_number;                    /* of the first; by their numbers rough ground is drawn */
    double relative_tolerance;                /* as in tdmf_solver */
    long step_limit;                          /* of each runner, as in tdmf_solver; 0: TDMF_STEP_LIMIT */
    int threads;                              /* so many work at once, but no more than runners */
    tdmf_instructions instructions;           /* how they are stepped */
    tdmf_apex_map map;                        /* by which all of them go, without a page */
    const tdmf_given_settings *given;         /* or NULL: none are */
    tdmf_ensemble_stride *strides;            /* what is noted, as strides begin and close; or NULL */
    int first_stride, stride_count; /* of each runner: the first that is noted, and how many from it on */
    tdmf_ensemble_checkpoint *checkpoints; /* of each runner, written where it stands; or NULL */
    bool goes_on;    /* from checkpoints and ends of an earlier call, with a larger number of most strides */
    const int *stop; /* NULL, or what another thread may set to another value than 0 meanwhile: then no runner
                        begins any more, and those under way end with their strides */
} tdmf_ensemble;

/* How a runner ends. */
typedef enum {
    TDMF_FATE_SETTLED,   /* on a gait */
    TDMF_FATE_FELL,      /* the body or the leg is down */
    TDMF_FATE_UNDECIDED, /* neither within the strides allowed, or one takes longer than 1e4 sqrt(m/k) */
    TDMF_FATE_NO_START,  /* the start is no apex above the ground, or the inputs are out of range */
    TDMF_FATE_UNSOLVED,  /* the solver could not follow it: too stiff, or too many steps or events, see
                            TDMF_STEP_LIMIT */
    TDMF_FATE_NO_STRIDE, /* the reduced map has no stride from the last apex: see tdmf_return_outcome */
    TDMF_FATE_STOPPED    /* the run was stopped before */
} tdmf_fate;

/* Tells what became of a runner. */
typedef struct {
    int fate;                                 /* a tdmf_fate */
    int gait;                                 /* which, counted from 0; -1 for none */
    int strides;                              /* how many closed */
    int word_code;                            /* of the last stride, see tdmf_stride */
    double apex[TDMF_POINT_LIMIT];            /* the last; the start while no stride has closed */
    double foot_x;                            /* m, where the foot is there */
    double time, distance;                    /* s and m, that the strides took */
    double work;                              /* J, of all strides, as all that follows: of hip and leg */
    double hip_work, leg_work, external_work; /* J, work of each */
    double damper_loss, friction_loss, impact_loss; /* J, what each took */
} tdmf_ensemble_end;

/* Work done in a run. */
typedef struct {
    int64_t strides, events; /* of all runners */
    int64_t steps;           /* of runners */
    int64_t lane_steps;      /* lanes stepped; the steps in them over their number is how full they were */
    int64_t evaluations;     /* coefficients of series, as in tdmf_solver */
    int64_t layer_steps;     /* of the steps, as in tdmf_solver */
    int64_t begun; /* runners, from the first on: of the others, where the run was stopped, no end is
                      written */
} tdmf_ensemble_work;

/* Runs all; `ends` has room for one of each. A runner's end depends neither on its neighbours nor on the
 * number of threads. `work` may be NULL.
 *
 * Refuses, with nothing written and a refusal that says why, if:
 *   - this build does not have the instructions, or there is no memory;
 *   - the tolerance is not above 0 and below 1, the step limit is below 0, or the number of threads is not
 *     positive;
 *   - the map is not one of its enumerators;
 *   - a number of elements is below 0, or their array is NULL;
 *   - a runner's case is not one of those given, or the position of its foot is out of range;
 *   - a case has a patch of ground together with gaits to settle on or the reduced map;
 *   - a roughness is not finite, is below 0, or is above 0 in the reduced map;
 *   - weights or a spread are not finite, or the spread is below 0, or above 0 in the reduced map;
 *   - a setting does not exist, is set twice, or gets a value out of its range;
 *   - heights of rough ground, or a friction that is drawn, are also settings;
 *   - a segment of terrain has a length that is not finite or below TDMF_MIN_SEGMENT l0, or a height that is
 *     not finite or beyond 1e9 m;
 *   - a page, which has no drawn ground and no terrain, is given one;
 *   - terrain comes with a slope, a push, gaits to settle on, the reduced map, or settings of height, slope
 * or push;
 *   - a number of a law or a ball is beyond 1e100, or a law's limits are not a range;
 *   - a checkpoint to resume from is in a mode that its page does not have. */
TDMF_API tdmf_refusal tdmf_run_ensemble(const tdmf_ensemble *ensemble, tdmf_ensemble_end *ends,
                                        tdmf_ensemble_work *work);

/* Strides of many runners, and how they are made. */
typedef struct {
    const tdmf_system *systems;                 /* of each runner */
    const double (*sections)[TDMF_POINT_LIMIT]; /* apices from which the strides start */
    const double *until;                        /* s, that each stride may take; 0: 1e4 sqrt(m/k) */
    int64_t count;                              /* of strides */
    tdmf_apex_map map;                          /* by which all of them are made */
    bool derivatives, measures;                 /* as in tdmf_stride_request */
    const tdmf_seed *seeds;                     /* along which all strides are differentiated */
    int seed_count;                             /* how many */
    int threads;                                /* so many work at once */
} tdmf_stride_batch;

/* Makes strides side by side in lanes. Each result is that of tdmf_run_stride. It depends neither on its
 * neighbours nor on the number of threads. The solver's counters stay as they are. Refuses a batch as a
 * whole, with nothing written, and a stride by its own result. */
TDMF_API tdmf_refusal tdmf_run_strides(const tdmf_solver *solver, const tdmf_stride_batch *batch,
                                       tdmf_return *results);

/* The step of rough ground, over its roughness, with which a runner's stride begins: the first stride is 0.
 * Normal with mean 0 and standard deviation 1, and the same bits on every machine. */
TDMF_API double tdmf_ground_step(uint64_t seed, uint64_t runner, uint32_t stride);

/* The logarithm of the ratio of a stride's friction to the friction about which it is drawn, divided by the
 * spread. It has the distribution of tdmf_ground_step and is independent of it. */
TDMF_API double tdmf_friction_deviate(uint64_t seed, uint64_t runner, uint32_t stride);

/* The noise of a sensor in a coordinate of the section, divided by its standard deviation. It has the
 * distribution of tdmf_ground_step and is independent of it, also if the seeds are the same. */
TDMF_API double tdmf_sensor_noise(uint64_t seed, uint64_t runner, uint32_t stride, int coordinate);

/* Whether this processor and this build have them. */
TDMF_API bool tdmf_has_instructions(tdmf_instructions instructions);

/* Gives the name of the instructions, as "avx512". */
TDMF_API const char *tdmf_instructions_name(tdmf_instructions instructions);

#ifdef __cplusplus
}
#endif
#endif
