/* A controller that holds the runner's speed by its touchdown angle: an FMI 2.0 unit for Co-Simulation.
 *
 * Whenever a stride has closed, with e the stride's speed less the one wanted,
 *
 *     touchdown_angle = proportional_gain e + integral_gain (sum of all e so far),
 *
 * within +-largest_angle. Between strides it is held. Connect strides and speed to the runner's stride.count
 * and stride.speed, and touchdown_angle to its control.touchdown_angle. */
#include "fmi2Functions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GUID "{dc84d2bf-4e30-5842-8e73-c0541c8b8d9c}"

/* Value references: the Real variables in their order, and one Integer. */
enum { WANTED_SPEED, PROPORTIONAL_GAIN, INTEGRAL_GAIN, LARGEST_ANGLE, SPEED, TOUCHDOWN_ANGLE, REALS };
enum { STRIDES = REALS };

typedef struct {
    fmi2Real values[REALS];
    fmi2Integer strides, strides_seen;
    fmi2Real error_sum;
} controller;

static void reset(controller *controller) {
    const fmi2Real starts[REALS] = {1.05, 4.0, 1.0, 0.1, 0.0, 0.0};
    memset(controller, 0, sizeof *controller);
    memcpy(controller->values, starts, sizeof starts);
}

static void take_stride(controller *controller) {
    const fmi2Real *values = controller->values;
    const fmi2Real error = values[SPEED] - values[WANTED_SPEED];
    const fmi2Real largest = values[LARGEST_ANGLE];
    controller->error_sum += error;
    const fmi2Real angle = values[PROPORTIONAL_GAIN] * error + values[INTEGRAL_GAIN] * controller->error_sum;
    controller->values[TOUCHDOWN_ANGLE] = fmax(-largest, fmin(largest, angle));
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real step, fmi2Boolean no_set_state) {
    controller *controller = component;
    (void)time;
    (void)step;
    (void)no_set_state;
    if (controller->strides != controller->strides_seen) {
        controller->strides_seen = controller->strides;
        take_stride(controller);
    }
    return fmi2OK;
}

/* ---- an instance --------------------------------------------------------------------------------------- */

const char *fmi2GetTypesPlatform(void) {
    return fmi2TypesPlatform;
}

const char *fmi2GetVersion(void) {
    return fmi2Version;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *callbacks, fmi2Boolean visible,
                              fmi2Boolean logging) {
    (void)name;
    (void)resources;
    (void)callbacks;
    (void)visible;
    (void)logging;
    controller *made = NULL;
    if (type == fmi2CoSimulation && guid != NULL && strcmp(guid, GUID) == 0) {
        made = malloc(sizeof *made);
    }
    if (made != NULL) {
        reset(made);
    }
    return made;
}

void fmi2FreeInstance(fmi2Component component) {
    free(component);
}

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, size_t count,
                               const fmi2String names[]) {
    (void)component;
    (void)on;
    (void)count;
    (void)names;
    return fmi2OK;
}

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
    (void)component;
    (void)tolerance_defined;
    (void)tolerance;
    (void)start;
    (void)stop_defined;
    (void)stop;
    return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
    (void)component;
    return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
    (void)component;
    return fmi2OK;
}

fmi2Status fmi2Terminate(fmi2Component component) {
    (void)component;
    return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component component) {
    reset(component);
    return fmi2OK;
}

/* ---- variables ------------------------------------------------------------------------------------------
 */

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       fmi2Real values[]) {
    const controller *controller = component;
    for (size_t i = 0; i < count; ++i) {
        if (references[i] >= REALS) {
            return fmi2Error;
        }
        values[i] = controller->values[references[i]];
    }
    return fmi2OK;
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       const fmi2Real values[]) {
    controller *controller = component;
    for (size_t i = 0; i < count; ++i) {
        if (references[i] >= TOUCHDOWN_ANGLE) {
            return fmi2Error;
        }
        controller->values[references[i]] = values[i];
    }
    return fmi2OK;
}

fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          fmi2Integer values[]) {
    const controller *controller = component;
    for (size_t i = 0; i < count; ++i) {
        if (references[i] != STRIDES) {
            return fmi2Error;
        }
        values[i] = controller->strides;
    }
    return fmi2OK;
}

fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          const fmi2Integer values[]) {
    controller *controller = component;
    for (size_t i = 0; i < count; ++i) {
        if (references[i] != STRIDES) {
            return fmi2Error;
        }
        controller->strides = values[i];
    }
    return fmi2OK;
}

/* ---- what the standard wants to be there, and the description does not promise --------------------------
 */

static fmi2Status absent_unless_empty(size_t count) {
    return count == 0 ? fmi2OK : fmi2Error;
}

fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          fmi2Boolean values[]) {
    (void)component;
    (void)references;
    (void)values;
    return absent_unless_empty(count);
}

fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          const fmi2Boolean values[]) {
    (void)component;
    (void)references;
    (void)values;
    return absent_unless_empty(count);
}

fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference references[], size_t count,
                         fmi2String values[]) {
    (void)component;
    (void)references;
    (void)values;
    return absent_unless_empty(count);
}

fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference references[], size_t count,
                         const fmi2String values[]) {
    (void)component;
    (void)references;
    (void)values;
    return absent_unless_empty(count);
}

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate *state) {
    (void)component;
    (void)state;
    return fmi2Error;
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
    (void)component;
    (void)state;
    return fmi2Error;
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate *state) {
    (void)component;
    (void)state;
    return fmi2Error;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t *size) {
    (void)component;
    (void)state;
    (void)size;
    return fmi2Error;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    (void)component;
    (void)state;
    (void)bytes;
    (void)size;
    return fmi2Error;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state) {
    (void)component;
    (void)bytes;
    (void)size;
    (void)state;
    return fmi2Error;
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference unknowns[],
                                        size_t unknown_count, const fmi2ValueReference knowns[],
                                        size_t known_count, const fmi2Real seeds[], fmi2Real values[]) {
    (void)component;
    (void)unknowns;
    (void)unknown_count;
    (void)knowns;
    (void)known_count;
    (void)seeds;
    (void)values;
    return fmi2Error;
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference references[],
                                       size_t count, const fmi2Integer orders[], const fmi2Real values[]) {
    (void)component;
    (void)references;
    (void)count;
    (void)orders;
    (void)values;
    return fmi2Error;
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference references[],
                                        size_t count, const fmi2Integer orders[], fmi2Real values[]) {
    (void)component;
    (void)references;
    (void)count;
    (void)orders;
    (void)values;
    return fmi2Error;
}

fmi2Status fmi2CancelStep(fmi2Component component) {
    (void)component;
    return fmi2Error;
}

fmi2Status fmi2GetStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Status *value) {
    (void)component;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Real *value) {
    (void)component;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Integer *value) {
    (void)component;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Boolean *value) {
    (void)component;
    (void)kind;
    (void)value;
    return fmi2Discard;
}

fmi2Status fmi2GetStringStatus(fmi2Component component, const fmi2StatusKind kind, fmi2String *value) {
    (void)component;
    (void)kind;
    (void)value;
    return fmi2Discard;
}
