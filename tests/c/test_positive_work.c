/* The hip's work at positive power, of a power whose turns are known: cos(from + rate t) (torque +
 * torque_rate t). */
#include "compare.h"
#include "positive_work.h"
#include "series_products.h"

#include <math.h>
#include <string.h>

static const double step_size = 2.0;

typedef struct {
    double from, rate, torque, torque_rate;
} power_law;

typedef struct {
    tdmf_model model;
    tdmf_mode_equations equations;
    tdmf_step step;
} scene;

static void stand(scene *scene, const power_law *law) {
    const tdmf_parameters parameters = tdmf_default_parameters();
    memset(scene, 0, sizeof *scene);
    assert_null(tdmf_model_create(&scene->model, &parameters).variable);
    scene->equations.model = &scene->model;
    scene->equations.contact = TDMF_CONTACT_STICK;
    scene->equations.law.torque = law->torque;
    scene->equations.law.torque_rate = law->torque_rate;
    tdmf_step *step = &scene->step;
    step->equations = &scene->equations;
    step->order = SERIES_ORDER_LIMIT;
    step->size = step->search.size = step_size;
    set_powers(step->search.power, step_size, step->order);
    ground_series *g = &step->series.ground;
    double factor = 1.0;
    for (int k = 0; k <= step->order; ++k) {
        g->moment[k] = factor * cos(law->from + 0.5 * acos(-1.0) * k);
        factor *= law->rate / (k + 1);
    }
    g->torque[0] = law->torque;
    g->torque[1] = law->torque_rate;
    for (int k = 0; k <= step->order; ++k) {
        g->power[k] = product(g->torque, g->moment, k);
    }
}

/* The antiderivative. */
static double work_up_to(const power_law *law, double t) {
    const double angle = law->from + law->rate * t;
    return (law->torque + law->torque_rate * t) * sin(angle) / law->rate +
           law->torque_rate * cos(angle) / (law->rate * law->rate);
}

static double work_between(const power_law *law, double from, double to) {
    return work_up_to(law, to) - work_up_to(law, from);
}

static bool is_positive(const power_law *law, double t) {
    return cos(law->from + law->rate * t) * (law->torque + law->torque_rate * t) > 0.0;
}

/* Turns are where the cosine is zero, and where the torque is. */
static double exact(const power_law *law, double end) {
    double turn[16];
    int count = 0;
    turn[count++] = 0.0;
    for (int k = -6; k <= 6; ++k) {
        turn[count++] = ((k + 0.5) * acos(-1.0) - law->from) / law->rate;
    }
    turn[count++] = law->torque_rate != 0.0 ? -law->torque / law->torque_rate : 0.0;
    turn[count++] = end;
    double sum = 0.0, from = 0.0;
    while (from < end) {
        double to = end;
        for (int i = 0; i < count; ++i) {
            to = turn[i] > from && turn[i] < to ? turn[i] : to;
        }
        sum += is_positive(law, 0.5 * (from + to)) ? work_between(law, from, to) : 0.0;
        from = to;
    }
    return sum;
}

static void assert_exact(const power_law *law, double end) {
    scene scene;
    tdmf_spans spans;
    stand(&scene, law);
    const double total = tdmf_step_work(&scene.step, end);
    const double positive = exact(law, end);
    assert_close(total, work_between(law, 0.0, end), 1e-13);
    assert_close(tdmf_positive_work(&scene.step, end, total), positive, 1e-13);
    tdmf_positive_spans(&scene.step, end, total, &spans);
    double sum = 0.0;
    for (int i = 0; i < spans.count; ++i) {
        assert_true(spans.from[i] >= (i > 0 ? spans.to[i - 1] : 0.0) && spans.to[i] <= end);
        sum += work_between(law, spans.from[i], spans.to[i]);
    }
    assert_close(sum, positive, 1e-13);
}

static void all_turns_count_at_any_phase(void **state) {
    (void)state;
    for (int i = 0; i < 400; ++i) {
        const double phase = i * (2.0 * acos(-1.0) / 400);
        const power_law slow = {phase, 0.4, 0.7, -0.5}, fast = {phase, 1.8, 0.2, -0.3};
        const power_law constant = {phase, 2.0, -0.6, 0.0};
        assert_exact(&slow, step_size);
        assert_exact(&fast, step_size);
        assert_exact(&constant, step_size);
        assert_exact(&fast, 0.37 * step_size);
    }
}

/* Torque and rate turn one close after the other, or at once. */
static void neighbouring_turns_are_told_apart(void **state) {
    (void)state;
    for (int power = 0; power <= 14; ++power) {
        const double middle = 0.6, apart = pow(10.0, -power);
        const power_law near = {0.5 * acos(-1.0) - 1.3 * middle, 1.3, -0.8 * (middle + apart), 0.8};
        assert_exact(&near, step_size);
    }
}

/* The rate is as good as zero at the start of a step that begins at its turn. */
static void a_turn_at_the_start_is_none_too_many(void **state) {
    (void)state;
    for (int sign = -1; sign <= 1; ++sign) {
        const power_law law = {0.5 * acos(-1.0) + 1e-15 * sign, 1.0, 0.5, 0.0};
        assert_exact(&law, step_size);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_turns_count_at_any_phase),
        cmocka_unit_test(neighbouring_turns_are_told_apart),
        cmocka_unit_test(a_turn_at_the_start_is_none_too_many),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
