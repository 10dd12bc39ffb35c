/* SPDX-License-Identifier: MIT */
/* Output files: whole under the asked name, or not there; full disks, pipes, links. */
#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/output.h"
#include "folder_fixture.h"

static void write_out(const char *path, const char *text) {
    struct output output;
    assert_true(output_open(&output, path));
    assert_true(fputs(text, output.file) >= 0);
    assert_true(output_commit(&output));
}

static void a_new_file(void **state) {
    (void)state;
    struct output output;
    struct stat facts;
    mode_t mask = umask(027);
    assert_true(output_open(&output, "new"));
    assert_true(fputs("text", output.file) >= 0);
    assert_int_equal(access("new", F_OK), -1); /* not before the end */
    assert_true(output_commit(&output));
    (void)umask(mask);
    assert_holds("new", "text");
    assert_int_equal(stat("new", &facts), 0);
    assert_int_equal(facts.st_mode & 0777, 0640);
    assert_int_equal(count_files(false), 1);
}

static void replacing_keeps_the_rights(void **state) {
    (void)state;
    struct stat facts;
    put("old", "old");
    assert_int_equal(chmod("old", 0604), 0);
    write_out("old", "new");
    assert_holds("old", "new");
    assert_int_equal(stat("old", &facts), 0);
    assert_int_equal(facts.st_mode & 0777, 0604);
    assert_int_equal(count_files(false), 1);
}

static void giving_up_leaves_what_was_there(void **state) {
    (void)state;
    struct output output;
    put("old", "old");
    assert_true(output_open(&output, "old"));
    assert_true(fputs("new", output.file) >= 0);
    output_discard(&output);
    output_discard(&output); /* harmless */
    assert_holds("old", "old");
    assert_true(output_open(&output, "new"));
    output_discard(&output);
    assert_int_equal(count_files(false), 1);
}

static void a_link_stays_and_its_target_is_replaced(void **state) {
    (void)state;
    struct stat facts;
    assert_int_equal(mkdir("sub", 0700), 0);
    put("sub/old", "old");
    assert_int_equal(symlink("old", "sub/link"), 0);
    assert_int_equal(symlink("sub/link", "chain"), 0);
    assert_int_equal(symlink("not-there-yet", "dangling"), 0);
    assert_int_equal(symlink("loop", "loop"), 0);
    write_out("chain", "new");
    assert_holds("sub/old", "new");
    assert_true(lstat("chain", &facts) == 0 && S_ISLNK(facts.st_mode));
    write_out("dangling", "born");
    assert_holds("not-there-yet", "born");
    assert_true(lstat("dangling", &facts) == 0 && S_ISLNK(facts.st_mode));
    struct output output;
    assert_false(output_open(&output, "loop"));
    assert_int_equal(remove("sub/link") + remove("sub/old"), 0);
    assert_int_equal(rmdir("sub"), 0); /* nothing else was left there */
}

static void what_can_not_be_opened(void **state) {
    (void)state;
    struct output output;
    put("file", "old");
    assert_false(output_open(&output, "no-folder/file"));
    assert_false(output_open(&output, "file/file"));
    assert_false(output_open(&output, "."));
    assert_false(output_open(&output, ""));
    assert_false(output_open(&output, "/proc/superframe"));
    assert_holds("file", "old");
    assert_int_equal(count_files(false), 1);
}

static void a_device_is_written_to(void **state) {
    (void)state;
    struct stat facts;
    write_out("/dev/null", "text");
    assert_true(stat("/dev/null", &facts) == 0 && S_ISCHR(facts.st_mode));
}

static void a_full_device(void **state) {
    (void)state;
    struct output output;
    struct stat facts;
    assert_true(output_open(&output, "/dev/full"));
    (void)fputs("text", output.file);
    assert_false(output_commit(&output));
    assert_true(stat("/dev/full", &facts) == 0 && S_ISCHR(facts.st_mode));
}

/* A file that may not grow stands for a full disk: the write fails half-way. */
static void a_full_disk_leaves_what_was_there(void **state) {
    (void)state;
    struct output output;
    struct rlimit before, limit;
    char block[4096];
    memset(block, 'x', sizeof block);
    put("old", "old");
    (void)signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    limit = before;
    limit.rlim_cur = 10000;
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
    bool opened = output_open(&output, "old");
    for (int i = 0; i < 8; i++) {
        (void)fwrite(block, 1, sizeof block, output.file);
    }
    bool committed = output_commit(&output);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    (void)signal(SIGXFSZ, SIG_DFL);
    assert_true(opened && !committed);
    assert_holds("old", "old");
    assert_int_equal(count_files(false), 1);
}

static void a_fifo_is_written_to(void **state) {
    (void)state;
    struct stat facts;
    char bytes[16] = "";
    assert_int_equal(mkfifo("fifo", 0600), 0);
    int reader = open("fifo", O_RDONLY | O_NONBLOCK);
    assert_true(reader >= 0);
    write_out("fifo", "text");
    assert_int_equal(read(reader, bytes, sizeof bytes), 4);
    assert_string_equal(bytes, "text");
    (void)close(reader);
    assert_true(stat("fifo", &facts) == 0 && S_ISFIFO(facts.st_mode));
    assert_int_equal(count_files(false), 1);
}

static void a_closed_pipe_is_an_error(void **state) {
    (void)state;
    struct output output;
    assert_int_equal(mkfifo("fifo", 0600), 0);
    (void)signal(SIGPIPE, SIG_IGN);
    int reader = open("fifo", O_RDONLY | O_NONBLOCK);
    bool opened = output_open(&output, "fifo");
    (void)close(reader);
    (void)fputs("text", output.file);
    bool committed = output_commit(&output);
    (void)signal(SIGPIPE, SIG_DFL);
    assert_true(opened && !committed);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_new_file, enter, leave),
        cmocka_unit_test_setup_teardown(replacing_keeps_the_rights, enter, leave),
        cmocka_unit_test_setup_teardown(giving_up_leaves_what_was_there, enter, leave),
        cmocka_unit_test_setup_teardown(a_link_stays_and_its_target_is_replaced, enter, leave),
        cmocka_unit_test_setup_teardown(what_can_not_be_opened, enter, leave),
        cmocka_unit_test_setup_teardown(a_device_is_written_to, enter, leave),
        cmocka_unit_test_setup_teardown(a_full_device, enter, leave),
        cmocka_unit_test_setup_teardown(a_full_disk_leaves_what_was_there, enter, leave),
        cmocka_unit_test_setup_teardown(a_fifo_is_written_to, enter, leave),
        cmocka_unit_test_setup_teardown(a_closed_pipe_is_an_error, enter, leave),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
