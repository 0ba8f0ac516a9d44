/* Peaks of the ground force within a step: where it turns from rising to falling, and there only. */
#include "compare.h"
#include "extrema.h"

#include <math.h>
#include <string.h>

static const double step_size = 2.0;

/* f_n = 1 + cos(from + rate t)/10 in a step on level ground, by its Taylor series. */
typedef struct {
    tdmf_model model;
    tdmf_mode_equations equations;
    tdmf_step step;
    tdmf_mode mode;
} scene;

static void stand(scene *scene, double from, double rate) {
    const tdmf_parameters parameters = tdmf_default_parameters();
    memset(scene, 0, sizeof *scene);
    assert_null(tdmf_model_create(&scene->model, &parameters).variable);
    scene->equations.model = &scene->model;
    scene->equations.contact = TDMF_CONTACT_STICK;
    scene->equations.ground = tdmf_ground_line_of(0.0, 0.0);
    scene->mode.contact = TDMF_CONTACT_STICK;
    scene->mode.ground_force_rising = -rate * sin(from) > 0.0;
    tdmf_step *step = &scene->step;
    step->equations = &scene->equations;
    step->order = SERIES_ORDER_LIMIT;
    step->size = step->search.size = step_size;
    set_powers(step->search.power, step_size, step->order);
    double *force = step->series.ground.normal_force;
    double factor = 0.1;
    for (int k = 0; k < step->order; ++k) {
        force[k] = factor * cos(from + 0.5 * acos(-1.0) * k);
        factor *= rate / (k + 1);
    }
    force[0] += 1.0;
}

static double turn(double share) {
    return share * 2.0 * acos(-1.0);
}

/* The step goes from a quarter of a period before its least value to a quarter after it. */
static void the_least_force_is_no_peak(void **state) {
    scene scene;
    (void)state;
    stand(&scene, turn(0.25), turn(0.5) / step_size);
    assert_false(scene.mode.ground_force_rising);
    const tdmf_force_peaks peaks = tdmf_largest_peaks(&scene.step, step_size, &scene.mode);
    assert_true(peaks.normal.time == INFINITY && peaks.normal.force == -INFINITY);
    assert_true(peaks.vertical.time == INFINITY && peaks.vertical.force == -INFINITY);
    assert_true(scene.mode.ground_force_rising && scene.mode.vertical_force_rising);
}

static void the_largest_force_is_one(void **state) {
    scene scene;
    (void)state;
    stand(&scene, turn(0.75), turn(0.5) / step_size);
    assert_true(scene.mode.ground_force_rising);
    const tdmf_force_peaks peaks = tdmf_largest_peaks(&scene.step, step_size, &scene.mode);
    assert_close(peaks.normal.time, 0.5 * step_size, 1e-8);
    assert_close(peaks.normal.force, 1.1, 1e-14);
    assert_false(scene.mode.ground_force_rising);
}

/* The least force comes first in the step. */
static void of_two_turns_the_largest_force_is_told(void **state) {
    scene scene;
    (void)state;
    stand(&scene, turn(0.4), turn(0.65) / step_size);
    const tdmf_force_peaks peaks = tdmf_largest_peaks(&scene.step, step_size, &scene.mode);
    assert_close(peaks.normal.time, 0.6 / 0.65 * step_size, 1e-8);
    assert_close(peaks.normal.force, 1.1, 1e-14);
    assert_false(scene.mode.ground_force_rising);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_least_force_is_no_peak),
        cmocka_unit_test(the_largest_force_is_one),
        cmocka_unit_test(of_two_turns_the_largest_force_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
