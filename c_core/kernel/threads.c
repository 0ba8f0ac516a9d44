/* POSIX threads, or those of Windows. */
#include "threads.h"

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

int64_t tdmf_take_number(int64_t *counter) {
    return InterlockedExchangeAdd64(counter, 1);
}

bool tdmf_is_raised(const int *flag) {
    return flag != NULL && *(const volatile int *)flag != 0;
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

int64_t tdmf_take_number(int64_t *counter) {
    return __atomic_fetch_add(counter, 1, __ATOMIC_RELAXED);
}

bool tdmf_is_raised(const int *flag) {
    return flag != NULL && __atomic_load_n(flag, __ATOMIC_RELAXED) != 0;
}
#endif

typedef struct {
    job job;
    thread thread;
} worker;

void tdmf_run_in_threads(tdmf_work *work, void *shared, int count) {
    worker *workers = count > 1 ? calloc((size_t)count, sizeof *workers) : NULL;
    int started = 1;
    for (bool goes_on = workers != NULL; goes_on && started < count; started += goes_on) {
        const job job = {work, shared, started};
        workers[started].job = job;
        goes_on = start(&workers[started].thread, &workers[started].job);
    }
    work(shared, 0);
    for (int i = 1; i < started; ++i) {
        join(workers[i].thread);
    }
    free(workers);
}
