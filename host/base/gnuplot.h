/* SPDX-License-Identifier: MIT */
/* Runs gnuplot, where it is installed. */
#ifndef SUPERFRAME_GNUPLOT_H
#define SUPERFRAME_GNUPLOT_H

enum gnuplot_status { GNUPLOT_DONE, GNUPLOT_NOT_FOUND, GNUPLOT_FAILED };

/* Runs a script in its folder, and waits for it. */
enum gnuplot_status gnuplot_run(const char *folder, const char *script);

/* Says which plots are left out, where gnuplot did not draw a script. */
void gnuplot_complain(enum gnuplot_status status, const char *script, const char *plots);

#endif
