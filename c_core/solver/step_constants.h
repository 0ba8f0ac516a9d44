/* What the kernel has to know of a mode, and coordinates to and from it. */
#ifndef TDMF_SOLVER_STEP_CONSTANTS_H
#define TDMF_SOLVER_STEP_CONSTANTS_H

#include "flight_step.h"
#include "ground_step.h"
#include "mode_equations.h"

/* The centre of mass in flight, at the equations' instant. */
ballistic tdmf_step_center_of_mass(const tdmf_mode_equations *equations);

/* The constants of a mode, with guards due `margin_factor` times as far below zero as at first. */
flight_constants tdmf_step_flight_constants(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                            double margin_factor);
ground_constants tdmf_step_ground_constants(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                            double margin_factor);

/* Gives the layer of a foot that slips, where friction falls with speed. */
friction_layer tdmf_step_friction_layer(const tdmf_mode_equations *equations);

flight_coordinates tdmf_step_flight_coordinates(const tdmf_mode_coordinates *at);
ground_coordinates tdmf_step_ground_coordinates(const tdmf_mode_coordinates *at);

/* What changes in a mode; the other coordinates stay. */
void tdmf_step_set_flight(tdmf_mode_coordinates *at, const flight_coordinates *flight);
void tdmf_step_set_ground(tdmf_mode_coordinates *at, const ground_coordinates *ground);

#endif
