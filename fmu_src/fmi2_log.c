/* Messages to the importer. */
#include "fmi2_instance.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MESSAGE_CAPACITY = 512 };

static const struct {
    log_category category;
    const char *name;
} categories[] = {
    {LOG_EVENTS, "logEvents"},
    {LOG_STATUS_WARNING, "logStatusWarning"},
    {LOG_STATUS_DISCARD, "logStatusDiscard"},
    {LOG_STATUS_ERROR, "logStatusError"},
    {LOG_ALL, "logAll"},
};

static const char *name_of(log_category category) {
    size_t i = 0;
    while (categories[i].category != category) {
        ++i;
    }
    return categories[i].name;
}

unsigned log_category_named(const char *name) {
    for (size_t i = 0; i < sizeof categories / sizeof categories[0]; ++i) {
        if (strcmp(categories[i].name, name) == 0) {
            return categories[i].category;
        }
    }
    return 0;
}

static void send(const instance *instance, fmi2Status status, log_category category, const char *text) {
    if (instance->logger != NULL && (instance->log_categories & category) != 0) {
        instance->logger(instance->environment, instance->name, status, name_of(category), "%s", text);
    }
}

void log_message(const instance *instance, fmi2Status status, log_category category, const char *format,
                 ...) {
    char text[MESSAGE_CAPACITY];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    send(instance, status, category, text);
}

static void complain(const instance *instance, fmi2Status status, log_category category, const char *call,
                     const char *format, va_list arguments) {
    char text[MESSAGE_CAPACITY];
    const int start = snprintf(text, sizeof text, "%s: ", call);
    if (start > 0 && (size_t)start < sizeof text) {
        vsnprintf(text + start, sizeof text - (size_t)start, format, arguments);
    }
    send(instance, status, category, text);
}

fmi2Status fail(instance *instance, const char *call, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    complain(instance, fmi2Error, LOG_STATUS_ERROR, call, format, arguments);
    va_end(arguments);
    instance->state = FAILED;
    return fmi2Error;
}

fmi2Status discard(const instance *instance, const char *call, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    complain(instance, fmi2Discard, LOG_STATUS_DISCARD, call, format, arguments);
    va_end(arguments);
    return fmi2Discard;
}
