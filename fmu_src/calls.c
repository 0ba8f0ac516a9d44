/* Checks that every FMI call makes first, and the view that it reads from. */
#include "instance.h"

const char *name_of_state(call_state state) {
    switch (state) {
    case INSTANTIATED:
        return "before initialization";
    case INITIALIZATION_MODE:
        return "in initialization mode";
    case EVENT_MODE:
        return "in event mode";
    case CONTINUOUS_TIME_MODE:
        return "in continuous-time mode";
    case STEP_MODE:
        return "between steps of Co-Simulation";
    case TERMINATED:
        return "after termination";
    default:
        return "after an error; reset or free the instance";
    }
}

static unsigned states_of(interface_kind interface, bool begun) {
    if (!begun) {
        return BEFORE_START | FAILED;
    }
    switch (interface) {
    case MODEL_EXCHANGE:
        return EVENT_MODE | CONTINUOUS_TIME_MODE | TERMINATED | FAILED;
    case CO_SIMULATION:
        return STEP_MODE | TERMINATED | FAILED;
    default:
        return EVENT_MODE | STEP_MODE | TERMINATED | FAILED;
    }
}

bool state_suits_interface(call_state state, interface_kind interface, bool begun) {
    const unsigned one = state;
    return (one & (one - 1)) == 0 && (one & states_of(interface, begun)) != 0;
}

bool call_is_allowed(const instance *instance, const char *call, unsigned allowed_states) {
    if (instance == NULL) {
        return false;
    }
    if ((instance->state & allowed_states) == 0) {
        refuse(instance, call, "not allowed %s", name_of_state(instance->state));
        return false;
    }
    return true;
}

bool array_is_given(const instance *instance, const char *call, const void *array, size_t count,
                    size_t wanted) {
    if (count != wanted) {
        refuse(instance, call, "the array has %lu elements, %lu are needed", (unsigned long)count,
               (unsigned long)wanted);
        return false;
    }
    if (array == NULL && count > 0) {
        refuse(instance, call, "the array is a null pointer");
        return false;
    }
    return true;
}

void discard_view(instance *instance) {
    instance->view_is_current = false;
}

const fmu *present_fmu(const instance *instance, const char *call, fmu *preview, call_status *status) {
    if (fmu_has_begun(&instance->fmu)) {
        return &instance->fmu;
    }
    *preview = instance->fmu;
    char text[FMU_TEXT];
    if (fmu_start(preview, text) != NULL) {
        *status = discard(instance, call, "no outputs yet: %s", text);
        return NULL;
    }
    return preview;
}

const fmu_view *current_view(instance *instance, const char *call, call_status *status) {
    if (!instance->view_is_current) {
        fmu preview;
        const fmu *present = present_fmu(instance, call, &preview, status);
        if (present == NULL) {
            return NULL;
        }
        fmu_evaluate(present, &instance->view);
        instance->view_is_current = true;
    }
    return &instance->view;
}

static const char *name_of_type(fmu_variable_type type) {
    switch (type) {
    case VARIABLE_REAL:
        return "Real (Float64)";
    case VARIABLE_INTEGER:
        return "Integer (Int32)";
    case VARIABLE_ENUMERATION:
        return "Enumeration";
    case VARIABLE_BOOLEAN:
        return "Boolean";
    default:
        return "String";
    }
}

const fmu_variable *find_variable(const instance *instance, const char *call, uint32_t reference,
                                  unsigned types) {
    if (reference >= fmu_variable_count) {
        refuse(instance, call, "there is no value reference %lu", (unsigned long)reference);
        return NULL;
    }
    const fmu_variable *variable = &fmu_variables[reference];
    if ((variable->type & types) == 0) {
        refuse(instance, call, "%s (value reference %lu) is of type %s", variable->name,
               (unsigned long)reference, name_of_type(variable->type));
        return NULL;
    }
    return variable;
}
