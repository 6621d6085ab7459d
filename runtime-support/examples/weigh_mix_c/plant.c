#include "plant.h"
#include <stdio.h>

/* What the valves let through, in grams. */
#define FLOW_A 2000u
#define FLOW_B 1000u
#define FLOW_C 2500u

/* The marks of the weighing unit, in grams. */
#define MARK_A 60000u
#define MARK_AB 100000u

/* After so many instants the belt has brought the next brick to its end, and for so many the detector sees it fall. */
#define BRICK_DISTANCE 20u
#define BRICK_FALLS 2u

/* So many instants the mixer takes to tip, and to come back. */
#define TIPPING 30u

void plant_init(Plant *plant)
{
    static const Plant empty;

    *plant = empty;
    Weigh_mix_init_inputs(&plant->panel);
}

uint32_t plant_weight(const Plant *plant)
{
    return plant->weighed[0] + plant->weighed[1];
}

Weigh_mix_inputs plant_inputs(const Plant *plant)
{
    Weigh_mix_inputs inputs = plant->panel;
    const uint32_t total = plant_weight(plant);

    inputs.TD = plant->falling > 0u;
    inputs.a = total >= MARK_A;
    inputs.b = total >= MARK_AB;
    inputs.z = total == 0u;
    inputs.S0 = plant->tipped == 0u;
    inputs.S1 = plant->tipped == TIPPING;
    return inputs;
}

static void empty_weighing_unit(Plant *plant)
{
    uint32_t left = FLOW_C;
    int product;

    for (product = 0; product < 2; product++) {
        const uint32_t flows = left < plant->weighed[product] ? left : plant->weighed[product];

        plant->weighed[product] -= flows;
        left -= flows;
        plant->powder += flows;
    }
}

static void move_belt(Plant *plant, double seconds)
{
    plant->belt++;
    if (plant->belt == BRICK_DISTANCE) {
        plant->belt = 0u;
        plant->falling = BRICK_FALLS;
        plant->bricks++;
        printf("%8.1f  a brick falls into the mixer\n", seconds);
    }
}

static void tip(Plant *plant, double seconds)
{
    if (plant->tipped < TIPPING) {
        plant->tipped++;
    }
    if (plant->tipped == TIPPING && plant->powder > 0u) {
        printf("%8.1f  %u kg and %u bricks leave the mixer\n", seconds, (unsigned)(plant->powder / 1000u),
               (unsigned)plant->bricks);
        plant->powder = 0u;
        plant->bricks = 0u;
    }
}

void plant_pass(Plant *plant, const Weigh_mix_outputs *outputs, double seconds)
{
    if (outputs->VA) {
        plant->weighed[0] += FLOW_A;
    }
    if (outputs->VB) {
        plant->weighed[1] += FLOW_B;
    }
    if (outputs->VC) {
        empty_weighing_unit(plant);
    }
    if (plant->falling > 0u) {
        plant->falling--;
    }
    if (outputs->BM) {
        move_belt(plant, seconds);
    }
    if (outputs->TM_down) {
        tip(plant, seconds);
    }
    if (outputs->TM_up && plant->tipped > 0u) {
        plant->tipped--;
    }
}
