/* Calls whose arguments are alike in FMI 2.0 and 3.0, and the table of a version. The importer of each
 * version includes this behind the calls that differ. It defines FMI(Name) as what its version calls so,
 * FMI_STATE(Name, Rest) as a call for saved states, in which the versions spell a word in two ways, and
 * FMI_KINDS as the first kind that it has not. */

static fmi_status set_logging(void *instance, bool on, size_t count, const char *const names[]) {
    return (fmi_status)FMI(SetDebugLogging)(instance, on, count, names);
}

static fmi_status exit_initialization(void *instance) {
    return (fmi_status)FMI(ExitInitializationMode)(instance);
}

static fmi_status enter_event_mode(void *instance) {
    return (fmi_status)FMI(EnterEventMode)(instance);
}

static fmi_status enter_continuous_time_mode(void *instance) {
    return (fmi_status)FMI(EnterContinuousTimeMode)(instance);
}

static fmi_status complete_step(void *instance, bool *asks_for_event_mode, bool *asks_to_stop) {
    FMI(Boolean) enter = *asks_for_event_mode, stop = *asks_to_stop;
    const fmi_status status = (fmi_status)FMI(CompletedIntegratorStep)(instance, true, &enter, &stop);
    *asks_for_event_mode = enter;
    *asks_to_stop = stop;
    return status;
}

static fmi_status terminate(void *instance) {
    return (fmi_status)FMI(Terminate)(instance);
}

static fmi_status reset(void *instance) {
    return (fmi_status)FMI(Reset)(instance);
}

static fmi_status set_time(void *instance, double time) {
    return (fmi_status)FMI(SetTime)(instance, time);
}

static fmi_status set_states(void *instance, const double states[], size_t count) {
    return (fmi_status)FMI(SetContinuousStates)(instance, states, count);
}

static fmi_status get_states(void *instance, double states[], size_t count) {
    return (fmi_status)FMI(GetContinuousStates)(instance, states, count);
}

static fmi_status get_indicators(void *instance, double indicators[], size_t count) {
    return (fmi_status)FMI(GetEventIndicators)(instance, indicators, count);
}

static fmi_status get_nominals(void *instance, double nominals[], size_t count) {
    return (fmi_status)FMI(GetNominalsOfContinuousStates)(instance, nominals, count);
}

static fmi_status save(void *instance, void **saved) {
    return (fmi_status)FMI_STATE(Get, )(instance, saved);
}

static fmi_status restore(void *instance, void *saved) {
    return (fmi_status)FMI_STATE(Set, )(instance, saved);
}

static fmi_status free_saved(void *instance, void **saved) {
    return (fmi_status)FMI_STATE(Free, )(instance, saved);
}

static fmi_status measure(void *instance, void *saved, size_t *size) {
    return (fmi_status)FMI_STATE(Serialized, Size)(instance, saved, size);
}

static fmi_status serialize(void *instance, void *saved, unsigned char bytes[], size_t size) {
    return (fmi_status)FMI_STATE(Serialize, )(instance, saved, (FMI(Byte) *)bytes, size);
}

static fmi_status deserialize(void *instance, const unsigned char bytes[], size_t size, void **saved) {
    return (fmi_status)FMI_STATE(Deserialize, )(instance, (const FMI(Byte) *)bytes, size, saved);
}

const fmi_interface FMI() = {.kinds = FMI_KINDS,
                             .instantiate = instantiate,
                             .free = FMI(FreeInstance),
                             .set_logging = set_logging,
                             .enter_initialization = enter_initialization,
                             .exit_initialization = exit_initialization,
                             .enter_event_mode = enter_event_mode,
                             .update = update_states,
                             .enter_continuous_time_mode = enter_continuous_time_mode,
                             .enter_step_mode = enter_step_mode,
                             .complete_step = complete_step,
                             .do_step = make_step,
                             .terminate = terminate,
                             .reset = reset,
                             .set_time = set_time,
                             .set_states = set_states,
                             .get_states = get_states,
                             .get_derivatives = get_derivatives,
                             .get_indicators = get_indicators,
                             .get_nominals = get_nominals,
                             .get_reals = get_reals,
                             .set_reals = set_reals,
                             .get_integer = read_integer,
                             .get_item = get_item,
                             .set_item = set_item,
                             .get_truth = get_truth,
                             .set_truth = set_truth,
                             .directional_derivative = directional_derivative,
                             .output_derivative = output_derivative,
                             .save = save,
                             .restore = restore,
                             .free_saved = free_saved,
                             .measure = measure,
                             .serialize = serialize,
                             .deserialize = deserialize};
