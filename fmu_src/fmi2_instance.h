/* An FMI 2.0 instance: a unit, the state of its call sequence, and the importer's logger. */
#ifndef TDMF_FMI2_INSTANCE_H
#define TDMF_FMI2_INSTANCE_H

#include "fmi2Functions.h"

#include "unit.h"
#include "variables.h"

/* States of the state machines of FMI 2.0, sections 3.2.3 and 4.2.4; a set of them says where a function may
 * be called. */
typedef enum {
    INSTANTIATED = 1 << 0,
    INITIALIZATION_MODE = 1 << 1,
    EVENT_MODE = 1 << 2,
    CONTINUOUS_TIME_MODE = 1 << 3,
    STEP_COMPLETE = 1 << 4, /* Co-Simulation, between steps */
    TERMINATED = 1 << 5,
    FAILED = 1 << 6, /* the standard's "error" */
    RUNNING = EVENT_MODE | CONTINUOUS_TIME_MODE | STEP_COMPLETE,
    BEFORE_START = INSTANTIATED | INITIALIZATION_MODE,
    ANYWHERE = BEFORE_START | RUNNING | TERMINATED | FAILED,
    READABLE = ANYWHERE & ~INSTANTIATED
} call_state;

/* Bits of the log categories in modelDescription.xml. */
typedef enum {
    LOG_EVENTS = 1 << 0,
    LOG_STATUS_WARNING = 1 << 1,
    LOG_STATUS_DISCARD = 1 << 2,
    LOG_STATUS_ERROR = 1 << 3,
    LOG_STATUS = LOG_STATUS_WARNING | LOG_STATUS_DISCARD | LOG_STATUS_ERROR,
    LOG_ALL = LOG_STATUS | LOG_EVENTS
} log_category;

typedef struct {
    unit unit;
    unit_view view;
    bool view_is_current;
    fmi2Type type;
    call_state state;
    unsigned log_categories;
    char *name;
    fmi2CallbackLogger logger; /* may be NULL */
    fmi2ComponentEnvironment environment;
} instance;

/* ---- fmi2_log.c --------------------------------------------------------------------------------------- */

/* Passes a message to the importer if its category is on. */
void log_message(const instance *instance, fmi2Status status, log_category category, const char *format, ...);

/* Logs and returns fmi2Error, and puts the instance into the error state. */
fmi2Status fail(instance *instance, const char *call, const char *format, ...);

/* Logs and returns fmi2Discard: the call changed nothing and the run goes on. */
fmi2Status discard(const instance *instance, const char *call, const char *format, ...);

/* The categories of that name; 0 if there are none. */
unsigned log_category_named(const char *name);

/* ---- fmi2_calls.c ------------------------------------------------------------------------------------- */

/* Whether `call` may be made now; if not, says so and fails. A null component is refused too. */
bool call_is_allowed(instance *instance, const char *call, unsigned allowed_states);

/* Whether an array of the right length was given; if not, says so and fails. */
bool array_is_given(instance *instance, const char *call, const void *array, size_t count, size_t wanted);

/* The outputs and derivatives for the present values. NULL, with a message and the status in `status`, while
 * the start values contradict each other. */
const unit_view *current_view(instance *instance, const char *call, fmi2Status *status);

/* The variable of a value reference and type; NULL, after failing, if there is none. */
const unit_variable *find_variable(instance *instance, const char *call, fmi2ValueReference reference,
                                   unit_variable_type type);

/* Logs what an update has changed since `before`. */
void log_changes(const instance *instance, const tdmf_mode *before);

/* Something that outputs or derivatives depend on has changed. */
void forget_view(instance *instance);

#endif
