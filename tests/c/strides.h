/* Strides, gaits and settling by the arguments that tests give. */
#ifndef TDMF_TESTS_STRIDES_H
#define TDMF_TESTS_STRIDES_H

#include "tdmf_slip/return_map.h"

/* One stride by the return map, with what is measured or without, or by the reduced map. */
tdmf_return return_map(tdmf_solver *solver, tdmf_system system, const double *apex, double until,
                       bool derivatives, const tdmf_seed *seeds, int count);
tdmf_return measured_return_map(tdmf_solver *solver, tdmf_system system, const double *apex, double until,
                                bool derivatives, const tdmf_seed *seeds, int count);
tdmf_return reduced_map(tdmf_solver *solver, tdmf_system system, const double *apex, double until,
                        bool derivatives, const tdmf_seed *seeds, int count);

/* A gait near a guess, whose stride varies along `count` seeds. */
tdmf_orbit find_orbit(tdmf_apex_map map, tdmf_solver *solver, tdmf_system system, const double *guess,
                      const tdmf_seed *seeds, int count);

/* Moves an apex on by some strides; returns how many closed. */
int settle(tdmf_apex_map map, tdmf_solver *solver, tdmf_system system, int strides, double *apex);

#endif
