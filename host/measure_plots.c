/* SPDX-License-Identifier: MIT */
/* The plots of `superframe measure`: data and script for gnuplot, and by gnuplot the pictures. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "gnuplot.h"
#include "interrupt.h"
#include "measure.h"

/* Nothing wrong at all is shown at the foot of the logarithmic scale. */
static const double least_shown = 0.001;

static const char *const arithmetics[] = {"fx", "f32", "f64", "q16", "q16_epsilon", NULL};

static double shown(double wrong) {
    return wrong < least_shown ? least_shown : wrong;
}

/* Thresholds of which there is a curve; 0: none. */
static const double thresholds[] = {0, 1.0 / 256, 1.0 / 1024, 1.0 / 4096, 1.0 / 16384};
enum { CURVES = sizeof thresholds / sizeof thresholds[0], CURVE_DEPTH = 64 };

/* Wrong against depth in the first arithmetic, for each threshold. */
static void write_depth_curves(FILE *file, const struct measure_settings *settings) {
    for (int t = 0; t < CURVES; t++) {
        (void)fprintf(file, "# [depth-%d]\n", t);
        for (size_t i = 0; i < settings->count; i++) {
            const struct measure_setting *setting = &settings->settings[i];
            if (strcmp(setting->arithmetic, settings->settings[0].arithmetic) == 0 &&
                strcmp(setting->tail, settings->settings[0].tail) == 0 &&
                fabs(setting->threshold - thresholds[t]) < 1e-9) {
                (void)fprintf(file, "%u %.6f\n", setting->depth, shown(setting->wrong));
            }
        }
        (void)fputs("\n\n", file);
    }
}

/* Wrong against threshold at one depth, for each arithmetic. */
static void write_threshold_curves(FILE *file, const struct measure_settings *settings,
                                   const char *tail) {
    for (int a = 0; arithmetics[a] != NULL; a++) {
        (void)fprintf(file, "# [threshold-%s-%s]\n", tail, arithmetics[a]);
        for (size_t i = 0; i < settings->count; i++) {
            const struct measure_setting *setting = &settings->settings[i];
            if (strcmp(setting->arithmetic, arithmetics[a]) == 0 &&
                strcmp(setting->tail, tail) == 0 && setting->depth == CURVE_DEPTH &&
                setting->threshold > 0) {
                (void)fprintf(file, "%.9g %.6f\n", setting->threshold, shown(setting->wrong));
            }
        }
        (void)fputs("\n\n", file);
    }
}

/* Blocks that gnuplot finds by name: for each arithmetic its settings (depth, threshold, per cent
 * wrong, seconds by machine), for each machine its front (seconds, per cent wrong). */
static int write_data(const struct measure *measure, const struct measure_settings *settings) {
    FILE *file = measure_create(measure, "plots.dat");
    if (file == NULL) {
        return STATUS_FAILED;
    }
    for (int a = 0; arithmetics[a] != NULL; a++) {
        (void)fprintf(file, "# [%s]\n", arithmetics[a]);
        for (size_t i = 0; i < settings->count; i++) {
            const struct measure_setting *setting = &settings->settings[i];
            if (strcmp(setting->arithmetic, arithmetics[a]) != 0) {
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
    return measure_close(measure, file, "plots.dat");
}

static bool has(const struct measure_settings *settings, const char *arithmetic, size_t target) {
    for (size_t i = 0; i < settings->count; i++) {
        if (strcmp(settings->settings[i].arithmetic, arithmetic) == 0 &&
            !isnan(settings->settings[i].seconds[target])) {
            return true;
        }
    }
    return false;
}

static void write_fronts(FILE *file, const struct measure_settings *settings) {
    (void)fputs("set logscale x\nset format x '%g'\nset xlabel 'seconds for one picture, "
                "predicted'\n",
                file);
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        (void)fprintf(file, "set output 'pareto-%s.png'\nset title '%s'\nplot \\\n",
                      cost_targets[j].name, cost_targets[j].label);
        for (int a = 0; arithmetics[a] != NULL; a++) {
            if (has(settings, arithmetics[a], j)) {
                (void)fprintf(file,
                              "    'plots.dat' index '[%s]' using %zu:3 with points pt 7 ps 0.9 lc "
                              "%d title '%s', \\\n",
                              arithmetics[a], 4 + j, a + 1, arithmetics[a]);
            }
        }
        (void)fprintf(
            file,
            "    'plots.dat' index '[front-%s]' using 1:2 smooth unique with lines lc 0 lw "
            "1.5 title 'worth their time'\n",
            cost_targets[j].name);
    }
}

static bool has_curve(const struct measure_settings *settings, double threshold) {
    for (size_t i = 0; i < settings->count; i++) {
        if (fabs(settings->settings[i].threshold - threshold) < 1e-9) {
            return true;
        }
    }
    return false;
}

static bool is_deep(const struct measure_settings *settings, const char *arithmetic,
                    const char *tail) {
    for (size_t i = 0; i < settings->count; i++) {
        if (strcmp(settings->settings[i].arithmetic, arithmetic) == 0 &&
            strcmp(settings->settings[i].tail, tail) == 0 &&
            settings->settings[i].depth == CURVE_DEPTH && settings->settings[i].threshold > 0) {
            return true;
        }
    }
    return false;
}

/* Of one arithmetic against depth, one for each threshold; and of all against threshold. */
static void write_curves(FILE *file, const struct measure_settings *settings) {
    static const char *const names[CURVES] = {"none", "1/256", "1/1024", "1/4096", "1/16384"};
    (void)fprintf(file,
                  "set output 'error-depth.png'\nset title '%s'\nset xlabel 'depth level N'\n"
                  "set logscale x 2\nplot \\\n",
                  settings->settings[0].arithmetic);
    for (int i = 0; i < CURVES; i++) {
        if (has_curve(settings, thresholds[i])) {
            (void)fprintf(file,
                          "    'plots.dat' index '[depth-%d]' using 1:2 smooth unique with "
                          "linespoints pt 7 lc %d title 'threshold %s', \\\n",
                          i, i + 1, names[i]);
        }
    }
    (void)fprintf(file,
                  "    2000 notitle\nset output 'error-threshold.png'\n"
                  "set title 'depth level %d'\nset xlabel 'threshold'\nset xrange [*:*] reverse\n"
                  "set xtics ('1/256' 1./256, '1/1024' 1./1024, '1/4096' 1./4096, '1/16384' "
                  "1./16384, '1/65536' 1./65536)\nplot \\\n",
                  CURVE_DEPTH);
    for (int a = 0; arithmetics[a] != NULL; a++) {
        for (int t = 0; t < 2; t++) {
            const char *tail = t == 0 ? "black" : "estimate";
            if (is_deep(settings, arithmetics[a], tail)) {
                (void)fprintf(file,
                              "    'plots.dat' index '[threshold-%s-%s]' using 1:2 smooth unique "
                              "with linespoints dt %d pt %d ps 1.2 lc %d title '%s, %s', \\\n",
                              tail, arithmetics[a], t + 1, 4 + a, a + 1, arithmetics[a], tail);
            }
        }
    }
    (void)fputs("    2000 notitle\n", file);
}

static int write_script(const struct measure *measure, const struct measure_settings *settings) {
    FILE *file = measure_create(measure, "plots.gp");
    if (file == NULL) {
        return STATUS_FAILED;
    }
    (void)fprintf(file,
                  "# From plots.dat: gnuplot plots.gp\n"
                  "set terminal pngcairo size 800,500\nset grid\nset logscale y\n"
                  "set key outside right top samplen 2 noenhanced\nset title noenhanced\n"
                  "set ylabel 'pixels off by more than 1 LSB, per cent (0.001: none)'\n"
                  "set yrange [%g:100]\nset datafile missing 'nan'\n",
                  0.8 * least_shown);
    write_fronts(file, settings);
    if (settings->count > 0) {
        write_curves(file, settings);
    }
    return measure_close(measure, file, "plots.gp");
}

int measure_plot(struct measure *measure) {
    struct measure_settings settings;
    if (!measure_settings(measure, &settings)) {
        complain("out of memory");
        return STATUS_FAILED;
    }
    int status = write_data(measure, &settings);
    if (status == STATUS_DONE) {
        status = write_script(measure, &settings);
    }
    free(settings.settings);
    if (status != STATUS_DONE) {
        return status;
    }
    enum gnuplot_status drawn = gnuplot_run(measure->folder, "plots.gp");
    measure->has_plots = drawn == GNUPLOT_DONE;
    if (drawn == GNUPLOT_NOT_FOUND) {
        complain(
            "gnuplot is not there: the plots are left out; install it (Debian: apt-get install "
            "gnuplot-nox), or draw plots.gp later");
    } else if (drawn == GNUPLOT_FAILED) {
        complain("gnuplot could not draw plots.gp: the plots are left out");
    }
    if (*interrupt_noted() != 0) {
        complain("interrupted; started again with the same -o it goes on where it was");
        return STATUS_SIGNAL + *interrupt_noted();
    }
    return STATUS_DONE;
}
