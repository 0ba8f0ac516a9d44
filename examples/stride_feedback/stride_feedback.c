/* Feedback from stride to stride, through the unit: its tunable settings are set at each apex, in event mode.
 *
 * The law is dead-beat, for the gait of the unit's start values, as tdmf_slip.dead_beat makes it of the exact
 * return map: touchdown angle and stance torque of each stride follow from the apex at which it begins,
 *
 *     setting i = nominal i + sum of gain ij (apex j - gait j), within the limits of i.
 *
 * A runner that is pushed at its first apex is back on the gait after two strides. The program is the
 * importer: Model Exchange, with the classic method of Runge and Kutta, and events located by bisection. It
 * writes a row for each apex, with the settings of the stride that begins there. */
#include "fmu_library.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COORDINATES = 6, SETTINGS = 2, PUSHES = 2, STRIDES = 6, BISECTIONS = 60 };
enum { MAX_STATES = 32, MAX_INDICATORS = 32 };
static const double step = 1e-3;     /* s */
static const double longest = 100.0; /* s; a stride that takes longer is none */

static const char *const coordinate_names[COORDINATES] = {"apex.com_height",      "apex.com_speed",
                                                          "apex.leg_length",      "apex.leg_angle",
                                                          "apex.leg_length_rate", "apex.leg_angle_rate"};
static const char *const setting_names[SETTINGS] = {"hip.touchdown_angle", "hip.stance_torque"};
static const double gait[COORDINATES] = {1.4185081527459575,  1.0620047462715523,     0.9999993776846997,
                                         -0.5462532571145319, 1.1268102273045027e-06, 4.039363331787232e-05};
static const double nominal[SETTINGS] = {0.6981317007977318, 0.2};
static const double gain[SETTINGS][COORDINATES] = {
    {-0.029797520858160162, -0.18620795330990733, 0.00021380560034669154, 0.0016455611226696128,
     6.124576371498846e-06, 0.001599358330147895},
    {0.43708763545179213, -0.1935808738505937, 3.4189738581685566e-06, 4.052951675699531e-05,
     -3.0746758710377296e-06, 8.50124857852615e-06}};
static const double low[SETTINGS] = {-1.5707963267948966, 0.0};
static const double high[SETTINGS] = {1.5707963267948966, 0.6};
static const char *const pushed_names[PUSHES] = {"foot.y", "foot.vx"};
static const double pushes[PUSHES] = {0.05, 0.05}; /* m, m/s: the whole runner, at the first apex */

typedef struct {
    fmu_functions call;
    fmi2Component unit;
    size_t states, indicators;
    double time;
    fmi2ValueReference coordinates[COORDINATES], settings[SETTINGS], pushed[PUSHES], stride_count;
} importer;

/* ---- calls -------------------------------------------------------------------------------------------- */

static void check(fmi2Status status, const char *call) {
    if (status != fmi2OK) {
        fail("the unit refuses", call);
    }
}

static void tell(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status,
                 fmi2String category, fmi2String message, ...) {
    (void)environment;
    (void)status;
    fprintf(stderr, "%s: %s: %s\n", instance, category, message);
}

static const fmi2CallbackFunctions callbacks = {tell, calloc, free, NULL, NULL};

static importer start(const fmu_description *description, const char *library) {
    importer runner = {.call = load_fmu(library), .states = count_states(description)};
    char guid[64], indicators[16];
    attribute_of(description, "guid", guid, sizeof guid);
    attribute_of(description, "numberOfEventIndicators", indicators, sizeof indicators);
    runner.indicators = strtoul(indicators, NULL, 10);
    if (runner.states > MAX_STATES || runner.indicators > MAX_INDICATORS) {
        fail("too many states or event indicators", indicators);
    }
    for (int i = 0; i < COORDINATES; ++i) {
        runner.coordinates[i] = reference_of(description, coordinate_names[i]);
    }
    for (int i = 0; i < SETTINGS; ++i) {
        runner.settings[i] = reference_of(description, setting_names[i]);
    }
    for (int i = 0; i < PUSHES; ++i) {
        runner.pushed[i] = reference_of(description, pushed_names[i]);
    }
    runner.stride_count = reference_of(description, "stride.count");
    runner.unit =
        runner.call.instantiate("runner", fmi2ModelExchange, guid, "", &callbacks, fmi2False, fmi2False);
    if (runner.unit == NULL) {
        fail("no instance of", library);
    }
    return runner;
}

/* Initializes at the gait's apex, pushed, and leaves the unit in event mode. */
static void initialize(importer *runner) {
    const fmu_functions *call = &runner->call;
    double values[PUSHES];
    check(call->get_real(runner->unit, runner->pushed, PUSHES, values), "fmi2GetReal");
    for (int i = 0; i < PUSHES; ++i) {
        values[i] += pushes[i];
    }
    check(call->set_real(runner->unit, runner->pushed, PUSHES, values), "fmi2SetReal");
    check(call->setup_experiment(runner->unit, fmi2False, 0.0, 0.0, fmi2False, 0.0), "fmi2SetupExperiment");
    check(call->enter_initialization_mode(runner->unit), "fmi2EnterInitializationMode");
    check(call->exit_initialization_mode(runner->unit), "fmi2ExitInitializationMode");
}

static int strides_of(const importer *runner) {
    fmi2Integer count = 0;
    check(runner->call.get_integer(runner->unit, &runner->stride_count, 1, &count), "fmi2GetInteger");
    return count;
}

/* Has the unit take an event and what was set into account; true if it ends the run there. */
static int update(importer *runner) {
    fmi2EventInfo info;
    do {
        check(runner->call.new_discrete_states(runner->unit, &info), "fmi2NewDiscreteStates");
    } while (info.newDiscreteStatesNeeded && !info.terminateSimulation);
    return info.terminateSimulation;
}

/* ---- between events ----------------------------------------------------------------------------------- */

static void put(importer *runner, double time, const double states[]) {
    check(runner->call.set_time(runner->unit, time), "fmi2SetTime");
    check(runner->call.set_states(runner->unit, states, runner->states), "fmi2SetContinuousStates");
}

/* The change of the states over h, were they to change as they do at a point. */
static void change(importer *runner, double time, const double states[], double h, double changes[]) {
    put(runner, time, states);
    check(runner->call.get_derivatives(runner->unit, changes, runner->states), "fmi2GetDerivatives");
    for (size_t i = 0; i < runner->states; ++i) {
        changes[i] *= h;
    }
}

/* Goes on from a time and its states by h, to where the unit then is. */
static void advance(importer *runner, double time, const double states[], double h, double after[]) {
    static const double part[] = {0.0, 0.5, 0.5, 1.0}, weight[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    double changes[MAX_STATES] = {0.0}, stage[MAX_STATES];
    memcpy(after, states, runner->states * sizeof *after);
    for (int k = 0; k < 4; ++k) {
        for (size_t i = 0; i < runner->states; ++i) {
            stage[i] = states[i] + part[k] * changes[i];
        }
        change(runner, time + part[k] * h, stage, h, changes);
        for (size_t i = 0; i < runner->states; ++i) {
            after[i] += weight[k] * changes[i];
        }
    }
    put(runner, time + h, after);
}

static void look(importer *runner, double indicators[]) {
    check(runner->call.get_indicators(runner->unit, indicators, runner->indicators),
          "fmi2GetEventIndicators");
}

/* Returns whether an indicator has changed between above 0 and not above 0. */
static int has_event(importer *runner, const double before[]) {
    double now[MAX_INDICATORS];
    look(runner, now);
    for (size_t i = 0; i < runner->indicators; ++i) {
        if ((before[i] > 0.0) != (now[i] > 0.0)) {
            return 1;
        }
    }
    return 0;
}

/* The shortest step after which there is an event, where there is one after h. */
static double step_to_event(importer *runner, const double states[], const double before[], double h) {
    double without = 0.0, with = h, after[MAX_STATES];
    for (int i = 0; i < BISECTIONS; ++i) {
        const double middle = 0.5 * (without + with);
        advance(runner, runner->time, states, middle, after);
        *(has_event(runner, before) ? &with : &without) = middle;
    }
    return with;
}

/* Runs from event mode to the next event, and enters event mode again. */
static void run_to_event(importer *runner, double until) {
    double states[MAX_STATES], after[MAX_STATES] = {0.0}, before[MAX_INDICATORS];
    fmi2Boolean found = fmi2False, asked = fmi2False, ends = fmi2False;
    check(runner->call.enter_continuous_time_mode(runner->unit), "fmi2EnterContinuousTimeMode");
    check(runner->call.get_states(runner->unit, states, runner->states), "fmi2GetContinuousStates");
    look(runner, before);
    while (!found && !asked) {
        double h = step;
        if (runner->time >= until) {
            fail("no stride closes", "it takes too long");
        }
        advance(runner, runner->time, states, h, after);
        found = has_event(runner, before);
        if (found) {
            h = step_to_event(runner, states, before, h);
            advance(runner, runner->time, states, h, after);
        }
        runner->time += h;
        memcpy(states, after, sizeof states);
        check(runner->call.completed_integrator_step(runner->unit, fmi2True, &asked, &ends),
              "fmi2CompletedIntegratorStep");
    }
    check(runner->call.enter_event_mode(runner->unit), "fmi2EnterEventMode");
}

/* Runs from event mode to the event that closes a stride; returns false after a fall. */
static int run_to_apex(importer *runner) {
    const int strides = strides_of(runner);
    const double until = runner->time + longest;
    int ended = update(runner);
    while (!ended && strides_of(runner) == strides) {
        run_to_event(runner, until);
        ended = update(runner);
    }
    return !ended;
}

/* ---- at the apex -------------------------------------------------------------------------------------- */

static void set_by_law(const double apex[COORDINATES], double values[SETTINGS]) {
    for (int i = 0; i < SETTINGS; ++i) {
        values[i] = nominal[i];
        for (int j = 0; j < COORDINATES; ++j) {
            values[i] += gain[i][j] * (apex[j] - gait[j]);
        }
        values[i] = fmin(fmax(values[i], low[i]), high[i]);
    }
}

static void write_row(int stride, const double apex[COORDINATES], const double values[SETTINGS]) {
    printf("%d", stride);
    for (int i = 0; i < COORDINATES; ++i) {
        printf(",%.17g", apex[i]);
    }
    for (int i = 0; i < SETTINGS; ++i) {
        printf(",%.17g", values[i]);
    }
    printf("\n");
}

int main(int argc, char *argv[]) {
    fmu_description description = read_description(argc > 2 ? argv[1] : FMU_DESCRIPTION);
    importer runner = start(&description, argc > 2 ? argv[2] : FMU_LIBRARY);
    free_description(&description);
    initialize(&runner);
    printf("stride,com_height,com_speed,leg_length,leg_angle,leg_length_rate,leg_angle_rate,touchdown_angle,"
           "stance_torque\n");
    int runs = 1;
    for (int stride = 0; runs && stride <= STRIDES; ++stride) {
        double apex[COORDINATES], values[SETTINGS];
        check(runner.call.get_real(runner.unit, runner.coordinates, COORDINATES, apex), "fmi2GetReal");
        set_by_law(apex, values);
        write_row(stride, apex, values);
        check(runner.call.set_real(runner.unit, runner.settings, SETTINGS, values), "fmi2SetReal");
        runs = run_to_apex(&runner);
    }
    runner.call.free_instance(runner.unit);
    return runs ? EXIT_SUCCESS : EXIT_FAILURE;
}
