/* SPDX-License-Identifier: MIT */
/* Placements as the scene format defines them, reckoned apart from the compiler's. */
#include "place.h"

#include <math.h>
#include <string.h>

/* Turns about an axis; right angles are exact. */
static void turn(struct place *place, int axis, double degrees) {
    int i = (axis + 1) % 3, j = (axis + 2) % 3;
    double quarter = degrees / 90, c, s;
    if (quarter - floor(quarter) > 0) {
        c = cos(degrees * 0.017453292519943295);
        s = sin(degrees * 0.017453292519943295);
    } else {
        static const double sines[4] = {0, 1, 0, -1};
        int quarters = (int)(quarter - 4 * floor(quarter / 4));
        s = sines[quarters];
        c = sines[(quarters + 1) % 4];
    }
    for (int k = 0; k < 3; k++) {
        double x = place->map[i][k], y = place->map[j][k];
        place->map[i][k] = c * x - s * y;
        place->map[j][k] = s * x + c * y;
    }
}

struct place place_inner(const struct place *outer, const struct syntax_solid *solid) {
    struct place own, both;
    memset(&own, 0, sizeof own);
    for (int i = 0; i < 3; i++) {
        own.map[i][i] = solid->scale[i];
    }
    for (int axis = 0; axis < 3; axis++) {
        turn(&own, axis, solid->rotate[axis]);
    }
    for (int i = 0; i < 3; i++) {
        both.move[i] = outer->move[i];
        for (int k = 0; k < 3; k++) {
            both.move[i] += outer->map[i][k] * solid->translate[k];
            both.map[i][k] = 0;
            for (int j = 0; j < 3; j++) {
                both.map[i][k] += outer->map[i][j] * own.map[j][k];
            }
        }
    }
    return both;
}

void place_invert(const struct place *place, struct place *inverse) {
    const double(*m)[3] = place->map;
    double determinant = 0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            inverse->map[j][i] = m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3] -
                                 m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3];
        }
    }
    for (int j = 0; j < 3; j++) {
        determinant += m[0][j] * inverse->map[j][0];
    }
    for (int i = 0; i < 3; i++) {
        inverse->move[i] = 0;
        for (int j = 0; j < 3; j++) {
            inverse->map[i][j] /= determinant;
            inverse->move[i] -= inverse->map[i][j] * place->move[j];
        }
    }
}

void place_point(const struct place *place, const double point[3], double image[3]) {
    for (int i = 0; i < 3; i++) {
        image[i] = place->move[i];
        for (int j = 0; j < 3; j++) {
            image[i] += place->map[i][j] * point[j];
        }
    }
}
