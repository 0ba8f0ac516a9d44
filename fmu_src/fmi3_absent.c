/* FMI 3.0: functions that every unit has to export, for what this one does not have: other types of numbers,
 * binaries, clocks, structural parameters, dependencies of array elements. */
#include "fmi3_instance.h"

/* There is no such thing: all that can be asked for is none of it. */
static fmi3Status without(const instance *instance, const char *call, bool asked, const char *what) {
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return fmi3Error;
    }
    return asked ? (fmi3Status)refuse(instance, call, "the unit has no %s", what) : fmi3OK;
}

static fmi3Status refuse_all(const instance *instance, const char *call, const char *what) {
    return without(instance, call, true, what);
}

#define WITHOUT_VARIABLES_OF_TYPE(Type)                                                                      \
    fmi3Status fmi3Get##Type(fmi3Instance component, const fmi3ValueReference references[], size_t count,    \
                             fmi3##Type values[], size_t value_count) {                                      \
        (void)references, (void)values;                                                                      \
        return without(component, "fmi3Get" #Type, count > 0 || value_count > 0, "variable of type " #Type); \
    }                                                                                                        \
    fmi3Status fmi3Set##Type(fmi3Instance component, const fmi3ValueReference references[], size_t count,    \
                             const fmi3##Type values[], size_t value_count) {                                \
        (void)references, (void)values;                                                                      \
        return without(component, "fmi3Set" #Type, count > 0 || value_count > 0, "variable of type " #Type); \
    }

WITHOUT_VARIABLES_OF_TYPE(Float32)
WITHOUT_VARIABLES_OF_TYPE(Int8)
WITHOUT_VARIABLES_OF_TYPE(UInt8)
WITHOUT_VARIABLES_OF_TYPE(Int16)
WITHOUT_VARIABLES_OF_TYPE(UInt16)
WITHOUT_VARIABLES_OF_TYPE(UInt32)
WITHOUT_VARIABLES_OF_TYPE(UInt64)

fmi3Status fmi3GetBinary(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                         size_t sizes[], fmi3Binary values[], size_t value_count) {
    (void)references, (void)sizes, (void)values;
    return without(component, "fmi3GetBinary", count > 0 || value_count > 0, "variable of type Binary");
}

fmi3Status fmi3SetBinary(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                         const size_t sizes[], const fmi3Binary values[], size_t value_count) {
    (void)references, (void)sizes, (void)values;
    return without(component, "fmi3SetBinary", count > 0 || value_count > 0, "variable of type Binary");
}

/* ---- clocks ------------------------------------------------------------------------------------------- */

fmi3Status fmi3GetClock(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                        fmi3Clock values[]) {
    (void)references, (void)values;
    return without(component, "fmi3GetClock", count > 0, "clock");
}

fmi3Status fmi3SetClock(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                        const fmi3Clock values[]) {
    (void)references, (void)values;
    return without(component, "fmi3SetClock", count > 0, "clock");
}

fmi3Status fmi3GetIntervalDecimal(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                                  fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[]) {
    (void)references, (void)intervals, (void)qualifiers;
    return without(component, "fmi3GetIntervalDecimal", count > 0, "clock");
}

fmi3Status fmi3GetIntervalFraction(fmi3Instance component, const fmi3ValueReference references[],
                                   size_t count, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                   fmi3IntervalQualifier qualifiers[]) {
    (void)references, (void)counters, (void)resolutions, (void)qualifiers;
    return without(component, "fmi3GetIntervalFraction", count > 0, "clock");
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                               fmi3Float64 shifts[]) {
    (void)references, (void)shifts;
    return without(component, "fmi3GetShiftDecimal", count > 0, "clock");
}

fmi3Status fmi3GetShiftFraction(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                                fmi3UInt64 counters[], fmi3UInt64 resolutions[]) {
    (void)references, (void)counters, (void)resolutions;
    return without(component, "fmi3GetShiftFraction", count > 0, "clock");
}

fmi3Status fmi3SetIntervalDecimal(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                                  const fmi3Float64 intervals[]) {
    (void)references, (void)intervals;
    return without(component, "fmi3SetIntervalDecimal", count > 0, "clock");
}

fmi3Status fmi3SetIntervalFraction(fmi3Instance component, const fmi3ValueReference references[],
                                   size_t count, const fmi3UInt64 counters[],
                                   const fmi3UInt64 resolutions[]) {
    (void)references, (void)counters, (void)resolutions;
    return without(component, "fmi3SetIntervalFraction", count > 0, "clock");
}

fmi3Status fmi3SetShiftDecimal(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                               const fmi3Float64 shifts[]) {
    (void)references, (void)shifts;
    return without(component, "fmi3SetShiftDecimal", count > 0, "clock");
}

fmi3Status fmi3SetShiftFraction(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                                const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]) {
    (void)references, (void)counters, (void)resolutions;
    return without(component, "fmi3SetShiftFraction", count > 0, "clock");
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance component, fmi3ValueReference clock, fmi3Float64 time) {
    (void)clock, (void)time;
    return refuse_all(component, "fmi3ActivateModelPartition", "clock");
}

/* ---- the rest ----------------------------------------------------------------------------------------- */

fmi3Status fmi3EnterConfigurationMode(fmi3Instance component) {
    return refuse_all(component, "fmi3EnterConfigurationMode", "structural parameter");
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance component) {
    return refuse_all(component, "fmi3ExitConfigurationMode", "structural parameter");
}

/* "If providesEvaluateDiscreteStates is true ..., else function is ignored" (FMI 3.0, section 2.3.5). */
fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance component) {
    return call_is_allowed(component, "fmi3EvaluateDiscreteStates", EVENT_MODE) ? fmi3OK : fmi3Error;
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance component, fmi3ValueReference reference,
                                               size_t *count) {
    (void)reference, (void)count;
    return refuse_all(component, "fmi3GetNumberOfVariableDependencies", "dependencies per array element");
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance component, fmi3ValueReference dependent,
                                       size_t dependent_elements[], fmi3ValueReference independents[],
                                       size_t independent_elements[], fmi3DependencyKind kinds[],
                                       size_t count) {
    (void)dependent, (void)dependent_elements, (void)independents, (void)independent_elements;
    (void)kinds, (void)count;
    return refuse_all(component, "fmi3GetVariableDependencies", "dependencies per array element");
}
