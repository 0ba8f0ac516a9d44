/* An instance of the unit for both versions of FMI.
 *
 * An instance is one struct: the run, which saved states copy, the values that follow from the run, and what
 * belongs to the importer. A variable's storage and offset say where its value is, see access.c. A trial of
 * something that may be refused is made on a copy of the instance or of its run. */
#ifndef TDMF_FMU_INSTANCE_H
#define TDMF_FMU_INSTANCE_H

#include "variables.h"

#include <math.h>

/* Calls of FMI have arguments that the unit does not need. */
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wunused-parameter"
#elif defined(_MSC_VER)
#pragma warning(disable : 4100)
#endif

enum { WORD_CAPACITY = 64, TEXT_CAPACITY = 256, NUMBER_CAPACITY = 32, VALUE_CAPACITY = 64 };

/* Numbered as fmi2Status and fmi3Status are.
 *
 *     CALL_DISCARD   the call changed nothing and the run goes on
 *     CALL_ERROR     the call was out of place and changed nothing. The standards leave open what becomes of
 *                    the instance then; it stays as it was. */
typedef enum { CALL_OK, CALL_WARNING, CALL_DISCARD, CALL_ERROR } call_status;

typedef enum { MODEL_EXCHANGE, CO_SIMULATION, CO_SIMULATION_WITH_EVENT_MODE, INTERFACE_COUNT } interface_kind;

/* States of the state machines of FMI 2.0 (sections 3.2.3, 4.2.4) and 3.0 (2.3.1, 3.2, 4.2). */
typedef enum {
    INSTANTIATED = 1 << 0,
    INITIALIZATION_MODE = 1 << 1,
    EVENT_MODE = 1 << 2,
    CONTINUOUS_TIME_MODE = 1 << 3,
    STEP_MODE = 1 << 4, /* Co-Simulation, between steps; FMI 2.0 calls it "step complete" */
    TERMINATED = 1 << 5,
    FAILED = 1 << 6, /* the standard's "error" */
    RUNNING = EVENT_MODE | CONTINUOUS_TIME_MODE | STEP_MODE,
    BEFORE_START = INSTANTIATED | INITIALIZATION_MODE,
    ANYWHERE = BEFORE_START | RUNNING | TERMINATED | FAILED
} call_state;

/* Kinds of calls. calls.c has the states of the state machine in which each kind is allowed. */
typedef enum {
    ALWAYS_ALLOWED,
    BEFORE_INITIALIZATION,
    IN_INITIALIZATION,
    WHILE_RUNNING,
    SETS_VALUES,
    SETS_RATES,
    ENTERS_EVENT_MODE,
    ENTERS_EVENT_MODE_AGAIN, /* as FMI 2.0 allows it in event mode, too */
    IN_EVENT_MODE,
    ENTERS_CONTINUOUS_TIME,
    ENTERS_STEP_MODE,
    SETS_TIME,
    INTEGRATES, /* made by an importer's solver */
    EVALUATES,
    ASKS_FOR_NOMINALS,
    STEPS_FORWARD,
    FOLLOWS_STEP,
    CALL_KIND_COUNT
} call_kind;

/* State of the motion between calls of the driver. If a mode has its own coordinates, Co-Simulation computes
 * the world's from them, and Model Exchange computes them from the world's. `shown` is the mode whose outputs
 * are shown: the present mode, or the mode before if the run has ended and keeps its outputs. */
typedef struct {
    double numbers[UNIT_NUMBER_COUNT + 1];
    double time, time_rest; /* the page's time */
    uint64_t taken, above, late;
    int64_t chain;
    int32_t mode, shown;
} unit_motion;

/* Content of a saved state: plain data without padding. saved_state.c lists the fields with their ranges. */
typedef struct {
    int32_t interface, state; /* an interface_kind and a call_state */
    int32_t has_begun;        /* 0 or 1, as are event_is_pending and has_jumped */
    int32_t event_is_pending; /* in Co-Simulation with event mode: the run stands just before an event */
    int32_t has_jumped;       /* since the last update a jump of an input has changed states */
    int32_t event;            /* number of the pending event */
    unit_motion motion;
    double time;  /* the importer's time */
    double epoch; /* the importer's time at the page's time 0 */
    double settings[SETTING_COUNT];
    double starts[UNIT_STATE_COUNT + 1]; /* start values of states in other coordinates than the world's */
    double importer_tolerance;           /* infinite if the importer gives none */
    double stop_time;                    /* infinite if the importer gives none */
    /* Numbers when states were last changed for jumps; in Model Exchange also the rates of states then. */
    double accounted[UNIT_NUMBER_COUNT + 1], accounted_rates[UNIT_STATE_COUNT + 1], accounted_time;
    int64_t work[WORK_COUNT];
    unsigned char watch[8 * (UNIT_EVENT_COUNT / 8 + 1)]; /* a watch_state for each event */
} unit_run;

/* Values that follow from a run, computed on request. */
typedef struct {
    double numbers[UNIT_NUMBER_COUNT + 1]; /* of the run, with times as the importer's clock shows them */
    double derivatives[UNIT_CONTINUOUS_COUNT + 1];
    double guards[UNIT_GUARD_COUNT + 1];
    double outputs[UNIT_OUTPUT_COUNT + 1];
} unit_view;

/* First member of each version's own instance, which adds the importer's callbacks. */
typedef struct instance {
    unit_run run;
    unit_view view;   /* before the run: of the run that would start now */
    unsigned current; /* a bit for each storage whose values in the view are those of the run */
    char words[UNIT_WORD_COUNT + 1][WORD_CAPACITY]; /* texts that the importer has asked for */
    char reason[TEXT_CAPACITY];                     /* why a function has returned false */
    const char *call;                               /* name of the call of FMI that is being made */
    int64_t step_limit;                             /* limit of the solver's steps in a call */
    double *memory, *instant; /* working memory of a run and of an instant; it holds nothing between calls */
    unsigned log_categories;  /* a bit for each status, where that of CALL_OK is for events */
    bool log_was_chosen;      /* true after a call of fmi2SetDebugLogging or fmi3SetDebugLogging */
    char *name;
    /* Passes a message to the importer, if it has a logger. */
    void (*send)(const struct instance *fmu, call_status status, const char *category, const char *text);
} instance;

static inline bool is_exchange(const instance *fmu) {
    return fmu->run.interface == MODEL_EXCHANGE;
}

/* The numbers of a run: functions in `_of` read them, functions in `_in` may write them. */
static inline const double *parameters_of(const instance *fmu) {
    return fmu->run.motion.numbers;
}

static inline double *parameters_in(instance *fmu) {
    return fmu->run.motion.numbers;
}

static inline const double *states_of(const instance *fmu) {
    return parameters_of(fmu) + UNIT_PARAMETER_COUNT;
}

static inline double *states_in(instance *fmu) {
    return parameters_in(fmu) + UNIT_PARAMETER_COUNT;
}

/* The largest time that a clock may show: differences, sums and ratios of such times are numbers. */
#define largest_time 1e100

static inline bool is_time(double time) {
    return fabs(time) <= largest_time;
}

/* ---- calls.c: life cycle, checks and messages ---------------------------------------------------------- */

/* Makes an instance of `size` bytes, which are zero beyond its first member. NULL if it is refused: `reason`
 * says why. It is NULL before the call, unless the caller has a reason of its own. */
void *instance_new(size_t size, const char *name, const char *token, interface_kind interface, bool logging,
                   const char **reason);
void instance_free(instance *fmu);
call_status reset(instance *fmu);

/* Goes to another state of the call sequence, and does nothing else. */
call_status enter_state(instance *fmu, call_state state);

/* True if a call of this name may be made now; else refuses it. A null instance is refused, too. */
bool call_begins(instance *fmu, const char *call, call_kind kind);

const char *name_of_state(call_state state);

/* True if an instance may be in a state of the call sequence, its run begun or not. */
bool state_suits_interface(unsigned state, interface_kind interface, bool begun);

/* True if an array of the right length was given; else refuses the call. */
bool array_is_given(const instance *fmu, const void *array, size_t count, size_t wanted);

/* True if each of these arrays of `count` elements was given; else refuses the call. */
bool arrays_are_given(const instance *fmu, size_t count, const void *const arrays[], size_t array_count);
#define ARE_GIVEN(fmu, count, ...)                                                                           \
    arrays_are_given(fmu, count, (const void *const[]){__VA_ARGS__},                                         \
                     sizeof((const void *const[]){__VA_ARGS__}) / sizeof(void *))

/* Passes a message about the call to the importer if the category of its status is on, and returns the
 * status. */
call_status answer(const instance *fmu, call_status status, const char *format, ...);

/* Writes the reason why a function of the instance returns false, and returns false. */
bool refuse(instance *fmu, const char *format, ...);

/* True if events are to be reported, by log_event. */
bool logs_events(const instance *fmu);
void log_event(const instance *fmu, const char *text);

/* Switches categories on or off by name, or all of them if no names are given. The first call that switches
 * some on replaces those that the instance was made with. Unknown names give a warning. */
call_status set_logging(instance *fmu, bool on, size_t count, const char *const names[]);

/* A number for a message, with a decimal point in every locale; a variable's value with its unit. Both return
 * `text`. */
char *number_text(double number, char text[NUMBER_CAPACITY]);
char *value_text(const fmu_variable *variable, double value, char text[VALUE_CAPACITY]);

/* Position of the highest bit that is set: 0 for 1, 3 for 8. */
int number_of_bit(unsigned bit);

/* ---- access.c: variables ------------------------------------------------------------------------------- */

/* The place of a variable's value, to read it or to write it. */
const double *place_of(const instance *fmu, fmu_storage storage, size_t offset);
double *place_in(instance *fmu, fmu_storage storage, size_t offset);

/* The storage of a variable's value: before the run, the view has states that the start calculates. */
fmu_storage storage_of(const instance *fmu, const fmu_variable *variable);

/* A numeric variable's value, which is up to date. */
double number_of(const instance *fmu, const fmu_variable *variable);

/* The rate of an input, per second, in the run; NULL: it has none. */
double *rate_in(instance *fmu, const fmu_variable *input);

/* True if a variable may have this value. */
bool is_allowed(instance *fmu, const fmu_variable *variable, double value);

/* Finds the variable of a value reference, which must be of one of `types`. Refuses the call and returns NULL
 * if there is none. */
const fmu_variable *find_variable(const instance *fmu, uint32_t reference, unsigned types);

/* Access to numbers in the importer's arrays: one function for each of its types. */
typedef void (*number_writer)(void *values, size_t i, double number);
typedef double (*number_reader)(const void *values, size_t i);

call_status get_numbers(instance *fmu, unsigned types, const uint32_t references[], size_t count,
                        void *values, number_writer write);

/* A set is all or nothing; it checks each variable's own range, while checks across variables wait for the
 * end of initialization, because importers set one by one in any order. In continuous-time mode, variables
 * that change at events only keep their values, and a call that sets another value gives a warning. Setting
 * an input also sets its rate to 0. */
call_status set_numbers(instance *fmu, unsigned types, const uint32_t references[], size_t count,
                        const void *values, number_reader read);

call_status get_texts(instance *fmu, const uint32_t references[], size_t count, const char *values[]);
call_status set_texts(instance *fmu, const uint32_t references[], size_t count, const char *const values[]);

/* ---- instant.c: values at an instant ------------------------------------------------------------------- */

/* The instance if its run has begun; else `preview`, which is a copy started from the values set so far. NULL
 * if these values contradict each other: the call is refused. */
const instance *present_instance(const instance *fmu, instance *preview);

/* Brings the values of a storage in the view up to date. False if the start values contradict each other: the
 * call is refused. */
bool bring_up_to_date(instance *fmu, fmu_storage storage);

/* Writes a word as a text for the importer, and returns it. */
const char *word_text(instance *fmu, size_t word);

/* Nominals are typical magnitudes of the states; importers make absolute tolerances of them. */
call_status get_states(instance *fmu, double states[], size_t count);
call_status get_derivatives(instance *fmu, double derivatives[], size_t count);
call_status get_indicators(instance *fmu, double indicators[], size_t count);
call_status get_nominals(const instance *fmu, double nominals[], size_t count);

/* ---- run.c: start, events and steps -------------------------------------------------------------------- */

call_status set_experiment(instance *fmu, bool tolerance_defined, double tolerance, double start_time,
                           bool stop_time_defined, double stop_time);

call_status exit_initialization(instance *fmu);

call_status enter_event_mode(instance *fmu);

typedef struct {
    bool states_changed;
    bool terminate;
    bool next_time_defined;
    double next_time; /* time of a time event, at which the solver's step has to end; or 0 */
} discrete_update;

/* Takes a pending event and all others that are due now. */
call_status update_discrete_states(instance *fmu, discrete_update *update);

/* Model Exchange: records the guards and largest values after a completed step. True if event mode is needed,
 * because a guard is due or an input has changed whose jumps change other states. */
bool complete_step(instance *fmu);

call_status set_time(instance *fmu, double time);
call_status set_states(instance *fmu, const double states[], size_t count);

/* Co-Simulation: a step to time + step; with `stop_at_event`, to the first event if that comes before or
 * then, which is left for an update of the discrete states to take. A run that has ended stays readable,
 * frozen. */
call_status make_step(instance *fmu, double time, double step, bool stop_at_event);

/* ---- derivatives.c ------------------------------------------------------------------------------------- */

/* values = J seeds, and for the adjoint values = J^T seeds, with J the derivatives of the unknowns by the
 * knowns. */
call_status directional_derivative(instance *fmu, bool is_adjoint, const uint32_t unknowns[],
                                   size_t unknown_count, const uint32_t knowns[], size_t known_count,
                                   const double seeds[], double values[]);

/* Gives the first derivatives of outputs by time. */
call_status output_derivatives(const instance *fmu, const uint32_t references[], size_t count,
                               const int orders[], double values[]);

/* ---- saved_state.c ------------------------------------------------------------------------------------- */

call_status save_state(instance *fmu, void **state);
call_status restore_state(instance *fmu, const void *state);
call_status free_state(void **state);
call_status measure_state(const instance *fmu, const void *state, size_t *size);
call_status serialize_state(const instance *fmu, const void *state, void *bytes, size_t size);
call_status deserialize_state(instance *fmu, const void *bytes, size_t size, void **state);

#endif
