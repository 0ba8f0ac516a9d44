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

call_status discard(const instance *instance, const char *call, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    complain(instance, CALL_DISCARD, LOG_STATUS_DISCARD, call, format, arguments);
    va_end(arguments);
    return CALL_DISCARD;
}

call_status set_logging(instance *instance, const char *call, bool on, size_t count,
                        const char *const names[]) {
    if (!call_is_allowed(instance, call, ANYWHERE) || !array_is_given(instance, call, names, count, count)) {
        return CALL_ERROR;
    }
    unsigned chosen = count == 0 ? (unsigned)(on ? LOG_ALL : LOG_EVENTS) : 0;
    for (size_t i = 0; i < count; ++i) {
        const unsigned category = names[i] == NULL ? 0 : category_named(names[i]);
        if (category == 0) {
            return fail(instance, call, "there is no log category %s",
                        names[i] == NULL ? "(null)" : names[i]);
        }
        chosen |= category;
    }
    instance->log_categories = on ? chosen : instance->log_categories & ~chosen;
    return CALL_OK;
}

void log_changes(const instance *instance, const tdmf_mode *before) {
    const tdmf_mode *after = &instance->unit.motion.mode;
    if (before->contact != after->contact || before->phase != after->phase) {
        log_message(instance, CALL_OK, LOG_EVENTS, "%s, %s -> %s, %s (event %d, stride %d)",
                    unit_contact_mode_names[before->contact - 1], unit_hip_phase_names[before->phase - 1],
                    unit_contact_mode_names[after->contact - 1], unit_hip_phase_names[after->phase - 1],
                    instance->unit.motion.record.event_count, instance->unit.motion.record.stride.count);
    }
    if (!before->fallen && after->fallen) {
        log_message(instance, CALL_OK, LOG_EVENTS, "the runner has fallen");
    }
}
