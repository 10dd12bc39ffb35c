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

/* d + 2 c n, c being the cosine of the angle of incidence. */
struct direction mirror_direction(struct direction d, real_unit cosine, struct direction normal);

/* Fresnel's reflectance for unpolarised light, in the cosines of incidence and refraction;
 * n = sin p / sin q. Eq. (1), Ks. */
real_energy fresnel_reflectance(real_unit incident, real_unit refracted, real_index n);

/* A ray at a boundary between two transparent materials, for the index of one channel (0, 1, 2:
 * red, green, blue). The normal is turned towards the ray; cosine is that of the angle of
 * incidence. */
struct passage optics_passage(const struct material *before, const struct material *after,
                              uint8_t channel, struct direction d, real_unit cosine,
                              struct direction normal);

/* w at an angle given by its cosine: the constant, or from the material's table. */
real_energy specular_at(const struct scene *scene, const struct material *material,
                        real_unit cosine);

/* The cosine of the angle of incidence, 0 where rounding has made it negative. */
real_unit incidence_cosine(struct direction d, struct direction normal);

#endif
