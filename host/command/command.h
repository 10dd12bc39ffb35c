/* SPDX-License-Identifier: MIT */
/* The sub-commands of superframe: their table, and the function that runs each. */
#ifndef SUPERFRAME_COMMAND_H
#define SUPERFRAME_COMMAND_H

#include "base/complain.h"
#include "options/options.h"

#define SUPERFRAME_VERSION "0.1.0"

extern const struct command commands[]; /* in the order of enum command_id */

int run_render(const struct options *options);
int run_scenes(const struct options *options);
int run_check(const struct options *options);
int run_boot(const struct options *options);
int run_compile(const struct options *options);
int run_export(const struct options *options);
int run_tree(const struct options *options);
int run_replay(const struct options *options);
int run_devices(const struct options *options);
int run_adapter(const struct options *options);
int run_compare(const struct options *options);
int run_measure(const struct options *options);
int run_paper(const struct options *options);
int run_trace(const struct options *options);

#endif
