/* SPDX-License-Identifier: MIT */
/* A scene with every key of the format, for the tests of the scene reader. */
#ifndef SUPERFRAME_TESTS_SCENE_READER_EXAMPLE_H
#define SUPERFRAME_TESTS_SCENE_READER_EXAMPLE_H

/* A line here is a line of the file, and the tests count them. */
/* clang-format off */
static const char SCENE_EXAMPLE[] =
    "version = 1;\n"                                                     /* 1 */
    "title = \"A \\\"test\\\"\"; # words\n"
    "size = [64, 40];\n"
    "depth = 3;\n"
    "threshold = 0.25;\n"
    "model = \"wavelength\";\n"
    "highlight = \"blinn\";\n"
    "mixing = \"filter\";\n"
    "colour = \"bits:4\";\n"
    "background = [1, 2, 3];\n"                                          /* 10 */
    "ambient = (4, 5.5, 6L); // mixed\n"
    "attenuation = { constant = 2; };\n"
    "wavelengths = (650, 550, 450);\n"
    "camera = {\n"
    "    eye = [0.0, -10.0, 3.0];\n"
    "    look_at = [0, 0, 0];\n"
    "    up = (0, 1, 1.0);\n"
    "    field_of_view = 30.5;\n"
    "};\n"
    "lights = (\n"                                                       /* 20 */
    "    { position = [1, 2, 3]; colour = [300, 200, 100]; },\n"
    "    { direction = [0, 0, -2]; }\n"
    ");\n"
    "materials = {\n"
    "    glass = {\n"
    "        colour = [0, 32, 64]; ambient = 0.5; ambient_is_own = true;\n"
    "        diffuse = 0.3; specular = 0.2; gloss = 70;\n"
    "        ior = (1.5, 1.51, 1.53); transmittance = 0.9;\n"
    "        reflectance_factors = 0.75; transmittance_factors = (1, 0.5, 0);\n"
    "        absorption = 0.125; casts_shadow = true;\n"                 /* 30 */
    "    };\n"
    "    flint = { colour = [1, 1, 1]; cauchy = (1.5, 0.0121); };\n"
    "    floor = {\n"
    "        colour = [200, 200, 200];\n"
    "        specular = (0, 0.1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1);\n"
    "        pattern = { size = (0.5, 0, 2); origin = [1, 2, 3]; colour = [9, 8, 7]; };\n"
    "    };\n"
    "};\n"
    "parts = (\n"
    "    { name = \"shell\"; solid = {\n"                                /* 40 */
    "        difference = (\n"
    "            { ball = { centre = [1, 2, 3]; radius = 4; }; },\n"
    "            { ball = { radius = 3.5; }; }\n"
    "        );\n"
    "    }; },\n"
    "    { name = \"pair\"; solid = {\n"
    "        union = (\n"
    "            { part = \"shell\"; },\n"
    "            { part = \"shell\"; translate = [0, 0, 9]; material = \"flint\"; }\n"
    "        );\n"                                                       /* 50 */
    "    }; }\n"
    ");\n"
    "/* objects of\n"
    "   every kind */\n"
    "objects = (\n"
    "    { name = \"pairs\"; material = \"glass\"; solid = { part = \"pair\"; }; },\n"
    "    { solid = { material = \"floor\"; box = { min = [-1, -2, -3]; max = [1, 2, 3]; };\n"
    "        scale = 2; rotate = [0, 0, 90]; translate = [10, 20, 30]; }; },\n"
    "    { material = \"glass\"; solid = { intersection = (\n"
    "        { cylinder = { from = [0, 0, 0]; to = [0, 0, 5]; radius = 2; }; },\n" /* 60 */
    "        { cone = { from = [0, 0, 0]; to = [0, 0, 5]; from_radius = 2; to_radius = 1; }; },\n"
    "        { ellipsoid = { centre = [1, 1, 1]; radii = [3, 4, 5]; }; },\n"
    "        { paraboloid = { from = [0, 0, 0]; to = [0, 0, 5]; radius = 2; }; },\n"
    "        { hyperboloid = { from = [0, 0, 0]; to = [0, 0, 5]; waist = 1; radius = 2; }; },\n"
    "        { hyperboloid = { from = [0, 0, 0]; to = [0, 0, 5]; gap = 1; radius = 2; }; },\n"
    "        { quadric = { coefficients = [1, 2, 3, 4, 5, 6, 7, 8, 9, -10]; }; },\n"
    "        { half_space = { normal = [0, 0, 2]; offset = 5; }; },\n"
    "        { polyhedron = { planes = (\n"
    "            { normal = [-1, 0, 0]; offset = 0; },\n"
    "            { normal = [0, -1, 0]; offset = 0; },\n"                /* 70 */
    "            { normal = [0, 0, -1]; offset = 0; },\n"
    "            { normal = [3, 0, 4]; through = [1, 5, 2]; }\n"
    "        ); }; }\n"
    "    ); }; }\n"
    ");\n";
/* clang-format on */

#endif
