/* A model that is written as a page of equations: the classic SLIP, its gait, and a run from an apex. */
#include <stdio.h>
#include <string.h>
#include <tdmf_slip/page.h>

enum { ROOM = 64, TIMES = 3 };

/* The number of the parameter with a name. */
static int parameter_of(const tdmf_page *page, const char *name) {
    int number = 0;
    while (strcmp(tdmf_page_name(page, TDMF_PAGE_PARAMETER, number), name) != 0)
        ++number;
    return number;
}

int main(void) {
    static const double times[TIMES] = {0.0, 0.1, 0.2};
    const tdmf_page *page = tdmf_page_named("classic_slip");
    const int angle = parameter_of(page, "touchdown_angle");
    double parameters[ROOM], states[ROOM], scales[ROOM], least, most, end[ROOM], jacobian[ROOM * ROOM];
    double start[ROOM], rows[TIMES * ROOM], outputs[TIMES * ROOM];
    double point[] = {0.94}; /* height of the apex, m */
    tdmf_page_map map;
    tdmf_page_samples samples;
    int modes[TIMES], sampled;
    char text[128];

    tdmf_page_defaults(page, parameters, states);
    tdmf_page_range(page, angle, &least, &most);
    printf("library %s: ", tdmf_page_build());
    printf("touchdown_angle from %.4f to %.4f rad\n", least, most);
    parameters[parameter_of(page, "energy")] = 80.0 * 9.81 * 0.94 + 0.5 * 80.0 * 25.0;
    tdmf_page_scales(page, parameters, scales);

    memset(&map, 0, sizeof map); /* its first section is the apex at a given energy */
    map.page = page;
    map.parameters = parameters;
    map.states = states;
    map.tolerance = 1e-12;
    map.longest = 1e3;
    parameters[angle] = 2.0; /* too much */
    const tdmf_refusal refusal = tdmf_page_check(&map, point);
    printf("%s\n", tdmf_refusal_text(&refusal, text, sizeof text));
    parameters[angle] = 0.384;
    if (!tdmf_page_fixed_point(&map, point))
        return 1;
    const tdmf_page_end stride = tdmf_page_stride(&map, point, end, jacobian);
    printf("a gait at height %.6f, period %.6f s, %d events\n", point[0], stride.time, stride.event_count);

    tdmf_page_place(&map, point, start); /* the states with which the stride begins */
    memset(&samples, 0, sizeof samples);
    samples.count = TIMES;
    samples.times = times;
    samples.point = point;
    samples.states = rows;
    samples.outputs = outputs;
    samples.modes = modes;
    tdmf_page_begin(&map, end, &samples, &sampled);
    printf("after %.1f s in mode %s\n", times[sampled - 1],
           tdmf_page_name(page, TDMF_PAGE_MODE, modes[sampled - 1]));
    return 0;
}
