/* SPDX-License-Identifier: MIT */
/* Mirror direction, Snell's law and Fresnel's reflectance, in cosines throughout. */
#include "optics.h"

real_unit incidence_cosine(struct direction d, struct direction normal) {
    real_unit cosine = unit_negate(direction_dot(d, normal));
    if (unit_is_negative(cosine)) {
        return REAL_UNIT(0.0);
    }
    return unit_less(REAL_UNIT(1.0), cosine) ? REAL_UNIT(1.0) : cosine;
}

struct direction mirror_direction(struct direction d, real_unit cosine, struct direction normal) {
    struct direction mirrored = {unit_mirrored(d.x, cosine, normal.x),
                                 unit_mirrored(d.y, cosine, normal.y),
                                 unit_mirrored(d.z, cosine, normal.z)};
    return mirrored;
}

real_energy fresnel_reflectance(real_unit incident, real_unit refracted, real_index n) {
    real_index ci = index_of_unit(incident);
    real_index cr = index_of_unit(refracted);
    real_index n_ci = index_scaled(n, incident);
    real_index n_cr = index_scaled(n, refracted);
    real_energy s = energy_ratio(index_subtract(ci, n_cr), index_add(ci, n_cr));
    real_energy p = energy_ratio(index_subtract(n_ci, cr), index_add(n_ci, cr));
    return energy_mean_square(s, p);
}

struct split optics_transparent(const struct material *before, const struct material *after,
                                struct direction d, struct direction normal) {
    struct split split;
    real_unit cosine = incidence_cosine(d, normal);
    split.mirrored = mirror_direction(d, cosine, normal);
    split.refracted = d;
    if (before->optical == after->optical) {
        split.reflectance = REAL_ENERGY(0.0);
        split.transmittance = REAL_ENERGY(1.0);
        return split;
    }
    real_index eta = index_product(before->ior, after->inverse_ior);
    real_unit refracted;
    if (!unit_refracted_cosine(cosine, eta, &refracted)) {
        split.reflectance = REAL_ENERGY(1.0);
        split.transmittance = REAL_ENERGY(0.0);
        return split;
    }
    real_index bend = index_bend(eta, cosine, refracted);
    split.refracted.x = unit_bent(d.x, eta, bend, normal.x);
    split.refracted.y = unit_bent(d.y, eta, bend, normal.y);
    split.refracted.z = unit_bent(d.z, eta, bend, normal.z);
    real_index n = index_product(after->ior, before->inverse_ior);
    split.reflectance = fresnel_reflectance(cosine, refracted, n);
    split.transmittance = energy_complement(split.reflectance);
    return split;
}
