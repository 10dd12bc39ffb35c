/* SPDX-License-Identifier: MIT */
/* Values of a scene that are assigned from outside of its file. */
#ifndef SUPERFRAME_SCENE_ASSIGN_H
#define SUPERFRAME_SCENE_ASSIGN_H

#include "scene/reader_internal.h"

/* Puts the value of "PATH=VALUE" into the tree. PATH has keys with dots between. An element of a
 * list is called by its number from 0, or by its `name`. VALUE is as in a scene file. What is
 * replaced may be anything. A key that is missing is added to its group. Returns false with the
 * failure recorded. */
bool scene_assign(struct scene_reader *reader, struct scene_value *root, const char *assignment);

#endif
