/* Instances share nothing writable: many in parallel threads give bit for bit what one after the other gives.
 */
#include "compare.h"
#include "fmi2_importer.h"

#include <pthread.h>

enum { INSTANCES = 64 };

typedef struct {
    fmi2Component component;
    double friction;
    double result[3];
    fmi2Status status;
} job;

static void *run(void *argument) {
    job *job = argument;
    const fmi2ValueReference references[] = {reference_of("foot.x"), reference_of("stride.period"),
                                             reference_of("hip.work")};
    for (int i = 0; i < 200 && job->status == fmi2OK; ++i) {
        job->status = fmi2DoStep(job->component, 0.5 * i, 0.5, fmi2True);
    }
    if (job->status == fmi2OK) {
        job->status = fmi2GetReal(job->component, references, 3, job->result);
    }
    return NULL;
}

static void prepare(job jobs[INSTANCES]) {
    for (int i = 0; i < INSTANCES; ++i) {
        jobs[i].component = new_slave();
        jobs[i].friction = 0.1 + 0.05 * i;
        jobs[i].status = fmi2OK;
        assert_int_equal(set_real(jobs[i].component, "ground.friction", jobs[i].friction), fmi2OK);
        initialize(jobs[i].component);
    }
}

TEST(threads_change_nothing) {
    static job serial[INSTANCES], parallel[INSTANCES];
    pthread_t threads[INSTANCES];
    prepare(serial);
    prepare(parallel);
    for (int i = 0; i < INSTANCES; ++i) {
        assert_int_equal(pthread_create(&threads[i], NULL, run, &parallel[i]), 0);
    }
    for (int i = 0; i < INSTANCES; ++i) {
        run(&serial[i]);
        assert_int_equal(pthread_join(threads[i], NULL), 0);
    }
    for (int i = 0; i < INSTANCES; ++i) {
        assert_int_equal(serial[i].status, fmi2OK);
        assert_int_equal(parallel[i].status, fmi2OK);
        assert_memory_equal(serial[i].result, parallel[i].result, sizeof serial[i].result);
    }
}
