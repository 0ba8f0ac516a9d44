/* FMI 2.0: getting and setting variables, their derivatives, and saved states. */
#include "fmi2_instance.h"

static const unsigned integers = VARIABLE_INTEGER | VARIABLE_ENUMERATION;

static void write_int(void *values, size_t i, double number) {
    ((int *)values)[i] = (int)number;
}

static double read_int(const void *values, size_t i) {
    return ((const int *)values)[i];
}

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       fmi2Real values[]) {
    return (fmi2Status)get_numbers(component, "fmi2GetReal", VARIABLE_REAL, references, count, values,
                                   write_double);
}

fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          fmi2Integer values[]) {
    return (fmi2Status)get_numbers(component, "fmi2GetInteger", integers, references, count, values,
                                   write_int);
}

fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          fmi2Boolean values[]) {
    return (fmi2Status)get_numbers(component, "fmi2GetBoolean", VARIABLE_BOOLEAN, references, count, values,
                                   write_int);
}

fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference references[], size_t count,
                         fmi2String values[]) {
    return (fmi2Status)get_texts(component, "fmi2GetString", references, count, values);
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       const fmi2Real values[]) {
    return (fmi2Status)set_numbers(component, "fmi2SetReal", VARIABLE_REAL, references, count, values,
                                   read_double);
}

fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          const fmi2Integer values[]) {
    return (fmi2Status)set_numbers(component, "fmi2SetInteger", integers, references, count, values,
                                   read_int);
}

fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          const fmi2Boolean values[]) {
    return (fmi2Status)set_numbers(component, "fmi2SetBoolean", VARIABLE_BOOLEAN, references, count, values,
                                   read_int);
}

fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference references[], size_t count,
                         const fmi2String values[]) {
    return (fmi2Status)set_texts(component, "fmi2SetString", references, count, values);
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference unknowns[],
                                        size_t unknown_count, const fmi2ValueReference knowns[],
                                        size_t known_count, const fmi2Real seeds[], fmi2Real values[]) {
    return (fmi2Status)directional_derivative(component, "fmi2GetDirectionalDerivative", unknowns,
                                              unknown_count, knowns, known_count, seeds, values);
}

/* ---- saved and serialized states ---------------------------------------------------------------------- */

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate *state) {
    return (fmi2Status)save_state(component, "fmi2GetFMUstate", state);
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
    return (fmi2Status)restore_state(component, "fmi2SetFMUstate", state);
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate *state) {
    return (fmi2Status)free_state(component, "fmi2FreeFMUstate", state);
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t *size) {
    return (fmi2Status)measure_state(component, "fmi2SerializedFMUstateSize", state, size);
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    return (fmi2Status)serialize_state(component, "fmi2SerializeFMUstate", state, bytes, size);
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state) {
    return (fmi2Status)deserialize_state(component, "fmi2DeSerializeFMUstate", bytes, size, state);
}
