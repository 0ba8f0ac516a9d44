/* How long a stride of the reduced map may take: the flight down and the stance each as long as is asked for,
 * counted from where each begins; and a touchdown that is not found is not one at once. */
#include "compare.h"
#include "reference_gaits.h"
#include "simulation.h"
#include "system_of.h"

#include "tdmf_slip/reduced_map.h"

#include <math.h>
#include <string.h>

typedef struct {
    tdmf_model model;
    tdmf_inputs inputs;
    double apex[TDMF_REDUCED_COUNT];
    double descent, stance; /* s, of the stride from there */
} scene;

static tdmf_return stride(const scene *scene, double until, tdmf_event_log *log) {
    tdmf_solver solver = tdmf_solver_default();
    solver.log = log;
    return tdmf_reduced_map(&solver, SYSTEM_OF(scene), scene->apex, until, false, NULL, 0);
}

static scene stride_known(void) {
    const tdmf_parameters parameters = tdmf_default_parameters();
    scene scene;
    tdmf_event_log log;
    memset(&scene, 0, sizeof scene);
    memset(&log, 0, sizeof log);
    scene.model = accepted_model(&parameters);
    scene.inputs = tdmf_default_inputs();
    memcpy(scene.apex, &reference_gaits[DEFAULT_GAIT].apex, sizeof scene.apex);
    const tdmf_return whole = stride(&scene, 1e3, &log);
    assert_int_equal(whole.outcome, TDMF_RETURN_CLOSED);
    assert_int_equal(log.events[0].guard, TDMF_GUARD_TOUCHDOWN);
    scene.descent = log.events[0].time;
    scene.stance = whole.stride.stance_time;
    return scene;
}

TEST(the_stance_has_its_own_time) {
    const scene scene = stride_known();
    const double longer = fmax(scene.descent, scene.stance), shorter = fmin(scene.descent, scene.stance);
    assert_true(shorter > 0.05 * longer);
    assert_int_equal(stride(&scene, longer * 1.01, NULL).outcome, TDMF_RETURN_CLOSED);
    assert_true(longer * 1.01 < scene.descent + scene.stance);
    scene.descent < scene.stance
        ? assert_int_equal(stride(&scene, longer * 0.99, NULL).outcome, TDMF_RETURN_TOO_LONG)
        : assert_int_equal(stride(&scene, longer * 0.99, NULL).outcome, TDMF_RETURN_NO_TOUCHDOWN);
}

TEST(the_descent_has_its_own_time) {
    const scene scene = stride_known();
    assert_int_equal(stride(&scene, scene.descent * (1.0 - 1e-9), NULL).outcome, TDMF_RETURN_NO_TOUCHDOWN);
    assert_int_not_equal(stride(&scene, scene.descent * (1.0 + 1e-9), NULL).outcome,
                         TDMF_RETURN_NO_TOUCHDOWN);
}
