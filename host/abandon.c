/* SPDX-License-Identifier: MIT */
/* Computations that can be given up in their midst: each in a thread that may be cancelled
 * anywhere, while the caller's waits and looks at the flag. */
#include "abandon.h"

#include <pthread.h>
#include <stddef.h>
#include <time.h>

enum { LOOK_NS = 50000000, SECOND_NS = 1000000000 };

struct effort {
    void (*work)(void *context);
    void *context;
    pthread_mutex_t mutex; /* guards is_done */
    pthread_cond_t ended;
    bool is_done;
};

static void *labour(void *context) {
    struct effort *effort = context;
    int before;
    (void)pthread_setcanceltype(PTHREAD_CANCEL_ASYNCHRONOUS, &before);
    effort->work(effort->context);
    (void)pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before);
    (void)pthread_mutex_lock(&effort->mutex);
    effort->is_done = true;
    (void)pthread_cond_signal(&effort->ended);
    (void)pthread_mutex_unlock(&effort->mutex);
    return NULL;
}

/* Signals are for the thread that notes them, not for the new one. */
static bool start(pthread_t *thread, struct effort *effort) {
    sigset_t all, before;
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_SETMASK, &all, &before);
    bool is_started = pthread_create(thread, NULL, labour, effort) == 0;
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    return is_started;
}

/* A handler can't wake the caller: it looks now and then. */
static struct timespec next_look(void) {
    struct timespec at = {0, 0};
    (void)clock_gettime(CLOCK_REALTIME, &at);
    at.tv_nsec += LOOK_NS;
    at.tv_sec += at.tv_nsec / SECOND_NS;
    at.tv_nsec %= SECOND_NS;
    return at;
}

static void await(struct effort *effort, pthread_t thread, const volatile sig_atomic_t *stop) {
    (void)pthread_mutex_lock(&effort->mutex);
    while (!effort->is_done && *stop == 0) {
        const struct timespec at = next_look();
        (void)pthread_cond_timedwait(&effort->ended, &effort->mutex, &at);
    }
    bool is_done = effort->is_done;
    (void)pthread_mutex_unlock(&effort->mutex);
    if (!is_done) {
        (void)pthread_cancel(thread);
    }
    (void)pthread_join(thread, NULL);
}

bool do_until(const volatile sig_atomic_t *stop, void (*work)(void *context), void *context) {
    struct effort effort = {.work = work, .context = context};
    pthread_t thread;
    if (stop != NULL && *stop != 0) {
        return false;
    }
    (void)pthread_mutex_init(&effort.mutex, NULL);
    (void)pthread_cond_init(&effort.ended, NULL);
    if (stop != NULL && start(&thread, &effort)) {
        await(&effort, thread, stop);
    } else {
        work(context);
        effort.is_done = true;
    }
    (void)pthread_cond_destroy(&effort.ended);
    (void)pthread_mutex_destroy(&effort.mutex);
    return effort.is_done;
}
