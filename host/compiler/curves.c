/* SPDX-License-Identifier: MIT */
/* The scene compiler: finds curved surfaces that are one, however the file writes each. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "compiler/compiler_internal.h"
#include "splitmix64.h"

/* Nine points in general position determine a quadric; some more give a margin. */
enum { POINTS_LEAST = 12, POINTS_MOST = CURVE_POINTS_MOST, LINES = 96 };

static double random_within(uint64_t *state, double most) {
    return most * ((double)(splitmix64(state) >> 11) * 0x1p-52 - 1);
}

/* Returns a form's value at a point, and fills half its gradient there. */
static double form_at(const struct quadric_axes *form, const double point[3], double half[3]) {
    double value = form->constant;
    const double from[3] = {point[0] - form->origin[0], point[1] - form->origin[1],
                            point[2] - form->origin[2]};
    half[0] = half[1] = half[2] = 0;
    for (int i = 0; i < 3; i++) {
        double x = vector_dot(from, form->axis[i]), linear = i == 2 ? form->linear : 0;
        value += (form->square[i] * x + 2 * linear) * x;
        for (int j = 0; j < 3; j++) {
            half[j] += (form->square[i] * x + linear) * form->axis[i][j];
        }
    }
    return value;
}

/* Finds how far from the centre, along each axis, lines are to start so that they meet the
 * surface. */
static void find_spans(const struct quadric_axes *form, double span[3]) {
    double most = -HUGE_VAL, least = HUGE_VAL, square = fabs(form->constant);
    for (int i = 0; i < 3; i++) {
        most = fmax(most, form->square[i]);
        least = fmin(least, form->square[i]);
    }
    if (form->linear != 0) {
        square = fabs(form->linear) * COMPILE_EXTENT;
    } else if (most > 0 && least < 0) {
        square = fmax(square, 1); /* not at the tip, where cones are alike */
    }
    for (int i = 0; i < 3; i++) {
        span[i] = form->square[i] == 0 ? COMPILE_EXTENT / 2
                                       : fmin(sqrt(square / fabs(form->square[i])), COMPILE_WORLD);
    }
}

/* Finds the points, at most two, where a line meets a form's surface in the world, and returns
 * their number. The line is given in the form's own axes. */
static int meet_line(const struct quadric_axes *form, const double start[3], const double way[3],
                     double points[2][3]) {
    double a = 0, b = way[2] * form->linear, c = form->constant + 2 * form->linear * start[2];
    for (int i = 0; i < 3; i++) {
        a += form->square[i] * way[i] * way[i];
        b += form->square[i] * way[i] * start[i];
        c += form->square[i] * start[i] * start[i];
    }
    double square = b * b - a * c;
    if (!(square > b * b / 64)) { /* the line touches the surface, or misses it */
        return 0;
    }
    double q = b < 0 ? sqrt(square) - b : -b - sqrt(square);
    const double t[2] = {c / q, q / a};
    int count = 0;
    for (int root = 0; root < 2; root++) {
        bool within = isfinite(t[root]);
        for (int j = 0; j < 3; j++) {
            points[count][j] = form->origin[j];
            for (int i = 0; i < 3; i++) {
                points[count][j] += (start[i] + t[root] * way[i]) * form->axis[i][j];
            }
            within = within && fabs(points[count][j]) < COMPILE_WORLD;
        }
        count += within;
    }
    return count;
}

/* Finds points of a surface, spread over its part in the world, and returns their number. */
static int curve_points(const struct quadric_axes *form, double points[POINTS_MOST + 1][3]) {
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, centre[3] = {0, 0, 0};
    uint64_t state = 1;
    double span[3];
    int count = 0;
    bool is_cone = form->square[0] < 0 || form->square[1] < 0 || form->square[2] < 0;
    for (int i = 0; i < 3 && !is_cone; i++) { /* the ends of axes, which move most */
        count += meet_line(form, centre, axes[i], &points[count]);
    }
    find_spans(form, span);
    for (int line = 0; line < LINES && count < POINTS_MOST; line++) {
        double start[3], way[3];
        for (int i = 0; i < 3; i++) {
            start[i] = random_within(&state, span[i]);
            way[i] = random_within(&state, span[i]);
        }
        count += meet_line(form, start, way, &points[count]);
    }
    return count;
}

static struct quadric_axes form_of_quadric(const struct compiled_scene *scene, uint32_t frame,
                                           const struct compiled_quadric *quadric) {
    struct quadric_axes form = {{0}, {{0}}, {0}, 0, 0};
    for (int i = 0; i < 3; i++) {
        memcpy(form.axis[i], compiled_axis(scene, frame, i), sizeof form.axis[i]);
    }
    memcpy(form.origin, quadric->centre, sizeof form.origin);
    memcpy(form.square, quadric->square, sizeof form.square);
    form.linear = quadric->linear;
    form.constant = quadric->constant;
    return form;
}

/* Gives the form of a ball or a quadric, without the planes that cut it; false for other kinds. */
static bool curve_of_primitive(const struct compiled_scene *scene, uint32_t index,
                               struct quadric_axes *form) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    struct compiled_quadric quadric = {.square = {1, 1, 1}};
    if (primitive->kind == PRIMITIVE_BALL) {
        const struct compiled_ball *ball = &scene->balls[primitive->index];
        memcpy(quadric.centre, ball->centre, sizeof quadric.centre);
        quadric.constant = -ball->radius * ball->radius;
    } else if (primitive->kind == PRIMITIVE_QUADRIC) {
        quadric = scene->quadrics[primitive->index];
    } else {
        return false;
    }
    *form = form_of_quadric(scene, primitive->frame, &quadric);
    return true;
}

uint32_t compiled_curve(const struct compiled_scene *scene, uint32_t index) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    return primitive->kind == PRIMITIVE_BALL      ? scene->balls[primitive->index].surface
           : primitive->kind == PRIMITIVE_QUADRIC ? scene->quadrics[primitive->index].surface
                                                  : COMPILED_NONE;
}

/* Returns the largest distance of points from a surface; each is estimated as value over
 * gradient. */
static double stray(const struct quadric_axes *form, double points[][3], int count) {
    double most = 0;
    for (int i = 0; i < count; i++) {
        double half[3];
        double value = form_at(form, points[i], half);
        most = fmax(most, fabs(value) / fmax(2 * vector_length(half), 1e-300));
    }
    return most;
}

double compiled_quadric_strays(const struct compiled_scene *scene, uint32_t frame,
                               const struct compiled_quadric *from,
                               const struct compiled_quadric *other) {
    double points[POINTS_MOST + 1][3];
    struct quadric_axes form = form_of_quadric(scene, frame, from);
    struct quadric_axes moved = form_of_quadric(scene, frame, other);
    return stray(&moved, points, curve_points(&form, points));
}

/* Tells whether all points are as near to a form's surface as if the two were one. */
static bool is_same_curve(const struct compiler *compiler, const struct quadric_axes *form,
                          double points[][3], int count) {
    for (int i = 0; i < count; i++) {
        if (stray(form, &points[i], 1) > compiler->same) {
            return false;
        }
    }
    return true;
}

/* ---- Where curves are --------------------------------------------------------------------- */

/* Returns the one axis of the world that a form's surface goes on along. Returns -1 if it has an
 * end, or goes on along others. */
static int axis_along(const struct quadric_axes *form) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3 && form->linear == 0; j++) {
            if (form->square[i] == 0 && fabs(form->axis[i][j]) == 1 &&
                form->square[(i + 1) % 3] > 0 && form->square[(i + 2) % 3] > 0) {
                return j;
            }
        }
    }
    return -1;
}

/* Finds bounds beyond which no point counts as one of a form's surface; 0 along one axis, if it is
 * not -1. Returns false where the surface has no such end, or is so small that the distance from it
 * is not known. Off an ellipsoid or a cylinder, the gradient is never less than on its flattest
 * place. While the gradient is eight times the tolerance, the value over the gradient is at least
 * half of the distance. */
static bool curve_bounds(const struct compiler *compiler, const struct quadric_axes *form,
                         int along, struct bounds *bounds) {
    double least = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        least = along >= 0 && form->square[i] == 0 ? least : fmin(least, form->square[i]);
    }
    if (!(least > 0 && form->constant < 0) ||
        2 * sqrt(-form->constant * least) < 8 * compiler->same) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        double square = 0;
        for (int j = 0; j < 3; j++) {
            if (form->square[j] > 0) {
                square -= form->axis[j][i] * form->axis[j][i] * form->constant / form->square[j];
            }
        }
        double reach = sqrt(square) * (1 + 0x1p-40) + 4 * compiler->same;
        bounds->low[i] = i == along ? 0 : form->origin[i] - reach;
        bounds->high[i] = i == along ? 0 : form->origin[i] + reach;
    }
    return true;
}

/* Notes a form's surface as one of a primitive; false if memory is out. */
static bool note_form(struct compiler *compiler, const struct quadric_axes *form,
                      uint32_t primitive) {
    struct curves *curves = &compiler->curves;
    struct bounds bounds;
    const int along = axis_along(form);
    if (curve_bounds(compiler, form, along, &bounds)) {
        return neighbours_add(along < 0 ? &curves->ended : &curves->along[along], &bounds,
                              primitive);
    }
    if (!GROW(curves->endless, curves->endless_count)) {
        return false;
    }
    curves->endless[curves->endless_count++] = (struct endless_curve){*form, primitive};
    return true;
}

uint32_t compile_note_curve(struct compiler *compiler, uint32_t primitive) {
    struct quadric_axes form;
    if (primitive != COMPILED_NONE && curve_of_primitive(compiler->scene, primitive, &form) &&
        !note_form(compiler, &form, primitive)) {
        return compile_fail_room(compiler);
    }
    return primitive;
}

void curves_clear(struct curves *curves) {
    neighbours_clear(&curves->ended);
    for (int i = 0; i < 3; i++) {
        neighbours_clear(&curves->along[i]);
    }
    free(curves->endless);
    memset(curves, 0, sizeof *curves);
}

/* ---- Curves that are one -------------------------------------------------------------------- */

/* Makes *twin the first primitive on whose curved surface all points are, if that comes before
 * *twin. Looks at those whose bounds may hold a place. Returns false if memory is out. */
static bool find_among(const struct compiler *compiler, const struct neighbours *among,
                       const double place[3], double points[][3], int count, uint32_t *twin) {
    struct compiled_set found = {NULL, 0};
    struct bounds bounds = bounds_nothing;
    bounds_include(&bounds, place);
    bool has_memory = neighbours_find(among, &bounds, 0, &found);
    for (uint32_t i = 0; i < found.count && found.members[i] < *twin && has_memory; i++) {
        struct quadric_axes form;
        if (curve_of_primitive(compiler->scene, found.members[i], &form) &&
            is_same_curve(compiler, &form, points, count)) {
            *twin = found.members[i];
        }
    }
    compiled_set_clear(&found);
    return has_memory;
}

static bool find_twin(const struct compiler *compiler, double points[][3], int count,
                      uint32_t *twin) {
    const struct curves *curves = &compiler->curves;
    bool has_memory = find_among(compiler, &curves->ended, points[0], points, count, twin);
    for (int i = 0; i < 3 && has_memory; i++) {
        double place[3] = {points[0][0], points[0][1], points[0][2]};
        place[i] = 0;
        has_memory = find_among(compiler, &curves->along[i], place, points, count, twin);
    }
    for (uint32_t i = 0; i < curves->endless_count && curves->endless[i].primitive < *twin; i++) {
        if (is_same_curve(compiler, &curves->endless[i].form, points, count)) {
            *twin = curves->endless[i].primitive;
        }
    }
    return has_memory;
}

bool compile_same_curve(struct compiler *compiler, const struct quadric_axes *form, uint32_t *twin,
                        bool *opposite) {
    double points[POINTS_MOST + 1][3];
    int count = curve_points(form, points);
    *twin = COMPILED_NONE;
    if (count >= POINTS_LEAST && !find_twin(compiler, points, count, twin)) {
        return compile_fail_memory(compiler);
    }
    struct quadric_axes other;
    if (*twin != COMPILED_NONE && curve_of_primitive(compiler->scene, *twin, &other)) {
        double here[3], there[3];
        (void)form_at(form, points[0], here);
        (void)form_at(&other, points[0], there);
        *opposite = vector_dot(here, there) < 0;
    }
    return true;
}

void compile_sample_curve(const struct compiled_scene *scene, uint32_t primitive,
                          struct curve_sample *sample) {
    struct quadric_axes form;
    sample->primitive = primitive;
    sample->count =
        curve_of_primitive(scene, primitive, &form) ? curve_points(&form, sample->points) : 0;
}

double compile_curve_distance(const struct compiled_scene *scene, struct curve_sample *sample,
                              uint32_t other) {
    struct quadric_axes there;
    return sample->count < POINTS_LEAST || !curve_of_primitive(scene, other, &there) ||
                   compiled_curve(scene, sample->primitive) == compiled_curve(scene, other)
               ? HUGE_VAL
               : stray(&there, sample->points, sample->count);
}
