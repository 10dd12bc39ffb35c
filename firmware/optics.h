/* SPDX-License-Identifier: MIT */
/* What a boundary does to a ray: mirror direction, Snell's law, Fresnel's reflectance. */
#ifndef SUPERFRAME_OPTICS_H
#define SUPERFRAME_OPTICS_H

#include "scene.h"

/* What becomes of a ray at a boundary. */
struct split {
    struct direction mirrored;
    struct direction refracted; /* where transmittance is not zero */
    real_energy reflectance;    /* rho: Ks, or an opaque material's w */
    real_energy transmittance;  /* tau: Kt = 1 - Ks, 0 for an opaque material */
};

/* d + 2 c n, c being the cosine of the angle of incidence. */
struct direction mirror_direction(struct direction d, real_unit cosine, struct direction normal);

/* Fresnel's reflectance for unpolarised light, in the cosines of incidence and refraction;
 * n = sin p / sin q. Eq. (1), Ks. */
real_energy fresnel_reflectance(real_unit incident, real_unit refracted, real_index n);

/* Ray and boundary between two transparent materials; the normal is turned towards the ray. */
struct split optics_transparent(const struct material *before, const struct material *after,
                                struct direction d, struct direction normal);

/* The cosine of the angle of incidence, 0 where rounding has made it negative. */
real_unit incidence_cosine(struct direction d, struct direction normal);

#endif
