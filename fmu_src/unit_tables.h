/* Tables of a page's unit, which the generator writes beside the tables of the page. */
#ifndef TDMF_FMU_UNIT_TABLES_H
#define TDMF_FMU_UNIT_TABLES_H

#include "page_part.h"
#include "variables.h"

/* A continuous state of the unit, among the states of the page. */
typedef struct {
    int index;
    bool has_start; /* else the start calculates it */
} unit_state;

/* An event indicator: the least guard of some events, or the rate of an observed largest value. */
typedef struct {
    uint64_t events; /* a bit for each event; 0 for an observed quantity */
    int into;        /* the state that the quantity goes into */
} unit_guard;

/* A word: digits of a number in the base of its alphabet, the first letter the most significant one. */
typedef struct {
    fmu_storage storage; /* of the number, which is stored as that of a variable */
    size_t offset;
    const char *alphabet;
} unit_word;

/* An enumeration that describes a mode in messages. */
typedef struct {
    int output;
    const char *const *names; /* names of the values 1, 2, ... */
} unit_enumeration;

/* A number that must not be negative at a start. */
typedef struct {
    bool of_parameters; /* true if only parameters decide it: it must stay non-negative in the run */
    int variable;       /* value reference of the variable that a refusal names */
    const char *allowed;
    int bound; /* value reference of the variable that `allowed` ends with, or -1 */
    tdmf_answer *margin;
} unit_requirement;

/* The typical size of a continuous state of the unit, where it is not that of its physical unit. */
typedef struct {
    int state;
    tdmf_answer *size;
} unit_nominal;

/* A number of a run. */
typedef struct {
    const char *name; /* name of its variable, else the page's own name */
    double least, most;
} unit_number;

/* Bounds that a state of the page always keeps. */
typedef struct {
    int state;
    double least, most;
    bool is_whole;
    bool moves; /* true if it changes between events, so that Model Exchange leaves it to the importer */
} unit_bound;

extern const tdmf_model_kind *const unit_model;
extern const tdmf_page_part *const unit_part; /* smaller page, run if it has everything that acts, or NULL */
extern const unit_state unit_states[];
extern const unit_guard unit_guards[];
extern const unit_word unit_words[];
extern const unit_requirement unit_requirements[];
extern const unit_enumeration unit_enumerations[];
extern const unit_number unit_numbers[];
extern const unit_bound unit_bounds[];
extern const unit_nominal unit_nominals[];
extern const char *const unit_event_names[]; /* for messages */
extern const uint64_t unit_immediate_events; /* events whose guards are always below zero */
extern const int unit_input_rates[];         /* for each state of the page, the state that ramps it, or -1 */
extern const int unit_clock;                 /* a state of the page, or -1 */
extern const bool unit_holds_time[];         /* for each state of the page; negative before there is a time */

#endif
