/* SPDX-License-Identifier: MIT */
/* Independent pieces of work on several threads. */
#include "base/parallel.h"

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

enum { THREADS_MOST = 64 };

struct crew {
    void (*work)(void *context, unsigned i);
    void *context;
    const volatile sig_atomic_t *stop;
    pthread_mutex_t mutex; /* guards next */
    unsigned next, last;
};

static bool take(struct crew *crew, unsigned *i) {
    (void)pthread_mutex_lock(&crew->mutex);
    bool has_one = crew->next < crew->last && (crew->stop == NULL || *crew->stop == 0);
    *i = crew->next;
    crew->next += has_one;
    (void)pthread_mutex_unlock(&crew->mutex);
    return has_one;
}

static void *labour(void *context) {
    struct crew *crew = context;
    unsigned i;
    while (take(crew, &i)) {
        crew->work(crew->context, i);
    }
    return NULL;
}

void parallel_for(unsigned first, unsigned last, unsigned jobs,
                  void (*work)(void *context, unsigned i), void *context,
                  const volatile sig_atomic_t *stop) {
    struct crew crew = {
        .work = work, .context = context, .stop = stop, .next = first, .last = last};
    pthread_t threads[THREADS_MOST];
    unsigned started = 0;
    sigset_t all, before;
    (void)pthread_mutex_init(&crew.mutex, NULL);
    /* Signals are for the caller's thread: it is the one that notes them. */
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_SETMASK, &all, &before);
    while (started + 1 < jobs && started < THREADS_MOST &&
           pthread_create(&threads[started], NULL, labour, &crew) == 0) {
        started++;
    }
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    (void)labour(&crew);
    while (started > 0) {
        (void)pthread_join(threads[--started], NULL);
    }
    (void)pthread_mutex_destroy(&crew.mutex);
}
