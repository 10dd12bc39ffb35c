/* SPDX-License-Identifier: MIT */
/* Does what every sub-command with a board needs: puts buses together, writes results, judges. */
#include "board/session.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/complain.h"
#include "base/stopwatch.h"
#include "board/screen_file.h"
#include "board/strict.h"

int session_begin(struct session *session, const struct board_options *options,
                  const struct session_device *device) {
    struct board_desc desc = board_default_desc(options->profile);
    desc.base = options->base;
    session->options = options;
    session->chain = port_chain_new(&desc, device == NULL);
    if (session->chain == NULL) {
        return failure("out of memory");
    }
    if (device != NULL) {
        session->device = *device;
    }
    if (session->device.bus != NULL) {
        port_chain_end_at(session->chain, session->device.bus);
    }
    return STATUS_DONE;
}

/* Returns the form that a trace's name asks for: text for .txt, else binary. */
static enum trace_format format_of_name(const char *path) {
    size_t length = strlen(path);
    return length >= 4 && strcmp(path + length - 4, ".txt") == 0 ? TRACE_TEXT : TRACE_BINARY;
}

static bool open_results(struct session *session, const struct session_files *files) {
    session->files = *files;
    if (files->picture != NULL) {
        session->picture = png_sink_open(files->picture);
        if (session->picture == NULL) {
            return false;
        }
    }
    return (files->stats == NULL || output_open(&session->stats, files->stats)) &&
           (files->trace == NULL || output_open(&session->trace, files->trace));
}

int session_open(struct session *session, const struct session_files *files) {
    const struct board_options *options = session->options;
    struct port_chain *chain = session->chain;
    if (options->native != NULL) {
        if (!native_read(&chain->native, options->native)) {
            return STATUS_BAD_INPUT;
        }
        chain->has_native = true;
    }
    if (options->has_faults) {
        port_chain_spoil(chain, &options->faults);
    }
    if (files->stats != NULL) {
        port_chain_count(chain);
    }
    if (!open_results(session, files)) {
        return STATUS_FAILED;
    }
    if (files->trace != NULL) {
        port_chain_record(chain, session->trace.file, format_of_name(files->trace));
    }
    return STATUS_DONE;
}

void session_limit_trace(struct session *session, uint64_t accesses_most) {
    if (session->files.trace != NULL) {
        port_chain_limit(session->chain, session->files.trace, accesses_most);
    }
}

struct bus *session_bus(struct session *session) {
    return port_chain_bus(session->chain, session->stats.file != NULL);
}

int session_end_accesses(struct session *session) {
    const struct port_chain *chain = session->chain;
    enum bus_status status = port_chain_finish(session->chain);
    if (status == BUS_OK) {
        return session->trace.file == NULL || output_commit(&session->trace) ? STATUS_DONE
                                                                             : STATUS_FAILED;
    }
    if (chain->is_recording && chain->recorder.error_number != 0) {
        output_complain(&session->trace, strerror(chain->recorder.error_number));
    } else if (session->device.explain != NULL) {
        session->device.explain(session->device.context);
    } else {
        complain("the ports: %s", bus_status_text(status));
    }
    return STATUS_FAILED;
}

/* Returns "a.partial.png" for "a.png" and for "a", in new memory; NULL: out of memory. */
static char *partial_name_of(const char *name) {
    static const char ending[] = ".partial.png";
    size_t length = strlen(name);
    if (length > 4 && strcmp(name + length - 4, ".png") == 0) {
        length -= 4;
    }
    char *partial = malloc(length + sizeof ending);
    if (partial != NULL) {
        (void)snprintf(partial, length + sizeof ending, "%.*s%s", (int)length, name, ending);
    }
    return partial;
}

bool session_divert_picture(struct session *session) {
    const char *name = session->files.picture;
    struct stat facts;
    if (name == NULL || strcmp(name, "-") == 0 ||
        (stat(name, &facts) == 0 && !S_ISREG(facts.st_mode))) {
        return true;
    }
    session->partial_name = partial_name_of(name);
    if (session->partial_name == NULL) {
        complain("out of memory");
        return false;
    }
    picture_sink_close(session->picture);
    session->picture = png_sink_open(session->partial_name);
    return session->picture != NULL;
}

/* Returns the PC's own screen; NULL: black. */
static const struct native_screen *native_of(const struct port_chain *chain) {
    return chain->has_native ? &chain->native : NULL;
}

struct shown_picture session_picture(struct session *session) {
    struct port_chain *chain = session->chain;
    return board_picture(&chain->board, native_of(chain), session->options->picture, chain->rgb);
}

bool session_commit_picture(struct session *session) {
    struct port_chain *chain = session->chain;
    return session->picture == NULL ||
           board_picture_finish(session->picture, &chain->board, native_of(chain),
                                session->options->picture, chain->rgb);
}

int session_judge(const struct session *session) {
    const struct board_options *options = session->options;
    return !options->strict || port_chain_holds(session->chain, options->has_strict_grade,
                                                options->strict_grade)
               ? STATUS_DONE
               : STATUS_NOT_HELD;
}

void session_free(struct session *session) {
    picture_sink_close(session->picture);
    output_discard(&session->trace);
    output_discard(&session->stats);
    port_chain_free(session->chain);
    free(session->partial_name);
}
