/* An instance of the unit for both versions of FMI: a run, the state of its call sequence, and the importer's
 * logger. Every function here is a call of FMI 2.0 and 3.0 or a part of one. It takes the name of the call
 * for its messages and, where the versions differ, the states in which the call is allowed. */
#ifndef TDMF_FMU_INSTANCE_H
#define TDMF_FMU_INSTANCE_H

#include "variables.h"

#include <stdint.h>

/* Calls of FMI have arguments that the unit does not need. */
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wunused-parameter"
#elif defined(_MSC_VER)
#pragma warning(disable : 4100)
#endif

/* Numbered as fmi2Status and fmi3Status are. */
typedef enum { CALL_OK, CALL_WARNING, CALL_DISCARD, CALL_ERROR } call_status;

/* States of the state machines of FMI 2.0 (sections 3.2.3, 4.2.4) and 3.0 (2.3.1, 3.2, 4.2); a set of them
 * says where a function may be called. */
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

typedef enum { MODEL_EXCHANGE, CO_SIMULATION, CO_SIMULATION_WITH_EVENT_MODE } interface_kind;

/* Categories of messages, as declared in the model description: one for each status, where that of CALL_OK is
 * for events. Any of them may be switched on together. */
enum { LOG_EVENTS = 1 << CALL_OK, LOG_ALL = (1 << (CALL_ERROR + 1)) - 1 };

/* First member of each version's own instance, which adds the importer's callbacks. */
typedef struct instance {
    fmu fmu;
    fmu_view view;
    bool view_is_current;
    interface_kind interface;
    call_state state;
    unsigned log_categories;
    bool log_was_chosen; /* true after a call of fmi2SetDebugLogging or fmi3SetDebugLogging */
    char *name;
    /* Passes a message to the importer, if it has a logger. */
    void (*send)(const struct instance *instance, call_status status, const char *category, const char *text);
} instance;

/* ---- log.c -------------------------------------------------------------------------------------------- */

/* Passes a message about a call to the importer if the category of its status is on, and returns the status.
 *
 *     CALL_DISCARD   the call changed nothing and the run goes on
 *     CALL_ERROR     the call was out of place and changed nothing. The standards leave open what becomes of
 *                    the instance then; it stays as it was. */
call_status answer(const instance *instance, call_status status, const char *call, const char *format, ...);

/* Reports an event. */
void log_event(const instance *observer, const char *text);

/* The instance as an observer of events; NULL while the events' category is off. */
const instance *observer_of(const instance *instance);

/* Switches categories on or off by name, or all of them if no names are given. The first call that switches
 * some on replaces those that the instance was made with. Unknown names give a warning. */
call_status set_logging(instance *instance, const char *call, bool on, size_t count,
                        const char *const names[]);

/* A number for a message, with a decimal point in every locale; returns `text`. */
enum { NUMBER_CAPACITY = 32 };
char *number_text(double number, char text[NUMBER_CAPACITY]);

/* ---- calls.c ------------------------------------------------------------------------------------------ */

/* Makes an instance of `size` bytes, which are zero beyond its first member. NULL if it is refused: `reason`
 * says why. It is NULL before the call, unless the caller has a reason of its own. */
void *instance_new(size_t size, const char *name, const char *token, interface_kind interface, bool logging,
                   const char **reason);
void instance_free(instance *instance);

/* Position of the highest bit that is set: 0 for 1, 3 for 8. Enumerators that are bits have their names there
 * in a table. */
int number_of_bit(unsigned bit);

const char *name_of_state(call_state state);

/* True if an instance may be in a state of the call sequence, its run begun or not. */
bool state_suits_interface(unsigned state, interface_kind interface, bool begun);

/* True if `call` may be made now; else refuses it. A null instance is refused too. */
bool call_is_allowed(const instance *instance, const char *call, unsigned allowed_states);

/* True if an array of the right length was given; else refuses the call. */
bool array_is_given(const instance *instance, const char *call, const void *array, size_t count,
                    size_t wanted);

/* True if `call` may be made now, and each of these arrays of `count` elements was given; else refuses it. */
bool call_may_begin(const instance *instance, const char *call, unsigned allowed_states, size_t count,
                    const void *const arrays[], size_t array_count);
#define MAY_BEGIN(instance, call, allowed_states, count, ...)                                                \
    call_may_begin(instance, call, allowed_states, count, (const void *const[]){__VA_ARGS__},                \
                   sizeof((const void *const[]){__VA_ARGS__}) / sizeof(void *))

/* Goes from one of the states `from` of the call sequence to another one, and does nothing else. */
call_status enter_state(instance *instance, const char *call, unsigned from, call_state to);

/* The unit. Until its run has begun, `preview`, which is the unit started from the values set so far. NULL if
 * these values contradict each other; `status` is then that of the refusal. */
const fmu *present_fmu(const instance *instance, const char *call, fmu *preview, call_status *status);

/* The outputs and derivatives for the present values. NULL if the start values contradict each other;
 * `status` is then that of the refusal. */
const fmu_view *current_view(instance *instance, const char *call, call_status *status);

/* Discards the view, because something that outputs or derivatives depend on has changed. */
void discard_view(instance *instance);

call_status set_experiment(instance *instance, const char *call, bool tolerance_defined, double tolerance,
                           double start_time, bool stop_time_defined, double stop_time);
call_status exit_initialization(instance *instance, const char *call);
call_status reset(instance *instance, const char *call);

/* ---- access.c ----------------------------------------------------------------------------------------- */

/* Finds the variable of a value reference, which must be of one of `types`. Refuses the call and returns NULL
 * if there is none. */
const fmu_variable *find_variable(const instance *instance, const char *call, uint32_t reference,
                                  unsigned types);

/* Access to numbers in the importer's arrays: one function for each of its types. */
typedef void (*number_writer)(void *values, size_t i, double number);
typedef double (*number_reader)(const void *values, size_t i);
void write_double(void *values, size_t i, double number);
double read_double(const void *values, size_t i);

call_status get_numbers(instance *instance, const char *call, unsigned types, const uint32_t references[],
                        size_t count, void *values, number_writer write);

/* A set is all or nothing; it checks each variable's own range, while checks across variables wait for the
 * end of initialization, because importers set one by one in any order. Which variables may be set when:
 *
 *     before the run          parameters, inputs, states with a start value
 *     event mode              inputs, tunable parameters; in Model Exchange states that no event changes
 *                             (reinit = false)
 *     continuous-time mode    continuous inputs and states, these as trial values of the importer's solver
 *     step mode               inputs, tunable parameters
 *
 * In continuous-time mode, variables that change at events only keep their values, and a call that sets
 * another value gives a warning. Setting an input also sets its rate to 0.
 * (FMI 2.0, table of section 3.2.3, whose note 5 has the states; FMI 3.0.2, sections 2.3.5 and 3.2.1.) */
call_status set_numbers(instance *instance, const char *call, unsigned types, const uint32_t references[],
                        size_t count, const void *values, number_reader read);

call_status get_texts(instance *instance, const char *call, const uint32_t references[], size_t count,
                      const char *values[]);
call_status set_texts(instance *instance, const char *call, const uint32_t references[], size_t count,
                      const char *const values[]);

/* ---- derivatives.c ------------------------------------------------------------------------------------ */

/* values = J seeds, and values = J^T seeds, with J the derivatives of the unknowns by the knowns. */
call_status directional_derivative(instance *instance, const char *call, const uint32_t unknowns[],
                                   size_t unknown_count, const uint32_t knowns[], size_t known_count,
                                   const double seeds[], double values[]);
call_status adjoint_derivative(instance *instance, const char *call, const uint32_t unknowns[],
                               size_t unknown_count, const uint32_t knowns[], size_t known_count,
                               const double seeds[], double values[]);

/* Gives the first derivatives of outputs by time. */
call_status output_derivatives(instance *instance, const char *call, const uint32_t references[],
                               size_t count, const int orders[], double values[]);

/* ---- saved_state.c ------------------------------------------------------------------------------------ */

call_status save_state(instance *instance, const char *call, void **state);
call_status restore_state(instance *instance, const char *call, const void *state);
call_status free_state(instance *instance, const char *call, void **state);
call_status measure_state(instance *instance, const char *call, const void *state, size_t *size);
call_status serialize_state(instance *instance, const char *call, const void *state, void *bytes,
                            size_t size);
call_status deserialize_state(instance *instance, const char *call, const void *bytes, size_t size,
                              void **state);

/* ---- stepping.c --------------------------------------------------------------------------------------- */

call_status enter_event_mode(instance *instance, const char *call, unsigned allowed_states);

typedef struct {
    bool states_changed;
    bool terminate;
    bool next_time_defined;
    double next_time; /* time of a time event, at which the solver's step has to end; or 0 */
} discrete_update;
call_status update_discrete_states(instance *instance, const char *call, discrete_update *update);

/* `asks` becomes true if event mode is needed. The importer's own places for answers must be given. */
call_status complete_step(instance *instance, const char *call, const void *event_mode, const void *terminate,
                          bool *asks);

call_status set_time(instance *instance, const char *call, double time);
call_status set_states(instance *instance, const char *call, const double states[], size_t count);
call_status get_states(instance *instance, const char *call, double states[], size_t count);
call_status get_derivatives(instance *instance, const char *call, double derivatives[], size_t count);
call_status get_indicators(instance *instance, const char *call, double indicators[], size_t count);
call_status get_nominals(instance *instance, const char *call, double nominals[], size_t count);

/* Co-Simulation: a step to time + step; with `stop_at_event`, to the first event if that comes before or
 * then, which is left for an update of the discrete states to take and reported in `event`. */
call_status step_on(instance *instance, const char *call, double time, double step, bool stop_at_event,
                    bool *event);

#endif
