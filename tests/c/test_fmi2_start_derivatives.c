/* Directional derivatives before the run begins: all that follows from the start values, by each of them,
 * against differences of what the unit itself says of start values that are a little off. Both versions. */
#include "compare.h"
#include "fmi2_importer.h"
#include "fmi3_importer.h"
#include "fmi_interface.h"

#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <math.h>
#include <string.h>

enum { MAX_VARIABLES = 160 };

/* A start: its values, its modes, and its edges, the knowns by which it is not differentiable, because a step
 * either way leads to another mode. */
typedef struct {
    const char *what, *values;
    int contact, phase;
    const char *edges;
} start;

/* Values of every start: a patch, and a retraction rate, without which the hip's law has one term less. */
static const char always[] =
    "ground.patch_begin=3 ground.patch_end=4 hip.retraction_rate=0.1 hip.swing_clamp=1";

static const start starts[] = {
    {"at an apex", "gravity=0.02", TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE,
     "foot.vy leg.length leg.angle leg.length_rate leg.angle_rate body.mass foot.mass"},
    {"at an apex, upright", "foot.y=0.5 foot.vx=0.3 foot.vy=0 leg.angle=0 leg.length_rate=0 leg.angle_rate=0",
     TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, "foot.vy leg.length_rate"},
    {"at an apex, the leg level",
     "foot.y=0.5 foot.vx=0.3 foot.vy=0 leg.angle=1.5707963267948966 leg.length_rate=0 leg.angle_rate=0",
     TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, "foot.vy leg.angle_rate"},
    {"rising, the leg swung back, the clamp open",
     "foot.y=0.5 foot.vx=0.3 foot.vy=1 leg.angle=-0.6 leg.angle_rate=-1", TDMF_CONTACT_FLIGHT,
     TDMF_PHASE_RETRACT, ""},
    {"rising, the clamp closed",
     "foot.y=0.5 foot.vx=0.3 foot.vy=0.2 leg.angle=-0.6 leg.angle_rate=3 hip.external_torque=0.01",
     TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT, ""},
    {"rising, without a clamp",
     "foot.y=0.5 foot.vx=0.3 foot.vy=0.2 leg.angle=-0.6 leg.angle_rate=3 hip.external_torque=0.01 "
     "hip.swing_clamp=0",
     TDMF_CONTACT_FLIGHT, TDMF_PHASE_RETRACT, ""},
    {"falling", "foot.y=0.5 foot.vx=0.3 foot.vy=-0.4 leg.angle=1.24 leg.angle_rate=0.2", TDMF_CONTACT_FLIGHT,
     TDMF_PHASE_PLACE, ""},
    {"an impact, then slip forward",
     "foot.y=0 foot.vx=1.2 foot.vy=-0.3 leg.length=0.9 leg.angle=0.4 hip.external_torque=0.01",
     TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_DRIVE, "foot.y"},
    {"an impact, then slip backward",
     "foot.y=0 foot.vx=-1.2 foot.vy=-0.3 leg.length=0.9 leg.angle=-0.4 hip.external_torque=0.01",
     TDMF_CONTACT_SLIP_NEGATIVE, TDMF_PHASE_COAST, "foot.y"},
    {"an impact, then stick",
     "foot.y=0 foot.vx=0.1 foot.vy=-0.5 leg.length=0.8 leg.angle=0.2 leg.length_rate=0.1", TDMF_CONTACT_STICK,
     TDMF_PHASE_DRIVE, "foot.y"},
    {"slip, put on the ground",
     "foot.y=0 foot.vx=0.8 foot.vy=0 leg.length=0.8 leg.angle=0.4 leg.length_rate=0.1",
     TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_DRIVE, "foot.y foot.vy"},
    {"stick, put on the ground",
     "foot.y=0 foot.vx=0 foot.vy=0 leg.length=0.8 leg.angle=-0.2 hip.external_torque=0.01",
     TDMF_CONTACT_STICK, TDMF_PHASE_COAST, "foot.y foot.vx foot.vy"},
    {"a light foot on a stiff leg, falling",
     "foot.y=0.5 foot.vx=0.3 foot.vy=-0.4 leg.angle=1.24 leg.angle_rate=0.2 foot.mass=1e-6 leg.stiffness=1e5 "
     "leg.damping=30",
     TDMF_CONTACT_FLIGHT, TDMF_PHASE_PLACE, ""},
    {"a light foot on a stiff leg, after an impact",
     "foot.y=0 foot.vx=1.2 foot.vy=-0.3 leg.angle=1.24 leg.angle_rate=0.2 foot.mass=1e-6 leg.stiffness=1e5 "
     "leg.length=0.99",
     TDMF_CONTACT_SLIP_POSITIVE, TDMF_PHASE_DRIVE, "foot.y"},
    {"a heavy foot on Earth, in stick after an impact",
     "foot.y=0 foot.vx=0.1 foot.vy=-2 leg.angle=0.4 foot.mass=70 body.mass=80 leg.stiffness=2e4 gravity=9.81",
     TDMF_CONTACT_STICK, TDMF_PHASE_DRIVE, "foot.y"},
};

/* True for an edge of a start. If foot.y is an edge, so is everything that moves the ground. */
static bool is_edge(const start *start, const char *given) {
    const bool moves_ground = strcmp(given, "ground.height") == 0 || strcmp(given, "ground.slope") == 0;
    const char *name = moves_ground ? "foot.y" : given, *found = strstr(start->edges, name);
    const size_t length = strlen(name);
    while (found != NULL && found[length] != ' ' && found[length] != '\0') { /* part of a longer name */
        found = strstr(found + length, name);
    }
    return found != NULL;
}

static bool is_known(const fmu_variable *variable) {
    return variable->type == VARIABLE_REAL && variable->settable_before_start;
}

/* Real states, derivatives and outputs. */
static bool is_unknown(const fmu_variable *variable) {
    return variable->type == VARIABLE_REAL &&
           (variable->storage == STORED_STATE || variable->storage == STORED_DERIVATIVE ||
            variable->storage == STORED_OUTPUT || variable->storage == STORED_HELD);
}

/* True for a parameter that starts at its minimum, so that a difference has one side only. */
static bool starts_at_minimum(const fmu_variable *variable) {
    return variable->storage == STORED_PARAMETER && variable->type == VARIABLE_REAL &&
           variable->start == variable->minimum;
}

static double off_minimum(const fmu_variable *variable) {
    return variable->minimum + 0.2;
}

static void set_start_values(const fmi_interface *fmi, void *instance, const start *start) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        if (starts_at_minimum(&fmu_variables[i])) {
            const double value = off_minimum(&fmu_variables[i]);
            assert_int_equal(set_value(fmi, instance, fmu_variables[i].name, value), FMI_OK);
        }
    }
    set_values(fmi, instance, always);
    set_values(fmi, instance, start->values);
}

static fmi2Component initializing(const start *start, double time) {
    fmi2Component component = new_instance();
    set_start_values(&fmi2, component, start);
    assert_int_equal(fmi2SetupExperiment(component, fmi2False, 0.0, time, fmi2False, 0.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_int_equal(get_whole(component, "contact.mode"), start->contact);
    assert_int_equal(get_whole(component, "hip.phase"), start->phase);
    return component;
}

static void read_unknowns(fmi2Component component, double values[MAX_VARIABLES]) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmi2ValueReference reference = (fmi2ValueReference)i;
        if (is_unknown(&fmu_variables[i])) {
            assert_int_equal(fmi2GetReal(component, &reference, 1, &values[i]), fmi2OK);
        }
    }
}

/* Central differences of fourth order; `noise` is the effect of rounding on them. */
static void differences(fmi2Component component, const char *known, double values[MAX_VARIABLES],
                        double noise[MAX_VARIABLES]) {
    static const double weights[] = {1.0 / 12.0, -2.0 / 3.0, 2.0 / 3.0, -1.0 / 12.0};
    static const int multiples[] = {-2, -1, 1, 2};
    const double at = get_real(component, known);
    const double step = at == 0.0 ? 1e-4 : 1e-4 * fabs(at);
    memset(values, 0, MAX_VARIABLES * sizeof *values);
    memset(noise, 0, MAX_VARIABLES * sizeof *noise);
    for (int k = 0; k < 4; ++k) {
        double found[MAX_VARIABLES];
        assert_int_equal(set_real(component, known, at + multiples[k] * step), fmi2OK);
        read_unknowns(component, found);
        for (size_t i = 0; i < fmu_variable_count; ++i) {
            if (is_unknown(&fmu_variables[i])) {
                values[i] += weights[k] * found[i] / step;
                noise[i] = fmax(noise[i], fabs(found[i]) / step);
            }
        }
    }
    assert_int_equal(set_real(component, known, at), fmi2OK);
}

/* Compares a column; returns how many entries are not zero. */
static int compare_column(fmi2Component component, const start *start, fmi2ValueReference known) {
    double values[MAX_VARIABLES], noise[MAX_VARIABLES];
    /* Positive work has a kink where the hip's power is zero. */
    const fmi2ValueReference positive_power = reference_of("der(hip.positive_work)");
    const double power = get_real(component, "der(hip.work)");
    int nonzero = 0;
    double largest = 0.0;
    differences(component, fmu_variables[known].name, values, noise);
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        if (fmu_variables[i].storage == STORED_DERIVATIVE) {
            largest = fmax(largest, noise[i]); /* of large forces in balance on a light foot */
        }
    }
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmi2ValueReference unknown = (fmi2ValueReference)i;
        if (!is_unknown(&fmu_variables[i]) || (unknown == positive_power && power == 0.0)) {
            continue;
        }
        const double exact = derivative_of(&fmi2, component, unknown, known);
        const double rounding = fmu_variables[i].storage == STORED_DERIVATIVE ? largest : noise[i];
        const double tolerance = 1e-8 * fabs(exact) + 1e-13 * rounding;
        if (!(fabs(values[i] - exact) <= tolerance)) {
            fail_msg("%s: %s by %s is %.12g, by differences %.12g", start->what, fmu_variables[i].name,
                     fmu_variables[known].name, exact, values[i]);
        }
        nonzero += exact != 0.0 ? 1 : 0;
    }
    return nonzero;
}

TEST(they_are_those_of_the_start_values) {
    assert_true(fmu_variable_count <= MAX_VARIABLES);
    for (size_t k = 0; k < COUNT_OF(starts); ++k) {
        fmi2Component component = initializing(&starts[k], 0.0);
        int columns = 0, nonzero = 0, edges = 0;
        for (size_t j = 0; j < fmu_variable_count; ++j) {
            if (is_known(&fmu_variables[j]) && is_edge(&starts[k], fmu_variables[j].name)) {
                ++edges;
            } else if (is_known(&fmu_variables[j])) {
                nonzero += compare_column(component, &starts[k], (fmi2ValueReference)j);
                ++columns;
            }
        }
        assert_int_equal(columns + edges, START_VALUES);
        assert_true(nonzero > 30);
    }
}

/* Values in a run depend on time only through the states. */
TEST(by_time_they_are_those_of_the_instants) {
    const double seconds[] = {-1.0, 3.0};
    const uint32_t time = reference_of("time");
    for (size_t k = 0; k < COUNT_OF(starts); ++k) {
        double values[2][MAX_VARIABLES];
        int nonzero = 0;
        for (int run = 0; run < 2; ++run) {
            read_unknowns(initializing(&starts[k], seconds[run]), values[run]);
        }
        fmi2Component component = initializing(&starts[k], 1.0), running = initializing(&starts[k], 1.0);
        assert_int_equal(fmi2ExitInitializationMode(running), fmi2OK);
        for (size_t i = 0; i < fmu_variable_count; ++i) {
            if (is_unknown(&fmu_variables[i])) {
                const double exact = derivative_of(&fmi2, component, (uint32_t)i, time);
                assert_close(exact, (values[1][i] - values[0][i]) / 4.0, 1e-13);
                assert_true(derivative_of(&fmi2, running, (uint32_t)i, time) == 0.0);
                nonzero += exact != 0.0 ? 1 : 0;
            }
        }
        assert_int_equal(nonzero, k < 3 ? 2 : 1); /* event.last_time and, at an apex, apex.time */
    }
}

static bool is_known_in_a_run(const fmu_variable *variable) {
    return variable->storage == STORED_STATE || variable->storage == STORED_INPUT ||
           variable->storage == STORED_TIME || fmu_is_set_at_events(variable);
}

static bool is_known_at_the_start(const fmu_variable *variable) {
    return is_known(variable) || variable->storage == STORED_TIME;
}

/* FMI 3.0 agrees, and so does the adjoint: seeds' J v = (J' seeds)' v with v over all knowns. */
static void assert_same_both_ways_round(fmi2Component old, fmi3Instance instance,
                                        bool (*is_given)(const fmu_variable *variable)) {
    uint32_t knowns[MAX_VARIABLES], unknowns[MAX_VARIABLES];
    double seeds[MAX_VARIABLES], weights[MAX_VARIABLES], by_seed[MAX_VARIABLES], back[MAX_VARIABLES];
    size_t known_count = 0, unknown_count = 0;
    double forward = 0.0, backward = 0.0, size = 0.0;
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        if (is_given(&fmu_variables[i])) {
            seeds[known_count] = sin((double)i);
            knowns[known_count++] = (uint32_t)i;
        }
        if (is_unknown(&fmu_variables[i])) {
            weights[unknown_count] = cos((double)i);
            unknowns[unknown_count++] = (uint32_t)i;
        }
    }
    assert_int_equal(fmi3GetDirectionalDerivative(instance, unknowns, unknown_count, knowns, known_count,
                                                  seeds, known_count, by_seed, unknown_count),
                     fmi3OK);
    assert_int_equal(fmi3GetAdjointDerivative(instance, unknowns, unknown_count, knowns, known_count, weights,
                                              unknown_count, back, known_count),
                     fmi3OK);
    for (size_t i = 0; i < unknown_count; ++i) {
        forward += weights[i] * by_seed[i];
        size += fabs(weights[i] * by_seed[i]);
    }
    for (size_t j = 0; j < known_count; ++j) {
        backward += seeds[j] * back[j];
        size += fabs(seeds[j] * back[j]);
    }
    assert_close(forward, backward, 1e-12 * size);
    assert_int_equal(
        fmi2GetDirectionalDerivative(old, unknowns, unknown_count, knowns, known_count, seeds, back), fmi2OK);
    assert_memory_equal(back, by_seed, unknown_count * sizeof *back);
}

TEST(fmi3_gives_the_same_both_ways_round) {
    for (size_t k = 0; k < COUNT_OF(starts); ++k) {
        fmi2Component old = initializing(&starts[k], 0.0);
        fmi3Instance instance = new_exchange();
        set_start_values(&fmi3, instance, &starts[k]);
        assert_int_equal(fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0), fmi3OK);
        assert_same_both_ways_round(old, instance, is_known_at_the_start);
        assert_int_equal(fmi2ExitInitializationMode(old), fmi2OK);
        assert_int_equal(fmi3ExitInitializationMode(instance), fmi3OK);
        assert_same_both_ways_round(old, instance, is_known_in_a_run);
    }
}

/* Values that a start sets to zero depend on nothing, whatever they were before. */
TEST(integrals_begin_at_zero) {
    const uint32_t work = reference_of("hip.work");
    fmi2Component component = initializing(&starts[0], 0.0);
    assert_true(derivative_of(&fmi2, component, work, work) == 0.0);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
    assert_true(derivative_of(&fmi2, component, work, work) == 1.0);
}
