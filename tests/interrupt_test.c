/* SPDX-License-Identifier: MIT */
/* Interruptions, each in a process of its own: noted once, obeyed at once when repeated later. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "interrupt.h"
#include "stopwatch.h"

enum { LATER_US = 400000 };
static const double at_once_seconds = 0.2;

struct interruption {
    const char *what;
    int signals[3];      /* 0: no more */
    unsigned pause_us;   /* before each but the first */
    int noted, ended_by; /* the exit status where nothing ended it; the signal that did, or 0 */
};

static const struct interruption interruptions[] = {
    {"none", {0}, 0, 0, 0},
    {"one", {SIGINT}, 0, SIGINT, 0},
    {"the other", {SIGTERM}, 0, SIGTERM, 0},
    {"twice at once", {SIGINT, SIGINT}, 0, SIGINT, 0},
    {"thrice at once", {SIGTERM, SIGTERM, SIGTERM}, 0, SIGTERM, 0},
    {"both at once: the first counts", {SIGTERM, SIGINT}, 0, SIGTERM, 0},
    {"again later", {SIGINT, SIGINT}, LATER_US, 0, SIGINT},
    {"the other later", {SIGINT, SIGTERM}, LATER_US, 0, SIGTERM},
};

static void wait_us(unsigned us) {
    struct timespec began = stopwatch_start();
    while (stopwatch_seconds(&began) < us * 1e-6) {
    }
}

/* What became of a process that was interrupted so: as waitpid says it. */
static int interrupted_once(const struct interruption *how, void (*prepare)(void)) {
    int status = 0;
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        prepare();
        interrupt_catch();
        for (int i = 0; i < 3 && how->signals[i] != 0; i++) {
            wait_us(i > 0 ? how->pause_us : 0);
            (void)raise(how->signals[i]);
        }
        _exit(*interrupt_noted());
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return status;
}

/* Again where a busy machine took so long that "at once" may not have been. */
static int interrupted(const struct interruption *how, void (*prepare)(void)) {
    for (int attempt = 0; attempt < 20; attempt++) {
        struct timespec began = stopwatch_start();
        int status = interrupted_once(how, prepare);
        if (how->pause_us > 0 || stopwatch_seconds(&began) < at_once_seconds) {
            return status;
        }
    }
    fail_msg("%s: twenty times too slow to tell", how->what);
    return -1;
}

static void as_it_is(void) {}

static void ignore_interrupts(void) {
    (void)signal(SIGINT, SIG_IGN);
}

static void a_repeat_counts_only_later(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof interruptions / sizeof *interruptions; i++) {
        const struct interruption *how = &interruptions[i];
        int status = interrupted(how, as_it_is);
        int ended_by = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        if (ended_by != how->ended_by || (ended_by == 0 && WEXITSTATUS(status) != how->noted)) {
            fail_msg("%s: ended by %d, noted %d", how->what, ended_by, WEXITSTATUS(status));
        }
    }
}

static void what_the_caller_ignores_stays_ignored(void **state) {
    (void)state;
    const struct interruption ignored = {"ignored", {SIGINT, SIGINT}, LATER_US, 0, 0};
    const struct interruption other = {"the other", {SIGINT, SIGTERM}, 0, SIGTERM, 0};
    assert_int_equal(interrupted(&ignored, ignore_interrupts), 0);
    int status = interrupted(&other, ignore_interrupts);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), SIGTERM);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_repeat_counts_only_later),
        cmocka_unit_test(what_the_caller_ignores_stays_ignored),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
