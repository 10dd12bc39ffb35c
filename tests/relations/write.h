/* SPDX-License-Identifier: MIT */
/* Abstract syntax as the text of a scene file. */
#ifndef SUPERFRAME_RELATIONS_WRITE_H
#define SUPERFRAME_RELATIONS_WRITE_H

#include <stdbool.h>
#include <stddef.h>

#include "syntax.h"

/* Writes the scene as text with a NUL; false where it does not fit into size bytes. */
bool write_scene(const struct syntax *syntax, char *text, size_t size);

#endif
