/* Loading a unit's library, on Windows and elsewhere. */
#include "fmu_calls.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

static void *library;

void check(bool went_well, const char *call) {
    if (!went_well) {
        fprintf(stderr, "importer: %s failed\n", call);
        exit(EXIT_FAILURE);
    }
}

void load_library(const char *path) {
#ifdef _WIN32
    library = (void *)LoadLibraryA(path);
#else
    library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) {
        fprintf(stderr, "importer: %s\n", dlerror());
    }
#endif
    check(library != NULL, "loading the library");
}

any_function find_function(const char *name) {
    any_function function;
#ifdef _WIN32
    function = (any_function)(void (*)(void))GetProcAddress((HMODULE)library, name);
#else
    /* ISO C knows no conversion of an object's address into a function's. */
    void *address = dlsym(library, name);
    memcpy(&function, &address, sizeof function);
#endif
    check(function != NULL, name);
    return function;
}
