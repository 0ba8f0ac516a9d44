/* FMI 3.0: functions that every unit has to export, for what this one does not have: other types of numbers,
 * binaries, clocks, structural parameters, dependencies of array elements. */
#include "fmi3_instance.h"

static fmi3Status refuse(instance *instance, const char *call, const char *what) {
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return fmi3Error;
    }
    return (fmi3Status)fail(instance, call, "the unit has no %s", what);
}

#define WITHOUT_VARIABLES_OF_TYPE(Type)                                                                      \
    fmi3Status fmi3Get##Type(fmi3Instance component, const fmi3ValueReference references[], size_t count,    \
                             fmi3##Type values[], size_t value_count) {                                      \
        (void)references, (void)count, (void)values, (void)value_count;                                      \
        return refuse(component, "fmi3Get" #Type, "variable of type " #Type);                                \
    }                                                                                                        \
    fmi3Status fmi3Set##Type(fmi3Instance component, const fmi3ValueReference references[], size_t count,    \
                             const fmi3##Type values[], size_t value_count) {                                \
        (void)references, (void)count, (void)values, (void)value_count;                                      \
        return refuse(component, "fmi3Set" #Type, "variable of type " #Type);                                \
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
    (void)references, (void)count, (void)sizes, (void)values, (void)value_count;
    return refuse(component, "fmi3GetBinary", "variable of type Binary");
}

fmi3Status fmi3SetBinary(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                         const size_t sizes[], const fmi3Binary values[], size_t value_count) {
    (void)references, (void)count, (void)sizes, (void)values, (void)value_count;
    return refuse(component, "fmi3SetBinary", "variable of type Binary");
}

/* ---- clocks ------------------------------------------------------------------------------------------- */

fmi3Status fmi3GetClock(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                        fmi3Clock values[]) {
    (void)references, (void)count, (void)values;
    return refuse(component, "fmi3GetClock", "clock");
}

fmi3Status fmi3SetClock(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                        const fmi3Clock values[]) {
    (void)references, (void)count, (void)values;
    return refuse(component, "fmi3SetClock", "clock");
}

fmi3Status fmi3GetIntervalDecimal(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                                  fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[]) {
    (void)references, (void)count, (void)intervals, (void)qualifiers;
    return refuse(component, "fmi3GetIntervalDecimal", "clock");
}

fmi3Status fmi3GetIntervalFraction(fmi3Instance component, const fmi3ValueReference references[],
                                   size_t count, fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                   fmi3IntervalQualifier qualifiers[]) {
    (void)references, (void)count, (void)counters, (void)resolutions, (void)qualifiers;
    return refuse(component, "fmi3GetIntervalFraction", "clock");
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                               fmi3Float64 shifts[]) {
    (void)references, (void)count, (void)shifts;
    return refuse(component, "fmi3GetShiftDecimal", "clock");
}

fmi3Status fmi3GetShiftFraction(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                                fmi3UInt64 counters[], fmi3UInt64 resolutions[]) {
    (void)references, (void)count, (void)counters, (void)resolutions;
    return refuse(component, "fmi3GetShiftFraction", "clock");
}

fmi3Status fmi3SetIntervalDecimal(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                                  const fmi3Float64 intervals[]) {
    (void)references, (void)count, (void)intervals;
    return refuse(component, "fmi3SetIntervalDecimal", "clock");
}

fmi3Status fmi3SetIntervalFraction(fmi3Instance component, const fmi3ValueReference references[],
                                   size_t count, const fmi3UInt64 counters[],
                                   const fmi3UInt64 resolutions[]) {
    (void)references, (void)count, (void)counters, (void)resolutions;
    return refuse(component, "fmi3SetIntervalFraction", "clock");
}

fmi3Status fmi3SetShiftDecimal(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                               const fmi3Float64 shifts[]) {
    (void)references, (void)count, (void)shifts;
    return refuse(component, "fmi3SetShiftDecimal", "clock");
}

fmi3Status fmi3SetShiftFraction(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                                const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]) {
    (void)references, (void)count, (void)counters, (void)resolutions;
    return refuse(component, "fmi3SetShiftFraction", "clock");
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance component, fmi3ValueReference clock, fmi3Float64 time) {
    (void)clock, (void)time;
    return refuse(component, "fmi3ActivateModelPartition", "clock");
}

/* ---- the rest ----------------------------------------------------------------------------------------- */

fmi3Status fmi3EnterConfigurationMode(fmi3Instance component) {
    return refuse(component, "fmi3EnterConfigurationMode", "structural parameter");
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance component) {
    return refuse(component, "fmi3ExitConfigurationMode", "structural parameter");
}

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance component) {
    return refuse(component, "fmi3EvaluateDiscreteStates", "discrete states to evaluate without an update");
}

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance component, fmi3ValueReference reference,
                                               size_t *count) {
    (void)reference, (void)count;
    return refuse(component, "fmi3GetNumberOfVariableDependencies", "dependencies per array element");
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance component, fmi3ValueReference dependent,
                                       size_t dependent_elements[], fmi3ValueReference independents[],
                                       size_t independent_elements[], fmi3DependencyKind kinds[],
                                       size_t count) {
    (void)dependent, (void)dependent_elements, (void)independents, (void)independent_elements;
    (void)kinds, (void)count;
    return refuse(component, "fmi3GetVariableDependencies", "dependencies per array element");
}
