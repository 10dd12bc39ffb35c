/* SPDX-License-Identifier: MIT */
/* Relations: two forms of a scene, or two ways to draw it, that must give one picture. */
#ifndef SUPERFRAME_RELATIONS_RELATION_H
#define SUPERFRAME_RELATIONS_RELATION_H

#include "rendering.h"
#include "syntax.h"

/* Which pixel of the second picture belongs to one of the first. */
enum picture_map { MAP_SAME, MAP_MIRRORED, MAP_ROLLED };

/* Arithmetics, as bits. */
enum { IN_F64 = 1, IN_F32 = 2, IN_FX = 4, IN_ALL = 7, RELATION_ARITHMETICS = 3 };

/* Returns an arithmetic by the number of its bit. */
const struct arithmetic *relation_arithmetic(int number);

enum fault {
    FAULT_NONE,
    FAULT_REFUSED,    /* one form is refused */
    FAULT_DRIFT,      /* signatures agree, levels do not */
    FAULT_FLIPS,      /* too many pixels took another path and show it */
    FAULT_LEAKED,     /* a ray left the scene inside a medium */
    FAULT_MEMBERSHIP, /* the oracle disagrees */
    FAULT_BITS        /* what must be equal bit for bit is not */
};

struct trial_result {
    bool applies; /* false: the relation says nothing of this scene */
    enum fault fault;
    char text[256]; /* what is wrong, and where */
    uint64_t pixels, agreeing, flips;
    int worst, worst_flip; /* levels, where signatures agree and where not */
};

struct relation {
    const char *name;
    unsigned arithmetics;
    enum picture_map map;

    /* Draws one scene in several ways, for relations that rewrite nothing; else NULL. */
    void (*check)(struct form *form, int arithmetic, struct rendering *room,
                  struct trial_result *result);

    /* Makes a scene fit for the relation; NULL: each is as it is. False: it can't be made so. */
    bool (*prepare)(struct syntax *scene, uint64_t *random);

    /* Rewrites a copy of the scene; false where the relation says nothing of this scene. */
    bool (*rewrite)(struct syntax *scene, uint64_t *random);

    /* The last material of the rewritten scene can't be seen, but its boundaries count as events.
     */
    bool has_ghost;

    /* The second picture is in f128, of the scene as it is. */
    bool is_f128;

    /* Every so many seeds it is tried; slow ones are tried less often. */
    int every;
};

extern const struct relation relations[];
extern const int relation_count;

/* Notes a fault in a result, as printf() formats it; the first one stays. */
void result_fail(struct trial_result *result, enum fault fault, const char *format, ...);

/* Checks by engines.c. */
void check_streams(struct form *form, int arithmetic, struct rendering *room,
                   struct trial_result *result);
void check_lists(struct form *form, int arithmetic, struct rendering *room,
                 struct trial_result *result);
void check_jobs(struct form *form, int arithmetic, struct rendering *room,
                struct trial_result *result);

/* A check by accuracies.c: no pixel is farther off than is proved. */
void check_proved(struct form *form, int arithmetic, struct rendering *room,
                  struct trial_result *result);

/* Rewrites by relations_place.c: the whole scene moves or turns, and the eye with it. */
bool rewrite_mirror(struct syntax *scene, uint64_t *random);
bool rewrite_move(struct syntax *scene, uint64_t *random);
bool rewrite_scale(struct syntax *scene, uint64_t *random);
bool rewrite_turn(struct syntax *scene, uint64_t *random);
bool rewrite_roll(struct syntax *scene, uint64_t *random);
bool prepare_turn(struct syntax *scene, uint64_t *random);

/* Rewrites by relations_objects.c: the list of objects, parts and lights. */
bool rewrite_object_order(struct syntax *scene, uint64_t *random);
bool rewrite_halves(struct syntax *scene, uint64_t *random);
bool rewrite_empty(struct syntax *scene, uint64_t *random);
bool rewrite_ghost(struct syntax *scene, uint64_t *random);
bool rewrite_as_part(struct syntax *scene, uint64_t *random);
bool rewrite_written_out(struct syntax *scene, uint64_t *random);
bool rewrite_light(struct syntax *scene, uint64_t *random);

/* Rewrites by relations_csg.c: operations of one solid. */
bool rewrite_child_order(struct syntax *scene, uint64_t *random);
bool rewrite_de_morgan(struct syntax *scene, uint64_t *random);
bool rewrite_split(struct syntax *scene, uint64_t *random);
bool rewrite_beyond(struct syntax *scene, uint64_t *random);
bool rewrite_alone(struct syntax *scene, uint64_t *random);
bool rewrite_cutter(struct syntax *scene, uint64_t *random);
bool prepare_cutter(struct syntax *scene, uint64_t *random);

/* Rewrites by relations_wording.c: leaves and placements in other words. */
bool rewrite_ends(struct syntax *scene, uint64_t *random);
bool rewrite_leaves(struct syntax *scene, uint64_t *random);
bool rewrite_placements(struct syntax *scene, uint64_t *random);
bool rewrite_forms(struct syntax *scene, uint64_t *random);

#endif
