/* SPDX-License-Identifier: MIT */
/* The superframe program: finds the sub-command and hands over to it. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/output.h"
#include "command/command.h"

static int run_command(const struct command *command, int argc, char **argv) {
    struct options_error error = {""};
    struct options *options = options_parse(command, argc, argv, &error);
    int status = STATUS_DONE;
    if (options == NULL) {
        return bad_input("%s", error.text);
    }
    if (options->help) {
        command_print_help(stdout, command);
    } else {
        status = command->run(options);
    }
    free(options);
    return status;
}

static int dispatch(int argc, char **argv) {
    if (argc < 2) {
        return bad_input("a command is missing; superframe --help lists them");
    }
    const char *name = argv[1];
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0) {
        program_print_help(stdout);
        return STATUS_DONE;
    }
    if (strcmp(name, "--version") == 0 || strcmp(name, "-V") == 0) {
        (void)printf("superframe %s\n", SUPERFRAME_VERSION);
        return STATUS_DONE;
    }
    const struct command *command = command_find(name);
    return command != NULL ? run_command(command, argc - 1, argv + 1) : command_unknown(name);
}

/* Occupies standard streams that are closed when the program starts. The next file opened would
 * become one of them, and messages would go into a picture. The descriptor that stands in can't be
 * used: 0 is not readable, 1 and 2 are not writable. */
static bool hold_standard_streams(void) {
    for (int descriptor = 0; descriptor <= 2; descriptor++) {
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF &&
            open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY) != descriptor) {
            return false;
        }
    }
    return true;
}

int main(int argc, char **argv) {
    /* A closed pipe or a file over its limit is a failed write, with a message, not a death. */
    struct sigaction ignore;
    memset(&ignore, 0, sizeof ignore);
    ignore.sa_handler = SIG_IGN;
    if (!hold_standard_streams() || sigaction(SIGPIPE, &ignore, NULL) != 0 ||
        sigaction(SIGXFSZ, &ignore, NULL) != 0) {
        return STATUS_FAILED;
    }

    int status = dispatch(argc, argv);
    errno = 0;
    if ((fflush(stdout) != 0 || ferror(stdout)) && status == STATUS_DONE) {
        if (!output_is_closed_pipe()) {
            complain("standard output: cannot be written: %s",
                     errno != 0 ? strerror(errno) : "an earlier write failed");
        }
        return STATUS_FAILED;
    }
    return status;
}
