/* The plant, simulated: what valves and motors do to it, and what its sensors see.

   Two powders are weighed into one unit, A up to a first mark and B up to a second, and fall from there into the mixer. A
   belt brings bricks, which fall past a detector into the mixer too. The mixer turns, and tips to be emptied. */

#ifndef PLANT_H
#define PLANT_H

#include "weigh_mix.h"

/* How long an instant of the simulation is, in milliseconds. All rates are per instant. */
#define TICK 100u

typedef struct {
    Weigh_mix_inputs panel; /* buttons and the selector; the sensors are not read here */
    uint32_t weighed[2];    /* grams of A and of B in the weighing unit */
    uint32_t powder;        /* grams in the mixer */
    uint32_t bricks;        /* in the mixer */
    uint32_t belt;          /* how far it has run since the last brick fell */
    uint32_t falling;       /* for how many instants the detector will still see a brick */
    uint32_t tipped;        /* how far the mixer is */
} Plant;

void plant_init(Plant *plant);

/* What is in the weighing unit, in grams. */
uint32_t plant_weight(const Plant *plant);

/* What the controller sees: the panel and the sensors. */
Weigh_mix_inputs plant_inputs(const Plant *plant);

/* Lets one instant pass; `seconds` is its end, for what can be heard of it. */
void plant_pass(Plant *plant, const Weigh_mix_outputs *outputs, double seconds);

#endif
