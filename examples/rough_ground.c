/* A runner on steps of random height, by the library alone: the ground is somebody else's business, and
 * changes as the foot moves on.
 *
 *     cc -std=c99 rough_ground.c -ltdmf_slip -lm -o rough_ground
 *     ./rough_ground [roughness] [seed]
 *
 * writes a row for each stride: its number, where the centre of mass is at its end, the height of the ground
 * there, the gait word and the speed. */
#include <tdmf_slip/tdmf_slip.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { EDGES = 80, STRIDES = 20 };
static const double first_edge = 15.0, tread = 7.0; /* m */
static const double look = 0.05;                    /* s between two looks at what is below the foot */

/* Points from left to right; beyond the first and the last the ground goes on level. */
typedef struct {
    size_t count;
    double x[2 * EDGES], y[2 * EDGES];
} profile;

/* Uniform in (0, 1), the same on every machine. */
static double uniform(uint64_t *state) {
    *state += UINT64_C(0x9e3779b97f4a7c15);
    uint64_t bits = *state;
    bits = (bits ^ (bits >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    bits = (bits ^ (bits >> 27)) * UINT64_C(0x94d049bb133111eb);
    return ((double)((bits ^ (bits >> 31)) >> 11) + 0.5) * 0x1p-53;
}

static double normal(uint64_t *state) {
    const double radius = sqrt(-2.0 * log(uniform(state)));
    return radius * cos(6.283185307179586 * uniform(state));
}

static profile random_steps(double roughness, uint64_t seed) {
    profile ground = {.count = 2 * EDGES};
    double height = 0.0;
    for (int i = 0; i < EDGES; ++i) {
        ground.x[2 * i] = ground.x[2 * i + 1] = first_edge + tread * i;
        ground.y[2 * i] = height;
        height += roughness * normal(&seed);
        ground.y[2 * i + 1] = height;
    }
    return ground;
}

/* Sets the line of the profile below x, as the inputs want it: its height at x = 0, and its slope. */
static void set_ground(tdmf_inputs *inputs, const profile *ground, double x) {
    size_t after = 0;
    while (after < ground->count && ground->x[after] <= x) {
        ++after;
    }
    const size_t last = after > 0 ? after - 1 : 0;
    const size_t next = after < ground->count ? after : last;
    const double run = ground->x[next] - ground->x[last];
    const double steepness = run > 0.0 ? (ground->y[next] - ground->y[last]) / run : 0.0;
    inputs->ground.height = ground->y[last] - steepness * ground->x[last];
    inputs->ground.slope = atan(steepness);
}

int main(int argc, char *argv[]) {
    const double roughness = argc > 1 ? atof(argv[1]) : 0.01;
    const profile ground = random_steps(roughness, argc > 2 ? (uint64_t)atoi(argv[2]) : 1);
    const tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_solver solver = tdmf_solver_default();
    tdmf_model model;
    const tdmf_system system = {&model, &inputs};
    tdmf_motion run = {.time = 0.0};
    tdmf_outputs now;
    char text[256];

    tdmf_default_state(run.state);
    set_ground(&inputs, &ground, run.state[TDMF_FOOT_X]);
    tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    if (refusal.variable == NULL) {
        refusal = tdmf_start(system, &run);
    }
    if (refusal.variable != NULL) {
        fprintf(stderr, "%s\n", tdmf_refusal_text(&refusal, text, sizeof text));
        return EXIT_FAILURE;
    }
    printf("stride,x,ground,word,speed\n");
    for (int strides = 0; strides < STRIDES && !run.mode.fallen;) {
        set_ground(&inputs, &ground, run.state[TDMF_FOOT_X]);
        const tdmf_outcome outcome = tdmf_native_advance(&solver, system, NULL, run.time + look, &run);
        if (outcome != TDMF_ARRIVED && outcome != TDMF_FELL) {
            fprintf(stderr, "%s\n", tdmf_outcome_text(outcome));
            return EXIT_FAILURE;
        }
        if (run.state[TDMF_STRIDE_COUNT] > strides) {
            tdmf_outputs_of(system, &run, &now);
            strides = now.stride.count;
            printf("%d,%.3f,%.4f,%s,%.4f\n", strides, now.com.x, inputs.ground.height, now.stride.word,
                   now.stride.speed);
        }
    }
    if (run.mode.fallen) {
        tdmf_outputs_of(system, &run, &now);
        fprintf(stderr, "fell at x = %.3f\n", now.com.x);
    }
    return EXIT_SUCCESS;
}
