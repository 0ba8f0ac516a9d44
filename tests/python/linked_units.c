/* Two units in one program, by FMI 2.0 and 3.0: a ball by one, a hopper by the other. */
#include <math.h>
#include <stdio.h>

#include "fmi2FunctionTypes.h"
#define FMI3_FUNCTION_PREFIX Hopper_
#include "fmi3Functions.h"

fmi2InstantiateTYPE Ball_fmi2Instantiate;
fmi2SetupExperimentTYPE Ball_fmi2SetupExperiment;
fmi2EnterInitializationModeTYPE Ball_fmi2EnterInitializationMode;
fmi2ExitInitializationModeTYPE Ball_fmi2ExitInitializationMode;
fmi2DoStepTYPE Ball_fmi2DoStep;
fmi2GetRealTYPE Ball_fmi2GetReal;
fmi2FreeInstanceTYPE Ball_fmi2FreeInstance;

enum { STEPS = 20 };

static double fallen_ball(const char *guid, fmi2ValueReference height) {
    const fmi2Component ball =
        Ball_fmi2Instantiate("ball", fmi2CoSimulation, guid, NULL, NULL, fmi2False, fmi2False);
    double value = NAN;
    Ball_fmi2SetupExperiment(ball, fmi2False, 0.0, 0.0, fmi2False, 0.0);
    Ball_fmi2EnterInitializationMode(ball);
    Ball_fmi2ExitInitializationMode(ball);
    for (int i = 0; i < STEPS; ++i) {
        Ball_fmi2DoStep(ball, i / 10.0, 0.1, fmi2True);
    }
    Ball_fmi2GetReal(ball, &height, 1, &value);
    Ball_fmi2FreeInstance(ball);
    return value;
}

static double hopped(const char *token, fmi3ValueReference height) {
    fmi3Boolean event, ends, early;
    double last, value = NAN;
    const fmi3Instance hopper = fmi3InstantiateCoSimulation("hopper", token, NULL, false, false, false, false,
                                                            NULL, 0, NULL, NULL, NULL);
    fmi3EnterInitializationMode(hopper, false, 0.0, 0.0, false, 0.0);
    fmi3ExitInitializationMode(hopper);
    for (int i = 0; i < STEPS; ++i) {
        fmi3DoStep(hopper, i / 10.0, 0.1, true, &event, &ends, &early, &last);
    }
    fmi3GetFloat64(hopper, &height, 1, &value, 1);
    fmi3FreeInstance(hopper);
    return value;
}

int main(int count, char **given) {
    unsigned heights[2];
    if (count == 5 && sscanf(given[2], "%u", &heights[0]) == 1 && sscanf(given[4], "%u", &heights[1]) == 1) {
        printf("%.17g %.17g\n", fallen_ball(given[1], heights[0]), hopped(given[3], heights[1]));
    }
    return 0;
}
