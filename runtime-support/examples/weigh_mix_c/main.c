/* A weighing-mixing plant (IEC 60848, annex B), simulated, and run by its chart: a minute of it at once.

   On a controller the loop runs for ever, `now` is its counter of milliseconds, and the inputs are read from pins. */

#include "plant.h"
#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* When the simulation ends, in milliseconds. */
#define END 62000u

/* An output: where it is, and what it means when it goes on and off. */
typedef struct {
    size_t place;
    const char *on;
    const char *off;
} Effect;

#define OUTPUT(name) offsetof(Weigh_mix_outputs, name)

static const Effect EFFECTS[] = {
    { OUTPUT(VA), "valve A opens", "valve A closes" },
    { OUTPUT(VB), "valve B opens", "valve B closes" },
    { OUTPUT(VC), "valve C opens", "valve C closes" },
    { OUTPUT(BM), "belt runs", "belt stops" },
    { OUTPUT(MR), "mixer turns", "mixer stops" },
    { OUTPUT(TM_down), "mixer tips", "tipping ends" },
    { OUTPUT(TM_up), "mixer comes up", "mixer is up" },
    { OUTPUT(EMC), "manual control on", "manual control off" },
};

#define EFFECT_COUNT (sizeof EFFECTS / sizeof EFFECTS[0])

/* What the operator does, and when: a batch, a second one that is stopped and cleared away, and a third. */
static const char *operate(Plant *plant, uint32_t now)
{
    Weigh_mix_inputs *panel = &plant->panel;

    switch (now) {
    case 0u:
        panel->PBES = true;
        panel->SSManu = true;
        return "finds the emergency stop pressed";
    case 1000u:
    case 33000u:
        panel->PBES = false;
        return "releases the emergency stop";
    case 2000u:
    case 35000u:
        panel->SSAuto = true;
        panel->SSManu = false;
        return "selects automatic";
    case 3000u:
    case 30000u:
    case 36000u:
        panel->CS = true;
        return "presses start";
    case 3500u:
    case 36500u:
        panel->CS = false;
        return "lets go of start";
    case 31500u:
        panel->PBES = true;
        panel->CS = false;
        return "presses the emergency stop";
    case 32000u:
        panel->SSAuto = false;
        panel->SSManu = true;
        return "selects manual";
    case 34000u:
        plant->weighed[0] = 0u;
        plant->weighed[1] = 0u;
        return "takes the powder out of the weighing unit";
    default:
        return NULL;
    }
}

static bool is_on(const Weigh_mix_outputs *outputs, size_t effect)
{
    return *(const bool *)((const char *)outputs + EFFECTS[effect].place);
}

/* The labels of the active steps. */
static void situation_of(const Weigh_mix *chart, char *text)
{
    uint32_t step;

    text[0] = '\0';
    for (step = 0u; step < WEIGH_MIX_STEP_COUNT; step++) {
        if (Weigh_mix_is_active(chart, (Weigh_mix_step)step)) {
            strcat(text, text[0] == '\0' ? "" : " ");
            strcat(text, Weigh_mix_step_label((Weigh_mix_step)step));
        }
    }
}

/* What changes in the plant: first what goes off. */
static void tell(const Weigh_mix_outputs *before, const Weigh_mix_outputs *outputs)
{
    const char *between = "  ";
    int on;
    size_t effect;

    for (on = 0; on < 2; on++) {
        for (effect = 0u; effect < EFFECT_COUNT; effect++) {
            if (is_on(before, effect) == (on == 0) && is_on(outputs, effect) == (on == 1)) {
                printf("%s%s", between, on == 1 ? EFFECTS[effect].on : EFFECTS[effect].off);
                between = ", ";
            }
        }
    }
    printf("\n");
}

int main(void)
{
    Weigh_mix chart;
    Weigh_mix_outputs before;
    Plant plant;
    char situation[64] = "";
    uint32_t now;

    Weigh_mix_init(&chart);
    plant_init(&plant);
    before = chart.outputs;
    printf("time (s)  steps   weight (kg)\n");
    for (now = 0u; now <= END; now += TICK) {
        const double seconds = (double)now / 1000.0;
        const char *deed = operate(&plant, now);
        Weigh_mix_inputs inputs;
        const Weigh_mix_outputs *outputs;
        char steps[64];

        if (deed != NULL) {
            printf("%8.1f  operator %s\n", seconds, deed);
        }

        /* The controller: inputs in, outputs out. */
        inputs = plant_inputs(&plant);
        outputs = Weigh_mix_scan(&chart, &inputs, now);

        situation_of(&chart, steps);
        if (strcmp(steps, situation) != 0 || memcmp(outputs, &before, sizeof before) != 0) {
            printf("%8.1f  %-8s%11.1f", seconds, steps, (double)plant_weight(&plant) / 1000.0);
            tell(&before, outputs);
            strcpy(situation, steps);
            before = *outputs;
        }
        plant_pass(&plant, outputs, seconds + (double)TICK / 1000.0);
    }
    return chart.flags.livelock || chart.flags.alloc_conflict || chart.flags.force_conflict || chart.flags.div0;
}
