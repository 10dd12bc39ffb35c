/* SPDX-License-Identifier: MIT */
/* What a boundary does to a ray: mirror direction, Snell's law, Fresnel's reflectance. */
#ifndef SUPERFRAME_OPTICS_H
#define SUPERFRAME_OPTICS_H

#include "scene.h"

/* What goes on behind a boundary, at one wavelength. */
struct passage {
    struct direction refracted; /* where transmittance is not zero */
    real_energy reflectance;    /* Ks */
    real_energy transmittance;  /* Kt = 1 - Ks */
};

/* Returns d + 2 c n, where c is the cosine of the angle of incidence. */
static inline struct direction mirror_direction(struct direction d, real_unit cosine,
                                                struct direction normal) {
    struct direction mirrored = {unit_mirrored(d.x, cosine, normal.x),
                                 unit_mirrored(d.y, cosine, normal.y),
                                 unit_mirrored(d.z, cosine, normal.z)};
    return mirrored;
}

/* Returns Fresnel's reflectance for unpolarised light from the cosines of incidence and refraction;
 * n = sin p / sin q. Eq. (1), Ks. */
static inline real_energy fresnel_reflectance(real_unit incident, real_unit refracted,
                                              real_index n) {
    real_index ci = index_of_unit(incident);
    real_index cr = index_of_unit(refracted);
    real_index n_ci = index_scaled(n, incident);
    real_index n_cr = index_scaled(n, refracted);
    real_energy s = energy_ratio(index_subtract(ci, n_cr), index_add(ci, n_cr));
    real_energy p = energy_ratio(index_subtract(n_ci, cr), index_add(n_ci, cr));
    return energy_mean_square(s, p);
}

/* Finds what a boundary between two transparent materials does to a ray. The index is that of one
 * channel (0, 1, 2: red, green, blue). The normal is turned towards the ray; cosine is that of the
 * angle of incidence. */
void optics_passage(const struct material *before, const struct material *after, uint8_t channel,
                    const struct direction *d, real_unit cosine, const struct direction *normal,
                    struct passage *passage);

/* Returns w at an angle given by its cosine: the constant, or a value from the material's table. */
real_energy specular_at(const struct scene *scene, const struct material *material,
                        real_unit cosine);

/* Returns the cosine of the angle of incidence, kept within 0..1 where rounding has left that
 * range. */
static inline real_unit incidence_cosine(struct direction d, struct direction normal) {
    real_unit cosine = unit_negate(direction_dot(d, normal));
    real_unit upward = unit_is_negative(cosine) ? REAL_UNIT(0.0) : cosine;
    return unit_less(REAL_UNIT(1.0), upward) ? REAL_UNIT(1.0) : upward;
}

#endif
