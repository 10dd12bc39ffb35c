/* SPDX-License-Identifier: MIT */
/* Interruptions, each in a process of its own: noted once, obeyed at once when repeated later. */
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/interrupt.h"
#include "base/stopwatch.h"

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
    {"a terminal that is closed", {SIGHUP}, 0, SIGHUP, 0},
    {"quit", {SIGQUIT}, 0, SIGQUIT, 0},
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

/* ---- Files that lie about ------------------------------------------------------------------- */

/* A file, a folder with a file in it, and a file that is released again. */
static void guard_files(void) {
    static const char *const names[] = {"file", "sub/file", "released"};
    (void)mkdir("sub", 0700);
    interrupt_guard("sub");
    for (int i = 0; i < 3; i++) {
        (void)close(open(names[i], O_CREAT | O_WRONLY, 0600));
        interrupt_guard(names[i]);
    }
    interrupt_release(names[2]);
}

/* What becomes of a process with guarded files that gets signals, with the first noted or not. */
static int end_of_guard(bool is_caught, int signal_number, int times) {
    int status = 0;
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        guard_files();
        if (is_caught) {
            interrupt_catch();
        }
        for (int i = 0; i < times; i++) {
            (void)raise(signal_number);
            wait_us(LATER_US);
        }
        _exit(0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

static void what_is_guarded_goes_with_a_program_that_is_ended(void **state) {
    (void)state;
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    char folder[] = "/tmp/superframe-interrupt-XXXXXX", before[4096];
    assert_non_null(getcwd(before, sizeof before));
    assert_non_null(mkdtemp(folder));
    assert_int_equal(chdir(folder), 0);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(end_of_guard(false, signals[i], 1), signals[i]);
        assert_int_equal(access("file", F_OK) + access("sub", F_OK), -2);
        assert_int_equal(unlink("released"), 0);
    }
    assert_int_equal(end_of_guard(true, SIGINT, 1), 0);
    assert_int_equal(access("file", F_OK) + access("sub/file", F_OK), 0);
    assert_int_equal(end_of_guard(true, SIGINT, 2), SIGINT);
    assert_int_equal(access("file", F_OK) + access("sub", F_OK), -2);
    assert_int_equal(unlink("released"), 0);
    assert_int_equal(chdir(before), 0);
    assert_int_equal(rmdir(folder), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_repeat_counts_only_later),
        cmocka_unit_test(what_the_caller_ignores_stays_ignored),
        cmocka_unit_test(what_is_guarded_goes_with_a_program_that_is_ended),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
