# SPDX-License-Identifier: MIT
# Nanoseconds a ray against N: gnuplot -e "folder='...'; arithmetics='fx f64'" rays.gp
set terminal pngcairo size 720,420 font "sans,11"
set output folder."/rays.png"
set title "fig4a, 640 x 400: user CPU a ray"
set xlabel "depth level N"
set xrange [0:21]
set ylabel "nanoseconds a ray"
set yrange [0:*]
set grid ytics
set key outside right
plot for [a in arithmetics] folder."/rays-".a.".dat" using 1:2 with linespoints lw 2 title a
