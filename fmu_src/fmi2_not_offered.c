/* FMI 2.0 functions that every unit exports but whose capability flags this one leaves false. */
#include "fmi2_instance.h"

static fmi2Status refuse(fmi2Component component, const char *call, const char *flag) {
    return component == NULL ? fmi2Error : fail(component, call, "not offered (%s is false)", flag);
}

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate *state) {
    (void)state;
    return refuse(component, "fmi2GetFMUstate", "canGetAndSetFMUstate");
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
    (void)state;
    return refuse(component, "fmi2SetFMUstate", "canGetAndSetFMUstate");
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate *state) {
    (void)state;
    return refuse(component, "fmi2FreeFMUstate", "canGetAndSetFMUstate");
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t *size) {
    (void)state;
    (void)size;
    return refuse(component, "fmi2SerializedFMUstateSize", "canSerializeFMUstate");
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    (void)state;
    (void)bytes;
    (void)size;
    return refuse(component, "fmi2SerializeFMUstate", "canSerializeFMUstate");
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state) {
    (void)bytes;
    (void)size;
    (void)state;
    return refuse(component, "fmi2DeSerializeFMUstate", "canSerializeFMUstate");
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference unknowns[],
                                        size_t unknown_count, const fmi2ValueReference knowns[],
                                        size_t known_count, const fmi2Real seed[], fmi2Real sensitivity[]) {
    (void)unknowns;
    (void)unknown_count;
    (void)knowns;
    (void)known_count;
    (void)seed;
    (void)sensitivity;
    return refuse(component, "fmi2GetDirectionalDerivative", "providesDirectionalDerivative");
}
