/* SPDX-License-Identifier: MIT */
/* Shares between the files of this folder the setters of options whose values no type of the tables
 * can read. */
#ifndef SUPERFRAME_OPTIONS_INTERNAL_H
#define SUPERFRAME_OPTIONS_INTERNAL_H

#include "options/options.h"

/* Finds the place of a value among words; -1: it is none of them. */
int option_word(const char *value, const char *const *words);

/* As the member `set` of struct option_entry says. */

enum value_verdict set_arithmetic(struct options *options, const char *value);
enum value_verdict set_size(struct options *options, const char *value);
enum value_verdict set_small_size(struct options *options, const char *value);
enum value_verdict set_model(struct options *options, const char *value);
extern const char *const scene_model_words[]; /* what set_model() takes; ended by NULL */
enum value_verdict set_colour(struct options *options, const char *value);
enum value_verdict set_value(struct options *options, const char *value); /* of --set */
enum value_verdict set_base(struct options *options, const char *value);
enum value_verdict set_strict(struct options *options, const char *value); /* NULL: no grade */
enum value_verdict set_faults(struct options *options, const char *value);

#endif
