/* Calls whose arguments are alike in FMI 2.0 and 3.0, and the table of a version. The importer of each
 * version includes this file behind the calls that differ. It defines FMI(Name) as the function of its
 * version, FMI_STATE(Name, Rest) as a call for saved states, which the versions spell differently, and
 * FMI_KINDS as the first kind that it lacks. */

ANSWERS(set_logging, (void *instance, bool on, size_t count, const char *const names[]),
        FMI(SetDebugLogging)(instance, on, count, names))
ANSWERS(exit_initialization, (void *instance), FMI(ExitInitializationMode)(instance))
ANSWERS(enter_event_mode, (void *instance), FMI(EnterEventMode)(instance))
ANSWERS(enter_continuous_time_mode, (void *instance), FMI(EnterContinuousTimeMode)(instance))

static fmi_status complete_step(void *instance, bool *asks_for_event_mode, bool *asks_to_stop) {
    FMI(Boolean) enter = *asks_for_event_mode, stop = *asks_to_stop;
    const fmi_status status = (fmi_status)FMI(CompletedIntegratorStep)(instance, true, &enter, &stop);
    *asks_for_event_mode = enter;
    *asks_to_stop = stop;
    return status;
}

ANSWERS(terminate, (void *instance), FMI(Terminate)(instance))
ANSWERS(reset, (void *instance), FMI(Reset)(instance))
ANSWERS(set_time, (void *instance, double time), FMI(SetTime)(instance, time))
ANSWERS(set_states, (void *instance, const double states[], size_t count),
        FMI(SetContinuousStates)(instance, states, count))
ANSWERS(get_states, (void *instance, double states[], size_t count),
        FMI(GetContinuousStates)(instance, states, count))
ANSWERS(get_indicators, (void *instance, double indicators[], size_t count),
        FMI(GetEventIndicators)(instance, indicators, count))
ANSWERS(get_nominals, (void *instance, double nominals[], size_t count),
        FMI(GetNominalsOfContinuousStates)(instance, nominals, count))
ANSWERS(save, (void *instance, void **saved), FMI_STATE(Get, )(instance, saved))
ANSWERS(set_saved, (void *instance, void *saved), FMI_STATE(Set, )(instance, saved))
ANSWERS(free_saved, (void *instance, void **saved), FMI_STATE(Free, )(instance, saved))
ANSWERS(measure, (void *instance, void *saved, size_t *size),
        FMI_STATE(Serialized, Size)(instance, saved, size))
ANSWERS(write_saved, (void *instance, void *saved, unsigned char bytes[], size_t size),
        FMI_STATE(Serialize, )(instance, saved, (FMI(Byte) *)bytes, size))
ANSWERS(deserialize, (void *instance, const unsigned char bytes[], size_t size, void **saved),
        FMI_STATE(Deserialize, )(instance, (const FMI(Byte) *)bytes, size, saved))

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
                             .restore = set_saved,
                             .free_saved = free_saved,
                             .measure = measure,
                             .serialize = write_saved,
                             .deserialize = deserialize};
