/* FMI 3.0: getting and setting variables, derivatives, and saved states. Every variable is a scalar, so there
 * are as many values as references. */
#include "fmi3_instance.h"

static bool counts_agree(instance *instance, const char *call, size_t references, size_t values) {
    if (instance != NULL && references != values) {
        refuse(instance, call, "%lu value references and %lu values: every variable is a scalar",
               (unsigned long)references, (unsigned long)values);
        return false;
    }
    return true;
}

static void write_int32(void *values, size_t i, double number) {
    ((fmi3Int32 *)values)[i] = (fmi3Int32)number;
}

static double read_int32(const void *values, size_t i) {
    return ((const fmi3Int32 *)values)[i];
}

static void write_int64(void *values, size_t i, double number) {
    ((fmi3Int64 *)values)[i] = (fmi3Int64)number;
}

static double read_int64(const void *values, size_t i) {
    return (double)((const fmi3Int64 *)values)[i];
}

static void write_boolean(void *values, size_t i, double number) {
    ((fmi3Boolean *)values)[i] = number != 0.0;
}

static double read_boolean(const void *values, size_t i) {
    return ((const fmi3Boolean *)values)[i] ? 1.0 : 0.0;
}

static fmi3Status get(instance *instance, const char *call, unsigned type,
                      const fmi3ValueReference references[], size_t count, void *values, size_t value_count,
                      number_writer write) {
    if (!counts_agree(instance, call, count, value_count)) {
        return fmi3Error;
    }
    return (fmi3Status)get_numbers(instance, call, type, references, count, values, write);
}

static fmi3Status set(instance *instance, const char *call, unsigned type,
                      const fmi3ValueReference references[], size_t count, const void *values,
                      size_t value_count, number_reader read) {
    if (!counts_agree(instance, call, count, value_count)) {
        return fmi3Error;
    }
    return (fmi3Status)set_numbers(instance, call, type, references, count, values, read);
}

fmi3Status fmi3GetFloat64(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                          fmi3Float64 values[], size_t value_count) {
    return get(component, "fmi3GetFloat64", VARIABLE_REAL, references, count, values, value_count,
               write_double);
}

fmi3Status fmi3SetFloat64(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                          const fmi3Float64 values[], size_t value_count) {
    return set(component, "fmi3SetFloat64", VARIABLE_REAL, references, count, values, value_count,
               read_double);
}

fmi3Status fmi3GetInt32(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                        fmi3Int32 values[], size_t value_count) {
    return get(component, "fmi3GetInt32", VARIABLE_INTEGER, references, count, values, value_count,
               write_int32);
}

fmi3Status fmi3SetInt32(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                        const fmi3Int32 values[], size_t value_count) {
    return set(component, "fmi3SetInt32", VARIABLE_INTEGER, references, count, values, value_count,
               read_int32);
}

/* The type in which FMI 3.0 passes enumerations. */
fmi3Status fmi3GetInt64(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                        fmi3Int64 values[], size_t value_count) {
    return get(component, "fmi3GetInt64", VARIABLE_ENUMERATION, references, count, values, value_count,
               write_int64);
}

fmi3Status fmi3SetInt64(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                        const fmi3Int64 values[], size_t value_count) {
    return set(component, "fmi3SetInt64", VARIABLE_ENUMERATION, references, count, values, value_count,
               read_int64);
}

fmi3Status fmi3GetBoolean(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                          fmi3Boolean values[], size_t value_count) {
    return get(component, "fmi3GetBoolean", VARIABLE_BOOLEAN, references, count, values, value_count,
               write_boolean);
}

fmi3Status fmi3SetBoolean(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                          const fmi3Boolean values[], size_t value_count) {
    return set(component, "fmi3SetBoolean", VARIABLE_BOOLEAN, references, count, values, value_count,
               read_boolean);
}

fmi3Status fmi3GetString(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                         fmi3String values[], size_t value_count) {
    static const char call[] = "fmi3GetString";
    if (!counts_agree(component, call, count, value_count)) {
        return fmi3Error;
    }
    return (fmi3Status)get_texts(component, call, references, count, values);
}

fmi3Status fmi3SetString(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                         const fmi3String values[], size_t value_count) {
    static const char call[] = "fmi3SetString";
    if (!counts_agree(component, call, count, value_count)) {
        return fmi3Error;
    }
    return (fmi3Status)set_texts(component, call, references, count, values);
}

/* ---- derivatives -------------------------------------------------------------------------------------- */

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance component, const fmi3ValueReference unknowns[],
                                        size_t unknown_count, const fmi3ValueReference knowns[],
                                        size_t known_count, const fmi3Float64 seeds[], size_t seed_count,
                                        fmi3Float64 values[], size_t value_count) {
    static const char call[] = "fmi3GetDirectionalDerivative";
    if (!counts_agree(component, call, known_count, seed_count) ||
        !counts_agree(component, call, unknown_count, value_count)) {
        return fmi3Error;
    }
    return (fmi3Status)directional_derivative(component, call, unknowns, unknown_count, knowns, known_count,
                                              seeds, values);
}

fmi3Status fmi3GetAdjointDerivative(fmi3Instance component, const fmi3ValueReference unknowns[],
                                    size_t unknown_count, const fmi3ValueReference knowns[],
                                    size_t known_count, const fmi3Float64 seeds[], size_t seed_count,
                                    fmi3Float64 values[], size_t value_count) {
    static const char call[] = "fmi3GetAdjointDerivative";
    if (!counts_agree(component, call, unknown_count, seed_count) ||
        !counts_agree(component, call, known_count, value_count)) {
        return fmi3Error;
    }
    return (fmi3Status)adjoint_derivative(component, call, unknowns, unknown_count, knowns, known_count,
                                          seeds, values);
}

/* ---- saved and serialized states ---------------------------------------------------------------------- */

fmi3Status fmi3GetFMUState(fmi3Instance component, fmi3FMUState *state) {
    return (fmi3Status)save_state(component, "fmi3GetFMUState", state);
}

fmi3Status fmi3SetFMUState(fmi3Instance component, fmi3FMUState state) {
    return (fmi3Status)restore_state(component, "fmi3SetFMUState", state);
}

fmi3Status fmi3FreeFMUState(fmi3Instance component, fmi3FMUState *state) {
    return (fmi3Status)free_state(component, "fmi3FreeFMUState", state);
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance component, fmi3FMUState state, size_t *size) {
    return (fmi3Status)measure_state(component, "fmi3SerializedFMUStateSize", state, size);
}

fmi3Status fmi3SerializeFMUState(fmi3Instance component, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
    return (fmi3Status)serialize_state(component, "fmi3SerializeFMUState", state, bytes, size);
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance component, const fmi3Byte bytes[], size_t size,
                                   fmi3FMUState *state) {
    return (fmi3Status)deserialize_state(component, "fmi3DeserializeFMUState", bytes, size, state);
}
