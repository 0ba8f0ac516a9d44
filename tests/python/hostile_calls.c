/* Random calls of FMI 2.0, with any values and in any order, on a unit whose names have the prefix Hopper_:
 * none may crash, hang or give a number that is no number. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi2FunctionTypes.h"

fmi2InstantiateTYPE Hopper_fmi2Instantiate;
fmi2FreeInstanceTYPE Hopper_fmi2FreeInstance;
fmi2ResetTYPE Hopper_fmi2Reset;
fmi2SetupExperimentTYPE Hopper_fmi2SetupExperiment;
fmi2EnterInitializationModeTYPE Hopper_fmi2EnterInitializationMode;
fmi2ExitInitializationModeTYPE Hopper_fmi2ExitInitializationMode;
fmi2EnterEventModeTYPE Hopper_fmi2EnterEventMode;
fmi2NewDiscreteStatesTYPE Hopper_fmi2NewDiscreteStates;
fmi2EnterContinuousTimeModeTYPE Hopper_fmi2EnterContinuousTimeMode;
fmi2CompletedIntegratorStepTYPE Hopper_fmi2CompletedIntegratorStep;
fmi2SetTimeTYPE Hopper_fmi2SetTime;
fmi2SetContinuousStatesTYPE Hopper_fmi2SetContinuousStates;
fmi2GetContinuousStatesTYPE Hopper_fmi2GetContinuousStates;
fmi2GetDerivativesTYPE Hopper_fmi2GetDerivatives;
fmi2GetEventIndicatorsTYPE Hopper_fmi2GetEventIndicators;
fmi2SetRealTYPE Hopper_fmi2SetReal;
fmi2GetRealTYPE Hopper_fmi2GetReal;
fmi2GetStringTYPE Hopper_fmi2GetString;
fmi2GetDirectionalDerivativeTYPE Hopper_fmi2GetDirectionalDerivative;
fmi2SetRealInputDerivativesTYPE Hopper_fmi2SetRealInputDerivatives;
fmi2DoStepTYPE Hopper_fmi2DoStep;
fmi2GetFMUstateTYPE Hopper_fmi2GetFMUstate;
fmi2SetFMUstateTYPE Hopper_fmi2SetFMUstate;
fmi2FreeFMUstateTYPE Hopper_fmi2FreeFMUstate;
fmi2SerializedFMUstateSizeTYPE Hopper_fmi2SerializedFMUstateSize;
fmi2SerializeFMUstateTYPE Hopper_fmi2SerializeFMUstate;
fmi2DeSerializeFMUstateTYPE Hopper_fmi2DeSerializeFMUstate;

enum { VARIABLES = 60, CALLS = 300, KINDS = 20, MOST_STATES = 16 };

static double any_value(void) {
    static const double odd[] = {0.0, -0.0, 1.0, -1.0, 1e-300, 1e300, 1e12, NAN, INFINITY, -INFINITY};
    const int i = rand() % 40;
    return i < 10 ? odd[i] : 4.0 * rand() / RAND_MAX - 1.5;
}

static void check(fmi2Status status, const double *values, int count, const char *call) {
    for (int i = 0; i < count && status == fmi2OK; ++i) {
        if (isnan(values[i])) {
            printf("%s gives NaN\n", call);
            exit(1);
        }
    }
}

static void serialize(fmi2Component c, fmi2FMUstate *state, bool forges) {
    size_t size = 0;
    if (Hopper_fmi2SerializedFMUstateSize(c, *state, &size) == fmi2OK && *state != NULL) {
        char *bytes = malloc(size);
        if (Hopper_fmi2SerializeFMUstate(c, *state, bytes, size) == fmi2OK) {
            bytes[(size_t)rand() % size] ^= forges ? 4 : 0;
            Hopper_fmi2DeSerializeFMUstate(c, bytes, size, state);
        }
        free(bytes);
    }
}

static void call(fmi2Component c, fmi2FMUstate *state, int states, int guards, double *time) {
    const fmi2ValueReference one = (fmi2ValueReference)(rand() % VARIABLES),
                             other = (fmi2ValueReference)(rand() % VARIABLES);
    const fmi2Integer order = rand() % 8 == 0 ? 2 : 1;
    const double value = any_value(), step = fabs(any_value());
    double values[2 * MOST_STATES] = {0.0};
    fmi2EventInfo info;
    fmi2Boolean event, ends;
    fmi2String text = "";
    switch (rand() % KINDS) {
    case 0:
        Hopper_fmi2EnterEventMode(c);
        break;
    case 1:
        Hopper_fmi2NewDiscreteStates(c, &info);
        break;
    case 2:
        Hopper_fmi2EnterContinuousTimeMode(c);
        break;
    case 3:
        Hopper_fmi2CompletedIntegratorStep(c, fmi2True, &event, &ends);
        break;
    case 4:
        Hopper_fmi2SetTime(c, value);
        break;
    case 5:
        Hopper_fmi2GetContinuousStates(c, values, (size_t)states);
        values[rand() % states] = value;
        Hopper_fmi2SetContinuousStates(c, values, (size_t)states);
        break;
    case 6:
        check(Hopper_fmi2GetDerivatives(c, values, (size_t)states), values, states, "GetDerivatives");
        break;
    case 7:
        check(Hopper_fmi2GetEventIndicators(c, values, (size_t)guards), values, guards, "GetEventIndicators");
        break;
    case 8:
    case 9:
        Hopper_fmi2SetReal(c, &one, 1, &value);
        break;
    case 10:
        check(Hopper_fmi2GetReal(c, &one, 1, values), values, 1, "GetReal");
        break;
    case 11:
        Hopper_fmi2GetString(c, &one, 1, &text);
        break;
    case 12:
        Hopper_fmi2GetDirectionalDerivative(c, &one, 1, &other, 1, &value, values);
        break;
    case 13:
        Hopper_fmi2SetRealInputDerivatives(c, &one, 1, &order, &value);
        break;
    case 14:
        Hopper_fmi2GetFMUstate(c, state);
        break;
    case 15:
        Hopper_fmi2SetFMUstate(c, *state);
        break;
    case 16:
        serialize(c, state, rand() % 2 == 0);
        break;
    case 17:
        if (rand() % 20 == 0) {
            Hopper_fmi2Reset(c);
            *time = 0.0;
        }
        break;
    default:
        if (Hopper_fmi2DoStep(c, *time, fmin(step, 3.0), fmi2True) == fmi2OK) {
            *time += fmin(step, 3.0);
        }
    }
}

int main(int count, char **given) {
    const int states = atoi(given[2]), guards = atoi(given[3]), runs = atoi(given[4]);
    for (int run = 0; count == 5 && run < runs; ++run) {
        double time = 0.0;
        fmi2FMUstate state = NULL;
        srand((unsigned)run);
        const fmi2Type type = run % 2 == 0 ? fmi2ModelExchange : fmi2CoSimulation;
        const fmi2Component c =
            Hopper_fmi2Instantiate("run", type, given[1], NULL, NULL, fmi2False, fmi2False);
        for (int i = 0; i < rand() % 4; ++i) {
            const fmi2ValueReference one = (fmi2ValueReference)(rand() % VARIABLES);
            const double value = any_value();
            Hopper_fmi2SetReal(c, &one, 1, &value);
        }
        Hopper_fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0);
        Hopper_fmi2EnterInitializationMode(c);
        Hopper_fmi2ExitInitializationMode(c);
        for (int i = 0; i < CALLS; ++i) {
            call(c, &state, states, guards, &time);
        }
        Hopper_fmi2FreeFMUstate(c, &state);
        Hopper_fmi2FreeInstance(c);
    }
    puts("survived");
    return 0;
}
