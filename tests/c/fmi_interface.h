/* Table of the calls that FMI 2.0 and 3.0 both have, one for each version. One test checks both versions, and
 * fails under the name of the version. */
#ifndef TDMF_TESTS_FMI_INTERFACE_H
#define TDMF_TESTS_FMI_INTERFACE_H

#include "messages.h"
#include "tdmf_slip/return_map.h"
#include "test.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Numbered as fmi2Status and fmi3Status are. */
typedef enum { FMI_OK, FMI_WARNING, FMI_DISCARD, FMI_ERROR } fmi_status;

/* Model Exchange, Co-Simulation, and Co-Simulation with event mode and early return, which FMI 2.0 lacks. */
typedef enum { EXCHANGE, STEPS, STEPS_WITH_EVENTS, KINDS } fmi_kind;

typedef struct {
    bool has_tolerance;
    double tolerance, start;
    bool has_stop;
    double stop;
} fmi_experiment;

/* Answers of an update of the discrete states. */
typedef struct {
    bool needs_update, terminate, nominals_changed, states_changed, next_time_defined;
    double next_time;
} update_answer;

/* Answers of a step. A step of FMI 2.0 always arrives, without an event. */
typedef struct {
    bool event, terminate, early;
    double time;
} step_answer;

typedef struct fmi_interface {
    fmi_kind kinds; /* the first kind that the version lacks */
    /* Returns NULL if it is refused. */
    void *(*instantiate)(fmi_kind kind, const char *name, const char *token, bool has_logger, bool logging);
    void (*free)(void *instance);
    fmi_status (*set_logging)(void *instance, bool on, size_t count, const char *const names[]);
    /* FMI 2.0 sets the experiment by a call of its own. */
    fmi_status (*enter_initialization)(void *instance, const fmi_experiment *experiment);
    fmi_status (*exit_initialization)(void *instance);
    fmi_status (*enter_event_mode)(void *instance);
    fmi_status (*update)(void *instance, update_answer *answer);
    fmi_status (*enter_continuous_time_mode)(void *instance);
    fmi_status (*enter_step_mode)(void *instance); /* in FMI 3.0 only */
    fmi_status (*complete_step)(void *instance, bool *asks_for_event_mode, bool *asks_to_stop);
    fmi_status (*do_step)(void *instance, double time, double step, step_answer *answer);
    fmi_status (*terminate)(void *instance);
    fmi_status (*reset)(void *instance);
    fmi_status (*set_time)(void *instance, double time);
    fmi_status (*set_states)(void *instance, const double states[], size_t count);
    fmi_status (*get_states)(void *instance, double states[], size_t count);
    fmi_status (*get_derivatives)(void *instance, double derivatives[], size_t count);
    fmi_status (*get_indicators)(void *instance, double indicators[], size_t count);
    fmi_status (*get_nominals)(void *instance, double nominals[], size_t count);
    fmi_status (*get_reals)(void *instance, const uint32_t references[], size_t count, double values[]);
    fmi_status (*set_reals)(void *instance, const uint32_t references[], size_t count, const double values[]);
    fmi_status (*get_integer)(void *instance, uint32_t reference, int *value);
    fmi_status (*get_item)(void *instance, uint32_t reference, int *value); /* enumerations */
    fmi_status (*set_item)(void *instance, uint32_t reference, int value);
    fmi_status (*get_truth)(void *instance, uint32_t reference, bool *value);
    fmi_status (*set_truth)(void *instance, uint32_t reference, bool value);
    fmi_status (*directional_derivative)(void *instance, const uint32_t unknowns[], size_t unknown_count,
                                         const uint32_t knowns[], size_t known_count, const double seeds[],
                                         double values[]);
    fmi_status (*output_derivative)(void *instance, uint32_t reference, int order, double *value);
    fmi_status (*save)(void *instance, void **saved);
    fmi_status (*restore)(void *instance, void *saved);
    fmi_status (*free_saved)(void *instance, void **saved);
    fmi_status (*measure)(void *instance, void *saved, size_t *size);
    fmi_status (*serialize)(void *instance, void *saved, unsigned char bytes[], size_t size);
    fmi_status (*deserialize)(void *instance, const unsigned char bytes[], size_t size, void **saved);
} fmi_interface;

extern const fmi_interface fmi2, fmi3;

/* Numbers of the units' continuous states. */
enum {
    STATE_FOOT_X,
    STATE_FOOT_Y,
    STATE_LEG_LENGTH,
    STATE_LEG_ANGLE,
    STATE_FOOT_VX,
    STATE_FOOT_VY,
    STATE_LEG_LENGTH_RATE,
    STATE_LEG_ANGLE_RATE,
    STATE_HIP_WORK,
    STATE_HIP_PLACE_TIME,
    STATE_LEG_WORK,
    CONTINUOUS_STATES = 15
};

/* The states at which the default runner begins. */
void write_default_states(double states[CONTINUOUS_STATES]);

/* A row of a version's table that is one of its calls. */
#define ANSWERS(name, given, ...)                                                                            \
    static fmi_status name given {                                                                           \
        return (fmi_status)(__VA_ARGS__);                                                                    \
    }

/* A test of both versions, whose function has the version's table as `fmi`. */
#define FMI_TEST(name)                                                                                       \
    static void name(const fmi_interface *fmi);                                                              \
    static void run_##name(void **state) {                                                                   \
        name(*state);                                                                                        \
    }                                                                                                        \
    BEFORE_MAIN(register_##name) {                                                                           \
        register_test(#name " (FMI 2.0)", run_##name, &fmi2);                                                \
        register_test(#name " (FMI 3.0)", run_##name, &fmi3);                                                \
    }                                                                                                        \
    static void name(const fmi_interface *fmi)

/* A fresh instance until the end of the test, event logging off; asserts that there is one. */
void *new_of_kind(const fmi_interface *fmi, fmi_kind kind);

fmi_status set_value(const fmi_interface *fmi, void *instance, const char *name, double value);

/* Sets Reals and Booleans, written as name=value with spaces between; asserts that none is refused. */
void set_values(const fmi_interface *fmi, void *instance, const char *values);

/* Values of variables; `integer_of` reads enumerations, too. Assert that the variable can be read. */
double value_of(const fmi_interface *fmi, void *instance, const char *name);
int integer_of(const fmi_interface *fmi, void *instance, const char *name);
bool truth_of(const fmi_interface *fmi, void *instance, const char *name);

/* Derivative of one variable by another; asserts that it is given. */
double derivative_of(const fmi_interface *fmi, void *instance, uint32_t unknown, uint32_t known);

/* Asserts that the mechanical states of two instances are equal, or differ by no more than a tolerance. */
void assert_same_states(const fmi_interface *fmi, void *instance, const fmi_interface *fmi_of_other,
                        void *other, double tolerance);

/* Take an instance through initialization, from time 0 or another; assert that nothing is refused. */
void initialize_unit(const fmi_interface *fmi, void *instance);
void initialize_unit_at(const fmi_interface *fmi, void *instance, double start);

/* Takes an instance from event mode to the mode in which time advances; asserts that nothing is refused. */
void update_and_go_on(const fmi_interface *fmi, void *instance, fmi_kind kind);

/* Takes an instance through initialization to the mode in which time advances. */
void begin(const fmi_interface *fmi, void *instance, fmi_kind kind);

/* A fresh instance with start values, written as for set_values, in the mode in which time advances. */
void *begun(const fmi_interface *fmi, fmi_kind kind, const char *values);

/* Enters event mode, sets values, updates, and goes back to the mode in which time advances; asserts that
 * nothing is refused. */
update_answer take_event(const fmi_interface *fmi, void *instance, fmi_kind kind, const char *values);

/* Makes steps of Co-Simulation up to a time, and takes the events at which they end. Returns their number. */
int run_to(const fmi_interface *fmi, void *instance, double end, double step);

/* Sets start values at an apex of a model that differs from the default one by the clamp at most. */
void set_apex(const fmi_interface *fmi, void *instance, const tdmf_model *model, double friction,
              const double apex[TDMF_SECTION_COUNT]);

/* Makes a step of Co-Simulation from the present time; asserts that it succeeds. */
void step_by(const fmi_interface *fmi, void *instance, double step);

/* A saved state in bytes. */
typedef struct {
    unsigned char bytes[SERIALIZED_BYTES];
    size_t size;
} serialized;

/* Saves the state of an instance; asserts that there is room. */
serialized serialize(const fmi_interface *fmi, void *instance);

/* Restores a state; asserts that nothing is left to be freed if the state is refused. */
fmi_status restore(const fmi_interface *fmi, void *instance, const serialized *state);

/* Restores the state of one instance in another. */
fmi_status copy_state(const fmi_interface *fmi, void *from, void *to);

/* Asserts that the state of an instance is this one, bit for bit. */
void assert_state(const fmi_interface *fmi, void *instance, const serialized *expected);

#endif
