/* SPDX-License-Identifier: MIT */
/* Fig. 7 as a table, as a script for gnuplot, and by gnuplot as plots. */
#include <unistd.h>

#include "base/complain.h"
#include "base/gnuplot.h"
#include "base/interrupt.h"
#include "lab/paper/curves.h"

static const char data_name[] = "fig7.csv", script_name[] = "fig7.gp";
static const char *const plot_names[PAPER_COSTS] = {"fig7-rays.png", "fig7-tests.png"};

/* Writes a table of N and, for each curve and each cost, the counts. */
static int write_data(const struct paper *paper) {
    FILE *file = paper_create(paper, data_name);
    if (file == NULL) {
        return STATUS_FAILED;
    }
    (void)fputs("N", file);
    for (int i = 0; i < PAPER_CURVES; i++) {
        (void)fprintf(file, ",%s rays,%s solid tests", paper->curves[i].scene,
                      paper->curves[i].scene);
    }
    for (int depth = 0; depth < PAPER_DEPTHS; depth++) {
        (void)fprintf(file, "\n%d", depth);
        for (int i = 0; i < PAPER_CURVES; i++) {
            (void)fprintf(file, ",%.0f,%.0f", paper->curves[i].rays[depth],
                          paper->curves[i].tests[depth]);
        }
    }
    (void)fputs("\n", file);
    return paper_close(file, data_name);
}

static void write_curve(FILE *file, const struct paper *paper, int i, enum paper_cost cost) {
    const struct paper_curve *curve = &paper->curves[i];
    const struct paper_fit ratio = paper_fit_curve(curve, cost, PAPER_READING_RATIO);
    const struct paper_fit log = paper_fit_curve(curve, cost, PAPER_READING_LOG);
    (void)fprintf(file, "    '%s' using 1:($%d/%.1f) with points pt %d lc %d title '%s', \\\n",
                  data_name, 2 + 2 * i + (int)cost, paper_costs(curve, cost)[0], 5 + 2 * i, i + 1,
                  curve->label);
    (void)fprintf(file,
                  "    log10(%d*x**%d+1)+1 lc %d dt 1 title '(i) C1 = %d, C2 = %d', \\\n"
                  "    %d*x**%d+1 lc %d dt 2 title '(ii) C1 = %d, C2 = %d', \\\n",
                  ratio.c1, ratio.c2, i + 1, ratio.c1, ratio.c2, log.c1, log.c2, i + 1, log.c1,
                  log.c2);
}

static double highest(const struct paper *paper, enum paper_cost cost) {
    double most = 1;
    for (int i = 0; i < PAPER_CURVES; i++) {
        const double *costs = paper_costs(&paper->curves[i], cost);
        for (int depth = 0; paper->curves[i].is_made && depth < PAPER_DEPTHS; depth++) {
            most = costs[depth] / costs[0] > most ? costs[depth] / costs[0] : most;
        }
    }
    return most;
}

static int write_script(const struct paper *paper) {
    FILE *file = paper_create(paper, script_name);
    if (file == NULL) {
        return STATUS_FAILED;
    }
    (void)fputs("# Fig. 7 of the paper, from fig7.csv: gnuplot fig7.gp\n"
                "set terminal pngcairo size 1000,700\n"
                "set datafile separator ','\n"
                "set key below horizontal maxcols 3 Left reverse samplen 2\n"
                "set xlabel 'depth level N'\n"
                "set xrange [0:16.5]\n"
                "set samples 331\n"
                "set grid\n",
                file);
    for (int cost = 0; cost < PAPER_COSTS; cost++) {
        (void)fprintf(file,
                      "set output '%s'\n"
                      "set ylabel 'relative cost, T(N)/T(0), in %s'\n"
                      "set yrange [0:%.3f]\n"
                      "plot \\\n",
                      plot_names[cost], paper_cost_name((enum paper_cost)cost),
                      1.1 * highest(paper, (enum paper_cost)cost));
        for (int i = 0; i < PAPER_CURVES; i++) {
            if (paper->curves[i].is_made) {
                write_curve(file, paper, i, (enum paper_cost)cost);
            }
        }
        (void)fputs("    NaN notitle\n", file);
    }
    return paper_close(file, script_name);
}

static void remove_plots(const struct paper *paper) {
    for (int i = 0; i < PAPER_COSTS; i++) {
        char path[4096];
        (void)snprintf(path, sizeof path, "%s/%s", paper->folder, plot_names[i]);
        (void)unlink(path);
    }
}

int paper_write_plots(struct paper *paper) {
    if (write_data(paper) != STATUS_DONE || write_script(paper) != STATUS_DONE) {
        return STATUS_FAILED;
    }
    enum gnuplot_status drawn = gnuplot_run(paper->folder, script_name);
    paper->has_plots = drawn == GNUPLOT_DONE;
    if (drawn != GNUPLOT_DONE) {
        remove_plots(paper);
    }
    gnuplot_complain(drawn, script_name, "the plots of Fig. 7");
    if (*interrupt_noted() != 0) {
        complain("interrupted; nothing was written");
        return STATUS_SIGNAL + *interrupt_noted();
    }
    return STATUS_DONE;
}
