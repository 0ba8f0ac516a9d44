#include "fmu_library.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

void fail(const char *what, const char *which) {
    fprintf(stderr, "%s: %s\n", what, which);
    exit(EXIT_FAILURE);
}

/* ---- the shared library ------------------------------------------------------------------------------- */

/* Writes the address of a function; bytes are copied, as C has no cast from an object's address. */
#ifdef _WIN32
static void find(void *library, const char *name, void *function, size_t size) {
    const FARPROC found = GetProcAddress((HMODULE)library, name);
    if (found == NULL) {
        fail("the unit has no function", name);
    }
    memcpy(function, &found, size);
}

static void *open_library(const char *path) {
    return (void *)LoadLibraryA(path);
}
#else
static void find(void *library, const char *name, void *function, size_t size) {
    void *const found = dlsym(library, name);
    if (found == NULL) {
        fail("the unit has no function", name);
    }
    memcpy(function, &found, size);
}

static void *open_library(const char *path) {
    return dlopen(path, RTLD_NOW | RTLD_LOCAL);
}
#endif

fmu_functions load_fmu(const char *path) {
    fmu_functions unit;
    const struct {
        const char *name;
        void *function;
    } wanted[] = {{"fmi2Instantiate", &unit.instantiate},
                  {"fmi2FreeInstance", &unit.free_instance},
                  {"fmi2SetupExperiment", &unit.setup_experiment},
                  {"fmi2EnterInitializationMode", &unit.enter_initialization_mode},
                  {"fmi2ExitInitializationMode", &unit.exit_initialization_mode},
                  {"fmi2GetReal", &unit.get_real},
                  {"fmi2SetReal", &unit.set_real},
                  {"fmi2GetInteger", &unit.get_integer},
                  {"fmi2EnterEventMode", &unit.enter_event_mode},
                  {"fmi2NewDiscreteStates", &unit.new_discrete_states},
                  {"fmi2EnterContinuousTimeMode", &unit.enter_continuous_time_mode},
                  {"fmi2CompletedIntegratorStep", &unit.completed_integrator_step},
                  {"fmi2SetTime", &unit.set_time},
                  {"fmi2GetContinuousStates", &unit.get_states},
                  {"fmi2SetContinuousStates", &unit.set_states},
                  {"fmi2GetDerivatives", &unit.get_derivatives},
                  {"fmi2GetEventIndicators", &unit.get_indicators}};
    void *const library = open_library(path);
    if (library == NULL) {
        fail("not a shared library", path);
    }
    for (size_t i = 0; i < sizeof wanted / sizeof wanted[0]; ++i) {
        find(library, wanted[i].name, wanted[i].function, sizeof unit.instantiate);
    }
    return unit;
}

/* ---- the description ---------------------------------------------------------------------------------- */

fmu_description read_description(const char *path) {
    FILE *const file = fopen(path, "rb");
    if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
        fail("cannot be read", path);
    }
    const long size = ftell(file);
    rewind(file);
    char *const text = size < 0 ? NULL : malloc((size_t)size + 1);
    if (text == NULL || fread(text, 1, (size_t)size, file) != (size_t)size) {
        fail("cannot be read", path);
    }
    text[size] = '\0';
    fclose(file);
    return (fmu_description){text};
}

void free_description(fmu_description *description) {
    free(description->text);
    description->text = NULL;
}

/* The text after the first ` name="quoted`, or NULL. */
static const char *value_after(const char *text, const char *name, const char *quoted) {
    char wanted[256];
    snprintf(wanted, sizeof wanted, " %s=\"%s", name, quoted);
    const char *const found = strstr(text, wanted);
    return found == NULL ? NULL : found + strlen(wanted);
}

fmi2ValueReference reference_of(const fmu_description *description, const char *variable) {
    char name[128];
    snprintf(name, sizeof name, "%s\"", variable);
    const char *const begin = value_after(description->text, "name", name);
    const char *const reference = begin == NULL ? NULL : value_after(begin, "valueReference", "");
    if (reference == NULL) {
        fail("the unit has no variable", variable);
    }
    return (fmi2ValueReference)strtoul(reference, NULL, 10);
}

void attribute_of(const fmu_description *description, const char *name, char *value, size_t size) {
    const char *const begin = value_after(description->text, name, "");
    if (begin == NULL || strcspn(begin, "\"") >= size) {
        fail("modelDescription.xml does not say", name);
    }
    const size_t length = strcspn(begin, "\"");
    memcpy(value, begin, length);
    value[length] = '\0';
}

size_t count_states(const fmu_description *description) {
    const char *at = strstr(description->text, "<Derivatives>");
    const char *const end = at == NULL ? NULL : strstr(at, "</Derivatives>");
    if (end == NULL) {
        fail("modelDescription.xml does not say", "Derivatives");
    }
    size_t count = 0;
    while ((at = strstr(at, "<Unknown")) != NULL && at < end) {
        ++count;
        ++at;
    }
    return count;
}
