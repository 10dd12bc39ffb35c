/* SPDX-License-Identifier: MIT */
/* The plots of `superframe measure`: data and script for gnuplot, and by gnuplot the pictures. */
#include <math.h>
#include <string.h>

#include "base/complain.h"
#include "base/gnuplot.h"
#include "base/interrupt.h"
#include "lab/measure/measure.h"

/* Per cent. Smaller values, 0 too, are shown at the foot of the logarithmic scale. */
static const double least_shown = 0.001;

static const char *const arithmetics[] = {"fx", "f32", "f64", "q16", "q16_epsilon", NULL};

/* The colour of each arithmetic, and of each curve. */
static const char *const colours[] = {"#7b1fa2", "#00897b", "#1e88e5", "#ef6c00", "#c62828"};

static double shown(double wrong) {
    return wrong < least_shown ? least_shown : wrong;
}

/* Thresholds of which there is a curve; 0: none. */
static const double thresholds[] = {0, 1.0 / 256, 1.0 / 1024, 1.0 / 4096, 1.0 / 16384};
enum { CURVES = sizeof thresholds / sizeof thresholds[0], CURVE_DEPTH = 64 };

/* Tells whether a setting is on the curve of a threshold against depth. Such curves are of the
 * first setting's arithmetic and tail. */
static bool is_on_depth_curve(const struct measure_settings *settings,
                              const struct measure_setting *setting, double threshold) {
    const struct measure_setting *first = &settings->settings[0];
    return strcmp(setting->arithmetic, first->arithmetic) == 0 &&
           strcmp(setting->tail, first->tail) == 0 && !(setting->error > 0) &&
           fabs(setting->threshold - threshold) < 1e-9;
}

static void write_depth_curves(FILE *file, const struct measure_settings *settings) {
    for (int t = 0; t < CURVES; t++) {
        (void)fprintf(file, "# [depth-%d]\n", t);
        for (size_t i = 0; i < settings->count; i++) {
            const struct measure_setting *setting = &settings->settings[i];
            if (is_on_depth_curve(settings, setting, thresholds[t])) {
                (void)fprintf(file, "%u %.6f\n", setting->depth, shown(setting->wrong));
            }
        }
        (void)fputs("\n\n", file);
    }
}

/* Tells whether a setting is on the curve of an arithmetic and a tail against threshold. */
static bool is_on_threshold_curve(const struct measure_setting *setting, const char *arithmetic,
                                  const char *tail) {
    return strcmp(setting->arithmetic, arithmetic) == 0 && strcmp(setting->tail, tail) == 0 &&
           setting->depth == CURVE_DEPTH && setting->threshold > 0;
}

/* Writes per cent wrong against threshold with one tail, for each arithmetic. */
static void write_threshold_curves(FILE *file, const struct measure_settings *settings,
                                   const char *tail) {
    for (int a = 0; arithmetics[a] != NULL; a++) {
        (void)fprintf(file, "# [threshold-%s-%s]\n", tail, arithmetics[a]);
        for (size_t i = 0; i < settings->count; i++) {
            const struct measure_setting *setting = &settings->settings[i];
            if (is_on_threshold_curve(setting, arithmetics[a], tail)) {
                (void)fprintf(file, "%.9g %.6f\n", setting->threshold, shown(setting->wrong));
            }
        }
        (void)fputs("\n\n", file);
    }
}

/* How a branch's end is decided and counted: what a mark's shape tells. */
static const char *const ends[] = {"black", "estimate", "--error"};
enum { ENDS = sizeof ends / sizeof ends[0] };

static bool has_end(const struct measure_setting *setting, int end) {
    return end == 2 ? setting->error > 0
                    : !(setting->error > 0) && strcmp(setting->tail, ends[end]) == 0;
}

/* Writes the settings of an arithmetic and one way to end a branch. Columns: depth, threshold, per
 * cent wrong, seconds by machine. */
static void write_marks(FILE *file, const struct measure_settings *settings, int arithmetic,
                        int end) {
    (void)fprintf(file, "# [%s-%d]\n", arithmetics[arithmetic], end);
    for (size_t i = 0; i < settings->count; i++) {
        const struct measure_setting *setting = &settings->settings[i];
        if (strcmp(setting->arithmetic, arithmetics[arithmetic]) != 0 || !has_end(setting, end)) {
            continue;
        }
        (void)fprintf(file, "%u %.9g %.6f", setting->depth, setting->threshold,
                      shown(setting->wrong));
        for (size_t j = 0; cost_targets[j].name != NULL; j++) {
            (void)fprintf(file, " %.6g", setting->seconds[j]);
        }
        (void)fputs("\n", file);
    }
    (void)fputs("\n\n", file);
}

/* Writes blocks that gnuplot finds by name: the marks, the curves, each machine's front (seconds,
 * per cent wrong). */
static int write_data(const struct measure *measure, const struct measure_settings *settings) {
    struct measure_file data;
    if (!measure_create(&data, measure, "plots.dat")) {
        return STATUS_FAILED;
    }
    FILE *file = data.output.file;
    for (int a = 0; arithmetics[a] != NULL; a++) {
        for (int end = 0; end < ENDS; end++) {
            write_marks(file, settings, a, end);
        }
    }
    write_depth_curves(file, settings);
    write_threshold_curves(file, settings, "black");
    write_threshold_curves(file, settings, "estimate");
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        (void)fprintf(file, "# [front-%s]\n", cost_targets[j].name);
        for (size_t i = 0; i < settings->count; i++) {
            if (measure_is_on_front(settings, i, j)) {
                (void)fprintf(file, "%.6g %.6f\n", settings->settings[i].seconds[j],
                              shown(settings->settings[i].wrong));
            }
        }
        (void)fputs("\n\n", file);
    }
    return measure_close(&data);
}

static bool has(const struct measure_settings *settings, int arithmetic, int end, size_t target) {
    bool is_there = false;
    for (size_t i = 0; i < settings->count && !is_there; i++) {
        const struct measure_setting *setting = &settings->settings[i];
        is_there = strcmp(setting->arithmetic, arithmetics[arithmetic]) == 0 &&
                   has_end(setting, end) && !isnan(setting->seconds[target]);
    }
    return is_there;
}

/* Finds the powers of ten between which a machine's seconds lie. Returns false where the machine
 * has none. */
static bool find_decades(const struct measure_settings *settings, size_t target, int decades[2]) {
    double least = INFINITY, most = 0;
    for (size_t i = 0; i < settings->count; i++) {
        least = fmin(least, settings->settings[i].seconds[target]); /* fmin() passes over NaN */
        most = fmax(most, settings->settings[i].seconds[target]);
    }
    if (!(least > 0 && least <= most)) {
        return false;
    }
    decades[0] = (int)floor(log10(least));
    decades[1] = (int)floor(log10(most)) + 1;
    return true;
}

/* Writes the plots of time against error, one for each machine. Each arithmetic has a colour, each
 * way to end a branch a shape. */
static void write_fronts(FILE *file, const struct measure_settings *settings) {
    static const int shapes[ENDS] = {7, 9, 5};
    static const char *const words[ENDS] = {"tail black", "tail estimate", "--error"};
    (void)fputs("set logscale x\nset format x '%g'\nset xlabel 'seconds for one picture, "
                "predicted'\n",
                file);
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        int decades[2];
        if (!find_decades(settings, j, decades)) {
            continue;
        }
        (void)fprintf(
            file, "set output 'pareto-%s.png'\nset title '%s'\nset xrange [1e%d:1e%d]\nplot \\\n",
            cost_targets[j].name, cost_targets[j].label, decades[0], decades[1]);
        for (int i = 0; arithmetics[i / ENDS] != NULL; i++) {
            int a = i / ENDS, end = i % ENDS;
            if (has(settings, a, end, j)) {
                (void)fprintf(file,
                              "    'plots.dat' index '[%s-%d]' using %zu:3 with points pt %d ps "
                              "1.1 lc rgb '%s' title '%s, %s', \\\n",
                              arithmetics[a], end, 4 + j, shapes[end], colours[a], arithmetics[a],
                              words[end]);
            }
        }
        (void)fprintf(file,
                      "    'plots.dat' index '[front-%s]' using 1:2 smooth unique with lines lc 0 "
                      "lw 1.5 title 'worth their time'\n",
                      cost_targets[j].name);
    }
}

static bool has_curve(const struct measure_settings *settings, double threshold) {
    bool is_there = false;
    for (size_t i = 0; i < settings->count && !is_there; i++) {
        is_there = is_on_depth_curve(settings, &settings->settings[i], threshold);
    }
    return is_there;
}

static bool is_deep(const struct measure_settings *settings, const char *arithmetic,
                    const char *tail) {
    bool is_there = false;
    for (size_t i = 0; i < settings->count && !is_there; i++) {
        is_there = is_on_threshold_curve(&settings->settings[i], arithmetic, tail);
    }
    return is_there;
}

/* Writes the plot against depth for one arithmetic, with a curve for each threshold. */
static void write_curves_by_depth(FILE *file, const struct measure_settings *settings) {
    static const char *const names[CURVES] = {"none", "1/256", "1/1024", "1/4096", "1/16384"};
    (void)fprintf(file,
                  "set output 'error-depth.png'\nset title 'More depth, by threshold (arithmetic "
                  "%s)'\nset xlabel 'depth level N: reflections and refractions on a path'\n"
                  "set logscale x 2\nset xrange [1:64]\nplot \\\n",
                  settings->settings[0].arithmetic);
    for (int i = 0; i < CURVES; i++) {
        if (has_curve(settings, thresholds[i])) {
            (void)fprintf(file,
                          "    'plots.dat' index '[depth-%d]' using 1:2 smooth unique with "
                          "linespoints pt 7 lc rgb '%s' title 'threshold %s', \\\n",
                          i, colours[i], names[i]);
        }
    }
    (void)fputs("    2000 notitle\n", file);
}

/* Writes the plot against threshold for all arithmetics, at one depth; nothing where that depth was
 * not measured. */
static void write_curves_by_threshold(FILE *file, const struct measure_settings *settings) {
    static const char *const tails[] = {"black", "estimate"};
    bool has_begun = false;
    for (int i = 0; arithmetics[i / 2] != NULL; i++) {
        int a = i / 2, tail = i % 2;
        if (!is_deep(settings, arithmetics[a], tails[tail])) {
            continue;
        }
        if (!has_begun) {
            (void)fprintf(file,
                          "set output 'error-threshold.png'\nset title 'A lower threshold, at "
                          "depth level %d'\nset xlabel 'threshold: the share of the light under "
                          "which a branch ends'\nset xrange [1./200:1./80000]\n"
                          "set xtics ('1/256' 1./256, '1/1024' 1./1024, '1/4096' 1./4096, "
                          "'1/16384' 1./16384, '1/65536' 1./65536)\nplot \\\n",
                          CURVE_DEPTH);
        }
        has_begun = true;
        (void)fprintf(file,
                      "    'plots.dat' index '[threshold-%s-%s]' using 1:2 smooth unique with "
                      "linespoints dt %d pt %d ps %.1f lc rgb '%s' title '%s, tail %s', \\\n",
                      tails[tail], arithmetics[a], tail + 1, 4 + a, 2.2 - 0.4 * a, colours[a],
                      arithmetics[a], tails[tail]);
    }
    (void)fputs(has_begun ? "    2000 notitle\n" : "", file);
}

/* Returns the lower end of the scale of errors, per cent. */
static double lowest_shown(const struct measure_settings *settings) {
    double lowest = 1;
    for (size_t i = 0; i < settings->count; i++) {
        lowest = fmin(lowest, shown(settings->settings[i].wrong));
    }
    return 0.8 * lowest;
}

static int write_script(const struct measure *measure, const struct measure_settings *settings) {
    struct measure_file script;
    if (!measure_create(&script, measure, "plots.gp")) {
        return STATUS_FAILED;
    }
    FILE *file = script.output.file;
    (void)fprintf(
        file,
        "# From plots.dat: gnuplot plots.gp\n"
        "set terminal pngcairo size 800,600\nset grid\nset logscale y\n"
        "set bmargin 9\nset key below horizontal samplen 2 noenhanced\nset title noenhanced\n"
        "set ylabel 'wrong pixels, per cent'\nset format y '%%g'\n"
        "set yrange [%g:100]\nset datafile missing 'nan'\n",
        lowest_shown(settings));
    write_fronts(file, settings);
    if (settings->count > 0) {
        write_curves_by_depth(file, settings);
        write_curves_by_threshold(file, settings);
    }
    return measure_close(&script);
}

int measure_plot(struct measure *measure) {
    if (write_data(measure, &measure->settings) != STATUS_DONE ||
        write_script(measure, &measure->settings) != STATUS_DONE) {
        return STATUS_FAILED;
    }
    enum gnuplot_status drawn = gnuplot_run(measure->folder, "plots.gp");
    gnuplot_complain(drawn, "plots.gp", "the plots");
    return *interrupt_noted() != 0 ? measure_interrupted() : STATUS_DONE;
}
