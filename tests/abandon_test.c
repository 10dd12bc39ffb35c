/* SPDX-License-Identifier: MIT */
/* Computations that are given up in their midst, and those that are not. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <unistd.h>

#include <cmocka.h>

#include "abandon.h"
#include "stopwatch.h"

static volatile sig_atomic_t stop;

static void note(int signal_number) {
    stop = signal_number;
}

static void count_up(void *context) {
    volatile unsigned *count = context;
    for (int i = 0; i < 1000; i++) {
        ++*count;
    }
}

static void count_for_ever(void *context) {
    volatile unsigned *count = context;
    for (;;) {
        ++*count;
    }
}

static void what_is_not_stopped_is_done(void **state) {
    (void)state;
    unsigned count = 0;
    stop = 0;
    for (unsigned i = 1; i <= 100; i++) {
        assert_true(do_until(&stop, count_up, &count));
        assert_int_equal(count, 1000 * i);
    }
    assert_true(do_until(NULL, count_up, &count));
    assert_int_equal(count, 101000);
}

static void what_is_stopped_before_is_not_begun(void **state) {
    (void)state;
    unsigned count = 0;
    stop = SIGINT;
    assert_false(do_until(&stop, count_for_ever, &count));
    assert_int_equal(count, 0);
}

static void work_without_an_end_is_given_up_when_a_signal_says_so(void **state) {
    (void)state;
    for (int i = 0; i < 3; i++) {
        static unsigned count;
        struct timespec began = stopwatch_start();
        count = 0;
        stop = 0;
        (void)signal(SIGALRM, note);
        (void)alarm(1);
        assert_false(do_until(&stop, count_for_ever, &count));
        assert_int_equal(stop, SIGALRM);
        assert_true(count > 0);
        assert_true(stopwatch_seconds(&began) < 20); /* however busy the machine is */
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_not_stopped_is_done),
        cmocka_unit_test(what_is_stopped_before_is_not_begun),
        cmocka_unit_test(work_without_an_end_is_given_up_when_a_signal_says_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
