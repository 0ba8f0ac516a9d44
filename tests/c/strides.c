#include "strides.h"

static tdmf_stride_request request_from(tdmf_apex_map map, tdmf_solver *solver, tdmf_system system,
                                        const double *apex) {
    const tdmf_stride_request request = {.solver = solver, .system = system, .map = map, .apex = apex};
    return request;
}

static tdmf_return run(tdmf_stride_request request, double until, bool derivatives, const tdmf_seed *seeds,
                       int count) {
    tdmf_return result;
    request.until = until;
    request.derivatives = derivatives;
    request.seeds = seeds;
    request.seed_count = count;
    tdmf_run_stride(&request, &result);
    return result;
}

tdmf_return return_map(tdmf_solver *solver, tdmf_system system, const double *apex, double until,
                       bool derivatives, const tdmf_seed *seeds, int count) {
    return run(request_from(TDMF_RETURN_MAP, solver, system, apex), until, derivatives, seeds, count);
}

tdmf_return measured_return_map(tdmf_solver *solver, tdmf_system system, const double *apex, double until,
                                bool derivatives, const tdmf_seed *seeds, int count) {
    tdmf_stride_request request = request_from(TDMF_RETURN_MAP, solver, system, apex);
    request.measures = true;
    return run(request, until, derivatives, seeds, count);
}

tdmf_return reduced_map(tdmf_solver *solver, tdmf_system system, const double *apex, double until,
                        bool derivatives, const tdmf_seed *seeds, int count) {
    return run(request_from(TDMF_REDUCED_MAP, solver, system, apex), until, derivatives, seeds, count);
}

tdmf_orbit find_orbit(tdmf_apex_map map, tdmf_solver *solver, tdmf_system system, const double *guess,
                      const tdmf_seed *seeds, int count) {
    tdmf_stride_request request = request_from(map, solver, system, guess);
    tdmf_orbit orbit;
    request.seeds = seeds;
    request.seed_count = count;
    tdmf_find_orbit(&request, &orbit);
    return orbit;
}

int settle(tdmf_apex_map map, tdmf_solver *solver, tdmf_system system, int strides, double *apex) {
    const tdmf_stride_request request = request_from(map, solver, system, apex);
    return tdmf_settle(&request, strides, apex);
}
