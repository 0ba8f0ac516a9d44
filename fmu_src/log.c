/* Messages to the importer. */
#include "instance.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MESSAGE_CAPACITY = 512 };

/* The category of each status, then that of all. */
static const char *const categories[] = {"logEvents", "logStatusWarning", "logStatusDiscard",
                                         "logStatusError", "logAll"};

call_status answer(const instance *instance, call_status status, const char *call, const char *format, ...) {
    char text[MESSAGE_CAPACITY];
    const int start = snprintf(text, sizeof text, "%s: ", call);
    va_list arguments;
    va_start(arguments, format);
    if (start > 0 && (size_t)start < sizeof text) {
        vsnprintf(text + start, sizeof text - (size_t)start, format, arguments);
    }
    va_end(arguments);
    if ((instance->log_categories >> status & 1) != 0) {
        instance->send(instance, status, categories[status], text);
    }
    return status;
}

void log_event(const instance *observer, const char *text) {
    observer->send(observer, CALL_OK, categories[CALL_OK], text);
}

const instance *observer_of(const instance *instance) {
    return (instance->log_categories & LOG_EVENTS) != 0 ? instance : NULL;
}

/* The set of categories with this name; 0 if the name is unknown. */
static unsigned category_named(const char *name) {
    for (unsigned i = 0; i <= CALL_ERROR; ++i) {
        if (strcmp(categories[i], name) == 0) {
            return 1u << i;
        }
    }
    return strcmp(categories[CALL_ERROR + 1], name) == 0 ? LOG_ALL : 0;
}

call_status set_logging(instance *instance, const char *call, bool on, size_t count,
                        const char *const names[]) {
    const char *unknown = NULL;
    unsigned named = count == 0 ? (unsigned)LOG_ALL : 0;
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, names, count, count)) {
        return CALL_ERROR;
    }
    for (size_t i = 0; i < count; ++i) {
        const char *name = names[i] == NULL ? "(null)" : names[i];
        unknown = category_named(name) == 0 ? name : unknown;
        named |= category_named(name);
    }
    const unsigned present = on && !instance->log_was_chosen ? 0 : instance->log_categories;
    const call_status status =
        unknown == NULL ? CALL_OK
                        : answer(instance, CALL_WARNING, call, "there is no log category %s", unknown);
    if (named != 0) {
        instance->log_categories = on ? present | named : present & ~named;
        instance->log_was_chosen = true;
    }
    return status;
}

char *number_text(double number, char text[NUMBER_CAPACITY]) {
    snprintf(text, NUMBER_CAPACITY, "%.15g", number);
    char *comma = strchr(text, ','); /* decimal point of the locale */
    if (comma != NULL) {
        *comma = '.';
    }
    return text;
}
