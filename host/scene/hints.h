/* SPDX-License-Identifier: MIT */
/* Keys that other programs have, and where their like stands here. */
#ifndef SUPERFRAME_SCENE_HINTS_H
#define SUPERFRAME_SCENE_HINTS_H

/* Returns what to write instead of a key of something ("solid", "material 'glass'"); NULL: nothing
 * is known of such a key. */
const char *scene_hint(const char *key, const char *what);

#endif
