/* Messages to the importer. */
#include "instance.h"

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

/* The categories of that name; 0 if there are none. */
static unsigned category_named(const char *name) {
    for (size_t i = 0; i < sizeof categories / sizeof categories[0]; ++i) {
        if (strcmp(categories[i].name, name) == 0) {
            return categories[i].category;
        }
    }
    return 0;
}

static void send(const instance *instance, call_status status, log_category category, const char *text) {
    if ((instance->log_categories & category) != 0) {
        instance->send(instance, status, name_of(category), text);
    }
}

void log_message(const instance *instance, call_status status, log_category category, const char *format,
                 ...) {
    char text[MESSAGE_CAPACITY];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    send(instance, status, category, text);
}

static void complain(const instance *instance, call_status status, log_category category, const char *call,
                     const char *format, va_list arguments) {
    char text[MESSAGE_CAPACITY];
    const int start = snprintf(text, sizeof text, "%s: ", call);
    if (start > 0 && (size_t)start < sizeof text) {
        vsnprintf(text + start, sizeof text - (size_t)start, format, arguments);
    }
    send(instance, status, category, text);
}

call_status fail(instance *instance, const char *call, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    complain(instance, CALL_ERROR, LOG_STATUS_ERROR, call, format, arguments);
    va_end(arguments);
    instance->state = FAILED;
    return CALL_ERROR;
}

call_status refuse(const instance *instance, const char *call, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    complain(instance, CALL_ERROR, LOG_STATUS_ERROR, call, format, arguments);
    va_end(arguments);
    return CALL_ERROR;
}

call_status discard(const instance *instance, const char *call, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    complain(instance, CALL_DISCARD, LOG_STATUS_DISCARD, call, format, arguments);
    va_end(arguments);
    return CALL_DISCARD;
}

/* The categories of these names, unknown names left out; the last of those is left in `unknown`. */
static unsigned categories_named(size_t count, const char *const names[], const char **unknown) {
    unsigned found = 0;
    for (size_t i = 0; i < count; ++i) {
        const char *name = names[i] == NULL ? "(null)" : names[i];
        const unsigned category = category_named(name);
        if (category == 0) {
            *unknown = name;
        }
        found |= category;
    }
    return found;
}

call_status set_logging(instance *instance, const char *call, bool on, size_t count,
                        const char *const names[]) {
    const char *unknown = NULL;
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, names, count, count)) {
        return CALL_ERROR;
    }
    const unsigned named = count == 0 ? (unsigned)LOG_ALL : categories_named(count, names, &unknown);
    const unsigned present = on && !instance->log_was_chosen ? 0 : instance->log_categories;
    if (unknown != NULL) {
        log_message(instance, CALL_WARNING, LOG_STATUS_WARNING, "%s: there is no log category %s", call,
                    unknown);
    }
    if (named != 0) {
        instance->log_categories = on ? present | named : present & ~named;
        instance->log_was_chosen = true;
    }
    return unknown != NULL ? CALL_WARNING : CALL_OK;
}

/* ---- events ------------------------------------------------------------------------------------------- */

char *time_text(double time, char text[TIME_CAPACITY]) {
    snprintf(text, TIME_CAPACITY, "%.15g", time);
    char *comma = strchr(text, ','); /* of the locale */
    if (comma != NULL) {
        *comma = '.';
    }
    return text;
}

static void log_event(void *subject, const char *text) {
    log_message(subject, CALL_OK, LOG_EVENTS, "%s", text);
}

fmu_observer event_logger(instance *instance) {
    const bool on = (instance->log_categories & LOG_EVENTS) != 0;
    const fmu_observer observer = {on ? log_event : NULL, instance};
    return observer;
}
