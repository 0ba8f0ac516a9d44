/* The derivative of a run by the damping of the leg, beside a difference quotient. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tdmf_slip/page.h>

enum { ROOM = 128 }; /* more than a model has parameters, states or outputs */

static const double end = 14.0; /* s, in the first stance */

static int number_of(const tdmf_page *page, tdmf_page_item kind, const char *name) {
    int number = 0;
    while (strcmp(tdmf_page_name(page, kind, number), name) != 0)
        ++number;
    return number;
}

/* The height of the centre of mass at the end, and its derivative by the damping. */
static double height_at_end(double damping, double *by_damping) {
    const tdmf_page *page = tdmf_page_named("runner");
    const int parameter = number_of(page, TDMF_PAGE_PARAMETER, "damping");
    const int height = number_of(page, TDMF_PAGE_OUTPUT, "center_y");
    double parameters[ROOM], states[ROOM], d_parameters[ROOM] = {0.0}, last[ROOM];
    double row[ROOM], outputs[ROOM], d_row[ROOM], d_outputs[ROOM];
    int mode, sampled;
    tdmf_page_map map;
    tdmf_page_samples samples;

    tdmf_page_defaults(page, parameters, states); /* an apex of the default gait */
    parameters[parameter] = damping;
    d_parameters[parameter] = 1.0;
    memset(&map, 0, sizeof map);
    map.page = page;
    map.parameters = parameters;
    map.states = states;
    map.tolerance = 1e-11;
    map.longest = end;
    map.seed_count = 1;
    map.d_parameters = d_parameters;
    memset(&samples, 0, sizeof samples);
    samples.count = 1;
    samples.times = &end;
    samples.states = row;
    samples.outputs = outputs;
    samples.d_states = d_row;
    samples.d_outputs = d_outputs;
    samples.modes = &mode;
    tdmf_page_begin(&map, last, &samples, &sampled);
    if (sampled < samples.count)
        exit(EXIT_FAILURE); /* the run is refused, or cannot be followed */
    *by_damping = d_outputs[height];
    return outputs[height];
}

int main(void) {
    const double step = 1e-5;
    double exact, unused;
    height_at_end(0.1, &exact);
    const double above = height_at_end(0.1 + step, &unused), below = height_at_end(0.1 - step, &unused);
    printf("d com.y / d leg.damping = %.5f, by differences %.5f\n", exact, (above - below) / (2.0 * step));
    return 0;
}
