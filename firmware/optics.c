/* SPDX-License-Identifier: MIT */
/* Snell's law, in cosines throughout, and w(theta). */
#include "optics.h"

void optics_passage(const struct material *before, const struct material *after, uint8_t channel,
                    const struct direction *d, real_unit cosine, const struct direction *normal,
                    struct passage *passage) {
    if (before->optical == after->optical) {
        passage->refracted = *d;
        passage->reflectance = REAL_ENERGY(0.0);
        passage->transmittance = REAL_ENERGY(1.0);
        return;
    }
    real_index eta = index_product(before->ior[channel], after->inverse_ior[channel]);
    real_unit refracted;
    if (!unit_refracted_cosine(cosine, eta, &refracted)) {
        passage->refracted = *d;
        passage->reflectance = REAL_ENERGY(1.0);
        passage->transmittance = REAL_ENERGY(0.0);
        return;
    }
    real_index bend = index_bend(eta, cosine, refracted);
    passage->refracted.x = unit_bent(d->x, eta, bend, normal->x);
    passage->refracted.y = unit_bent(d->y, eta, bend, normal->y);
    passage->refracted.z = unit_bent(d->z, eta, bend, normal->z);
    real_index n = index_product(after->ior[channel], before->inverse_ior[channel]);
    passage->reflectance = fresnel_reflectance(cosine, refracted, n);
    passage->transmittance = energy_complement(passage->reflectance);
}

real_energy specular_at(const struct scene *scene, const struct material *material,
                        real_unit cosine) {
    if (!FEATURE_SPECULAR_TABLE || material->specular_table == SPECULAR_CONSTANT) {
        return material->specular;
    }
    const struct specular_table *table = &scene->specular_tables[material->specular_table];
    uint8_t i = 0;
    while (i < SPECULAR_STEPS - 2 && unit_less(cosine, table->cosine[i + 1])) {
        i++;
    }
    real_index low = index_of_unit(table->cosine[i + 1]);
    real_energy share = energy_ratio(index_subtract(index_of_unit(cosine), low),
                                     index_subtract(index_of_unit(table->cosine[i]), low));
    return energy_add(energy_product(table->specular[i], share),
                      energy_product(table->specular[i + 1], energy_complement(share)));
}
