/* SPDX-License-Identifier: MIT */
/* An independent oracle: which material holds a point, by membership in the abstract syntax alone.
 * It knows no bounds, no enclosures, no shared surfaces, and shares no code with the compiler. */
#ifndef SUPERFRAME_RELATIONS_ORACLE_H
#define SUPERFRAME_RELATIONS_ORACLE_H

#include "syntax.h"

enum { ORACLE_AIR = -1, ORACLE_UNKNOWN = -2 };

enum { ORACLE_NODES_MOST = 4096, ORACLE_LIMITS_MOST = 16384 };

/* p Q p + b p + c <= 0; a plane has no Q. */
struct oracle_limit {
    double square[3][3], linear[3], constant;
    double bend; /* the largest of the squares; 0: a plane */
};

struct oracle_node {
    enum syntax_kind kind;
    int material;
    int first, count; /* limits of a leaf */
    int children[SYNTAX_CHILDREN_MOST], child_count;
};

struct oracle {
    double tolerance; /* points this near to a surface are passed over */
    struct oracle_node nodes[ORACLE_NODES_MOST];
    struct oracle_limit limits[ORACLE_LIMITS_MOST];
    int node_count, limit_count;
    int objects[SYNTAX_OBJECTS_MOST], object_count;
    bool is_full;
};

/* Prepares for points in scaled coordinates, (p - centre) * 2^exponent; false if it is too large.
 */
bool oracle_start(struct oracle *oracle, const struct syntax *syntax, const double centre[3],
                  int exponent);

/* Checks whether a boundary's point lies in one smooth surface with nothing else near: what is just
 * behind it is told by the normal there then. */
bool oracle_is_smooth(const struct oracle *oracle, const double point[3], const double normal[3]);

/* Returns the material that fills a point, ORACLE_AIR or ORACLE_UNKNOWN. */
int oracle_material(const struct oracle *oracle, const double point[3]);

#endif
