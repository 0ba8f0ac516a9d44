/* POSIX threads, or those of Windows. */
#include "threads.h"

#include <stdbool.h>
#include <stdlib.h>

typedef struct {
    tdmf_work *work;
    void *shared;
    int number;
} job;

#ifdef _WIN32
#include <windows.h>

typedef HANDLE thread;

static DWORD WINAPI run(LPVOID argument) {
    const job *job = argument;
    job->work(job->shared, job->number);
    return 0;
}

static bool start(thread *thread, job *job) {
    *thread = CreateThread(NULL, 0, run, job, 0, NULL);
    return *thread != NULL;
}

static void join(thread thread) {
    WaitForSingleObject(thread, INFINITE);
    CloseHandle(thread);
}

long tdmf_take_number(long *counter) {
    return InterlockedExchangeAdd(counter, 1);
}
#else
#include <pthread.h>

typedef pthread_t thread;

static void *run(void *argument) {
    const job *job = argument;
    job->work(job->shared, job->number);
    return NULL;
}

static bool start(thread *thread, job *job) {
    return pthread_create(thread, NULL, run, job) == 0;
}

static void join(thread thread) {
    pthread_join(thread, NULL);
}

long tdmf_take_number(long *counter) {
    return __atomic_fetch_add(counter, 1, __ATOMIC_RELAXED);
}
#endif

typedef struct {
    job job;
    thread thread;
    bool started;
} place;

void tdmf_side_by_side(tdmf_work *work, void *shared, int count) {
    place *places = count > 1 ? calloc((size_t)count, sizeof *places) : NULL;
    for (int i = 1; places && i < count; ++i) {
        const job job = {work, shared, i};
        places[i].job = job;
        places[i].started = start(&places[i].thread, &places[i].job);
    }
    for (int i = 0; i < count; ++i) {
        if (!places || !places[i].started) {
            work(shared, i);
        }
    }
    for (int i = 1; places && i < count; ++i) {
        if (places[i].started) {
            join(places[i].thread);
        }
    }
    free(places);
}
