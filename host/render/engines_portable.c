/* SPDX-License-Identifier: MIT */
/* The stream engines of a host of which nothing more is known. */
#include "render/engines.h"

extern const struct stream_engine stream_f32_plain, stream_f64_plain, stream_fx_plain;

const struct engine_choice engine_choices[] = {{"f32", &stream_f32_plain, NULL},
                                               {"f64", &stream_f64_plain, NULL},
                                               {"fx", &stream_fx_plain, NULL},
                                               {NULL, NULL, NULL}};
