/* SPDX-License-Identifier: MIT */
/* Keys that other programs have, and where their like stands here. */
#include "scene/hints.h"

#include <stddef.h>
#include <string.h>

/* What is spelled nearly right is no matter of this table: the nearest key is found for it. */
static const struct {
    const char *what, *key, *hint;
} hints[] = {
    {"solid", "sphere", "it is called 'ball' here"},
    {"solid", "cube", "it is called 'box' here"},
    {"solid", "block", "it is called 'box' here"},
    {"solid", "plane", "it is called 'half_space' here"},
    {"solid", "mesh", "a convex one is a 'polyhedron' here, and others are unions of such"},
    {"solid", "merge", "it is called 'union' here"},
    {"solid", "subtract", "it is called 'difference' here"},
    {"solid", "position", "it is moved by 'translate'"},
    {"object", "translate", "it stands in the object's solid = { ... }"},
    {"object", "rotate", "it stands in the object's solid = { ... }"},
    {"object", "scale", "it stands in the object's solid = { ... }"},
    {"object", "position", "an object is moved by 'translate' in its solid = { ... }"},
    {"object", "box", "it stands in solid = { box = { ... }; }"},
    {"object", "ball", "it stands in solid = { ball = { ... }; }"},
    {"object", "sphere", "write solid = { ball = { ... }; }"},
    {"object", "union", "it stands in solid = { union = ( ... ); }"},
    {"object", "colour", "colours belong to materials"},
    {"camera", "position", "it is called 'eye' here"},
    {"camera", "location", "it is called 'eye' here"},
    {"camera", "target", "it is called 'look_at' here"},
    {"camera", "fov", "it is called 'field_of_view' here"},
    {"camera", "angle", "it is called 'field_of_view' here"},
    {"light", "intensity", "a brighter light has a 'colour' beyond 255"},
    {"light", "to", "parallel light has a 'direction'"},
    {"material", "index", "it is called 'ior' here"},
    {"material", "refraction", "it is called 'ior' here"},
    {"material", "mirror", "an opaque material with 'specular' is a mirror"},
    {"material", "transparency", "a material with 'ior' is transparent"},
    {"material", "transparent", "a material with 'ior' is transparent"},
    {"material", "reflection", "it is called 'specular' here"},
    {"material", "reflectivity", "it is called 'specular' here"},
    {"material", "shininess", "it is called 'gloss' here"},
    {"material", "phong", "highlights are 'specular' and 'gloss' here"},
    {"scene", "width", "it is the first of size = [WIDTH, HEIGHT]"},
    {"scene", "height", "it is the second of size = [WIDTH, HEIGHT]"},
    {"scene", "resolution", "it is called 'size' here"},
    {"scene", "light", "they stand in the list lights = ( { ... } )"},
    {"scene", "object", "they stand in the list objects = ( { ... } )"},
};

const char *scene_hint(const char *key, const char *what) {
    for (size_t i = 0; i < sizeof hints / sizeof hints[0]; i++) {
        if (strcmp(hints[i].key, key) == 0 &&
            strncmp(hints[i].what, what, strlen(hints[i].what)) == 0) {
            return hints[i].hint;
        }
    }
    return NULL;
}
