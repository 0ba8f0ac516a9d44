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

/* Instructions by which runners are stepped: one by one, or several side by side in the lanes of vector
 * registers. Results are the same, bit for bit. */
typedef enum {
    TDMF_BEST_INSTRUCTIONS, /* the best that this processor and this build have */
    TDMF_ONE_BY_ONE,        /* without lanes */
    TDMF_TWO_LANES,         /* two lanes, on any processor */
    TDMF_AVX2,              /* four lanes */
    TDMF_AVX512,            /* eight lanes */
    TDMF_INSTRUCTIONS_COUNT
} tdmf_instructions;

/* The largest number of coordinates of a section, and the width of every row of points. */
enum { TDMF_POINT_LIMIT = 8 };

/* Returns the number of a setting: a tunable parameter or an input, which may change at each apex. Its name
 * is that of the unit, such as "hip.kp" or "ground.friction". Returns -1 if there is no such setting or the
 * name is NULL. There are TDMF_SETTING_LIMIT settings.
 *
 * The settings of another page are its parameters by their numbers, then its states, counted on from there.
 */
TDMF_API int tdmf_setting_of(const char *name);

/* A controller that measures each apex and sets values for the stride that begins there:
 *
 *     setting i = nominal i + sum of gain ij (measured j - apex j), not below low i nor above high i,
 *     measured j = coordinate j of the section + noise j tdmf_sensor_noise(seed, runner, stride, j).
 *
 * The coordinates are those of the ensemble's apices: heights above the ground in force, as a sensor sees it
 * before the ground steps. Gain and noise of coordinates that the section does not have are 0. */
typedef struct {
    int count;                              /* number of settings, up to TDMF_SETTING_LIMIT */
    const int *settings;                    /* their numbers, see tdmf_setting_of; none twice */
    double apex[TDMF_POINT_LIMIT];          /* apex at which the settings are nominal */
    const double *nominal;                  /* nominal values, in the units of the settings */
    const double (*gain)[TDMF_POINT_LIMIT]; /* a row for each setting, per m, m/s and so on */
    const double *low, *high;               /* limits, within the ranges of the settings */
    double noise[TDMF_POINT_LIMIT];         /* standard deviations of the sensor's noise */
    uint64_t seed;                          /* seed of the noise */
} tdmf_affine_law;

/* Writes the `count` values that the law sets for one stride of a runner; the first stride is 0. */
TDMF_API void tdmf_affine_settings(const tdmf_affine_law *law, const double apex[TDMF_POINT_LIMIT],
                                   uint64_t runner, uint32_t stride, double *values);

/* A ball of attraction: all apices x for which the Euclidean norm of matrix (x - g) is at most 1, where g is
 * the gait's apex. */
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
    double length;         /* length of a segment, m; 0: there is no terrain */
    const double *heights; /* heights over ground.height, m, repeated after the last. Runner n begins on
                              segment n. NULL: each height is drawn by the number of its segment, with the
                              roughness as its standard deviation */
    int64_t height_count;  /* number of heights; 0 if heights is NULL */
} tdmf_terrain;

/* Rules of a case: when a runner is done, the ground that it runs on, and the law that it obeys.
 *
 * A runner has settled when its apex is near that of a gait, or in the gait's ball. The distance and the
 * balls must be so small that the gait attracts everything within. Without gaits every runner makes
 * `max_strides` or falls. */
typedef struct {
    const double (*gaits)[TDMF_POINT_LIMIT]; /* apices of the gaits */
    int gait_count;                          /* number of gaits */
    double distance;        /* largest distance of an apex from a gait's, in the section's scales */
    const tdmf_ball *balls; /* a ball for each gait, which may contain the start; or NULL */
    int max_strides;        /* after so many strides the runner is undecided */
    double roughness; /* standard deviation of steps, m. At each apex, the first one included, the ground's
                         height gains a step, see tdmf_ground_step. A runner below its step for a whole stride
                         has fallen. Only with the return map */
    /* Weights of correlated steps: a step is the roughness times the sum of weight j times the deviate of j
     * strides before. NULL: each step is its own deviate. */
    const double *step_weights;
    int step_weight_count;
    bool trips; /* a foot that is below a step when the step comes has tripped and fallen; else it may pass
                   the step on its way up */
    /* The friction of a stride is ground.friction times exp(friction_spread times a sum of deviates with
     * these weights), within its range; see tdmf_friction_deviate. Only with the return map. */
    double friction_spread;
    const double *friction_weights;
    int friction_weight_count;
    /* With a terrain, heights and frictions belong to segments instead of strides. The ground is level and
     * the body is not pushed. Heights of apices count from the segment below the foot. Only with the return
     * map. */
    tdmf_terrain terrain;
    uint64_t seed;              /* seed of steps and friction */
    const tdmf_affine_law *law; /* law that sets values at each apex, the first one included; or NULL */
} tdmf_ensemble_rules;

/* A case: the runner and its rules, which several members may share. Inputs are held, except those that are
 * set at apices and the height of rough ground. */
typedef struct {
    const tdmf_model *model;           /* its parameters */
    tdmf_inputs inputs;                /* inputs, held throughout */
    const double *parameters, *states; /* numbers of another page, with which its runs begin */
    tdmf_ensemble_rules rules;         /* rules of the run */
} tdmf_ensemble_case;

/* Settings that are given for each runner and stride. They are in force from the apex on at which the stride
 * begins; a runner whose ground still waits at the next is below it and has fallen. */
typedef struct {
    int count;            /* number of settings */
    const int *settings;  /* settings by tdmf_setting_of: none twice, and none that a law sets */
    int first, strides;   /* first stride with given values, and their number; later ones repeat the last */
    const double *values; /* all settings, by runner and stride */
} tdmf_given_settings;

/* One stride of a runner. */
typedef struct {
    int began;                                      /* 1 if the stride began; else the row is left alone */
    double apex[TDMF_POINT_LIMIT];                  /* apex at which the stride closed */
    double foot_x;                                  /* position of the foot at that apex, m */
    tdmf_stride stride;                             /* quantities of the stride */
    double liftoff_angle;                           /* theta_LO, rad */
    double external_work;                           /* external work in the stride, J */
    double damper_loss, friction_loss, impact_loss; /* losses in the stride, J */
    double ground_height;                           /* ground height set at the stride's first apex, m */
    double set[TDMF_SETTING_LIMIT]; /* values set by the law there, in the order of its settings */
} tdmf_ensemble_stride;

/* A checkpoint: where a runner stands after `max_strides`, so that a later call can go on from there. Its
 * content is for the library only. */
enum { TDMF_CHECKPOINT_STATES = 128 };
typedef struct {
    bool stands; /* true while the runner can go on; false if its run is over */
    int parameter_count, state_count, mode_count, event_count; /* sizes of its model */
    int section;                           /* section of the page; the runner has one only */
    int mode, chain;                       /* mode, and length of the chain of events, at the apex */
    double time, time_rest;                /* s */
    double ground_height, ground_slope;    /* ground at the apex, m and rad */
    uint64_t taken, above, late;           /* bits of events: taken; with a guard seen above zero; late */
    double states[TDMF_CHECKPOINT_STATES]; /* states of the runner's page */
} tdmf_ensemble_checkpoint;

/* States and events of a page's strides that are recorded in `strides`, a row for each runner and stride. */
typedef struct {
    int count;             /* states */
    const int *states;     /* their numbers */
    double *values;        /* values at the crossing where the stride closes */
    int event_room;        /* number of events of a stride that there is room for */
    unsigned char *events; /* their numbers, each plus 1; 0 behind the last */
} tdmf_ensemble_notes;

/* An ensemble: the runners, and how they are run.
 *
 *     tdmf_ensemble_case level = {.model = &model, .inputs = tdmf_default_inputs()};
 *     level.rules.max_strides = 100;
 *     const tdmf_ensemble ensemble = {.cases = &level, .case_count = 1, .starts = starts, .count = 1000,
 *                                     .relative_tolerance = 1e-8, .threads = 4};
 *     const tdmf_refusal refusal = tdmf_run_ensemble(&ensemble, ends, NULL);
 */
typedef struct {
    const tdmf_page *page; /* a model that runs from points of a section. Its strides follow each other if its
                              ground may vary; else each is a run of its own. NULL: the runner, which goes by
                              `map` */
    int section;           /* section of the page */
    const tdmf_ensemble_notes *notes;         /* notes of a page; or NULL */
    const tdmf_ensemble_case *cases;          /* cases of the runners */
    int case_count;                           /* number of cases */
    const int *case_of;                       /* each runner's case; NULL: all the first */
    const double (*starts)[TDMF_POINT_LIMIT]; /* apices */
    const double *foot_x;                     /* positions of the feet, m; NULL: 0 */
    int64_t count;                            /* number of runners */
    uint64_t first_number;            /* number of the first runner; rough ground is drawn by number */
    double relative_tolerance;        /* tolerance of a step, see tdmf_solver */
    long step_limit;                  /* step limit of each runner, see tdmf_solver; 0: TDMF_STEP_LIMIT */
    int threads;                      /* number of threads, at most one for each runner */
    tdmf_instructions instructions;   /* instructions that step the runners */
    tdmf_apex_map map;                /* map of all runners, without a page */
    const tdmf_given_settings *given; /* given settings; or NULL */
    tdmf_ensemble_stride *strides;    /* records of strides, written as they begin and close; or NULL */
    int first_stride, stride_count; /* first recorded stride of each runner, and number of recorded strides */
    tdmf_ensemble_checkpoint *checkpoints; /* checkpoint of each runner, written at its end; or NULL */
    bool goes_on;    /* resumes from checkpoints and ends of an earlier call, with a larger `max_strides` */
    const int *stop; /* NULL, or a flag that another thread may set to a value other than 0: no further runner
                        begins, and runners under way end with their strides */
} tdmf_ensemble;

/* The fate of a runner. */
typedef enum {
    TDMF_FATE_SETTLED,   /* it is on a gait */
    TDMF_FATE_FELL,      /* the body or the leg is down */
    TDMF_FATE_UNDECIDED, /* neither within max_strides, or a stride takes longer than 1e4 sqrt(m/k) */
    TDMF_FATE_NO_START,  /* the start is no apex above the ground, or the inputs are out of range */
    TDMF_FATE_UNSOLVED,  /* the solver could not follow it: too stiff, or too many steps or events, see
                            TDMF_STEP_LIMIT */
    TDMF_FATE_NO_STRIDE, /* the reduced map has no stride from the last apex: see tdmf_return_outcome */
    TDMF_FATE_STOPPED    /* the run was stopped before */
} tdmf_fate;

/* The end of a runner. */
typedef struct {
    int fate;                                       /* a tdmf_fate */
    int gait;                                       /* number of the gait it settled on; -1: none */
    int strides;                                    /* number of strides that closed */
    int word_code;                                  /* code of the last stride's word, see tdmf_stride */
    double apex[TDMF_POINT_LIMIT];                  /* the last apex; the start if no stride has closed */
    double foot_x;                                  /* place of the foot there, m */
    double time, distance;                          /* duration and length of all strides, s and m */
    double work;                                    /* net work of hip and leg in all strides, J */
    double hip_work, leg_work, external_work;       /* work of hip, leg and external forces, J */
    double damper_loss, friction_loss, impact_loss; /* energy lost in damper, by friction, at impacts, J */
} tdmf_ensemble_end;

/* Work done in a run. */
typedef struct {
    int64_t strides, events; /* strides and events of all runners */
    int64_t steps;           /* steps of all runners */
    int64_t lane_steps;      /* lanes stepped; the steps in them over their number is how full they were */
    int64_t evaluations;     /* coefficients of series, as in tdmf_solver */
    int64_t layer_steps;     /* steps in the layer, as in tdmf_solver */
    int64_t begun;           /* runners that have begun, from the first one on; the others have no end */
} tdmf_ensemble_work;

/* Returns whether the ground of a page may vary in an ensemble, because it is that of the runner's page.
 * False for NULL. */
TDMF_API bool tdmf_page_has_ground(const tdmf_page *page);

/* Runs all runners and writes the end of each into `ends`. An end depends neither on the runner's neighbours
 * nor on the number of threads. `work`, which may be NULL, receives the work done.
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
 *   - a model whose ground cannot vary is given drawn ground, a terrain or positions of feet;
 *   - terrain comes with a slope, a push, gaits to settle on, the reduced map, or settings of height, slope
 * or push;
 *   - a number of a law or a ball is beyond 1e100, or a law's limits are not a range;
 *   - there are notes without recorded strides;
 *   - a checkpoint to resume from is of another model or section, or in a mode that its page does not have.
 */
TDMF_API tdmf_refusal tdmf_run_ensemble(const tdmf_ensemble *ensemble, tdmf_ensemble_end *ends,
                                        tdmf_ensemble_work *work);

/* Strides of many runners, and how they are made. */
typedef struct {
    const tdmf_system *systems;                 /* one system for each runner */
    const double (*sections)[TDMF_POINT_LIMIT]; /* apices from which the strides start */
    const double *until;                        /* time limit of each stride, s; 0: 1e4 sqrt(m/k) */
    int64_t count;                              /* number of strides */
    tdmf_apex_map map;                          /* map of all strides */
    bool derivatives, measures;                 /* results wanted, see tdmf_stride_request */
    const tdmf_seed *seeds;                     /* directions of the derivatives of all strides */
    int seed_count;                             /* number of seeds */
    int threads;                                /* number of threads */
} tdmf_stride_batch;

/* Makes strides side by side in lanes. Each result is that of tdmf_run_stride. It depends neither on its
 * neighbours nor on the number of threads. The solver's counters stay as they are. Refuses a batch as a
 * whole, with nothing written, and a stride by its own result. */
TDMF_API tdmf_refusal tdmf_run_strides(const tdmf_solver *solver, const tdmf_stride_batch *batch,
                                       tdmf_return *results);

/* Runs from points of a section. Each ends as tdmf_page_stride would end it, bit for bit; so results do not
 * depend on the number of runs, lanes or threads. */
typedef struct {
    const tdmf_page_map *map;   /* map of all runs; its parameters and states are those of the first run */
    int64_t count;              /* runs */
    int64_t parameters_of_each; /* numbers from the parameters of a run to those of the next; 0: all share */
    int64_t states_of_each;     /* numbers from the states of a run to those of the next; 0: all share */
    const double *points;       /* a row for each run */
    double *states, *d_states;  /* rows at the end, as of tdmf_page_stride; `d_states` may be NULL */
    tdmf_page_end *ends;        /* one for each run */
    const int *cancel;          /* NULL; or runs end as cancelled once it points to another value than 0 */
    int threads;                /* number of threads */
} tdmf_page_batch;

/* Makes all strides, with events in rows of `event_room`. False if the map is refused; then nothing is
 * written. A run whose own numbers are refused has that outcome. */
TDMF_API bool tdmf_page_strides(const tdmf_page_batch *batch);

/* The step of rough ground, over its roughness, with which a runner's stride begins: the first stride is 0.
 * Normal with mean 0 and standard deviation 1, and the same bits on every machine. */
TDMF_API double tdmf_ground_step(uint64_t seed, uint64_t runner, uint32_t stride);

/* The logarithm of the ratio of a stride's friction to the friction about which it is drawn, divided by the
 * spread. It has the distribution of tdmf_ground_step and is independent of it. */
TDMF_API double tdmf_friction_deviate(uint64_t seed, uint64_t runner, uint32_t stride);

/* The noise of a sensor in a coordinate of the section, divided by its standard deviation. It has the
 * distribution of tdmf_ground_step and is independent of it, also if the seeds are the same. */
TDMF_API double tdmf_sensor_noise(uint64_t seed, uint64_t runner, uint32_t stride, int coordinate);

/* Returns whether this processor and this build have the instructions. */
TDMF_API bool tdmf_has_instructions(tdmf_instructions instructions);

/* Returns the name of the instructions, such as "avx512". */
TDMF_API const char *tdmf_instructions_name(tdmf_instructions instructions);

#ifdef __cplusplus
}
#endif
#endif
