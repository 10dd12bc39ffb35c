# SPDX-License-Identifier: MIT
# POV-Ray's user CPU over ours, with spread: gnuplot -e "folder='...'; arithmetics='fx f64'" ratio.gp
set terminal pngcairo size 900,480 font "sans,11"
set output folder."/ratio.png"
set title "POV-Ray's user CPU over superframe's, 640 x 400, same N and threshold\nmedian, least and largest of the pairs"
set ylabel "times as fast"
set logscale y
set yrange [*<0.8:12<*]
set grid ytics mytics
set key outside right
set bmargin 4
set offsets 0.5, 0.5, 0, 0
place(i) = (i - (words(arithmetics) + 1) / 2.0) * 0.12
file(i) = folder."/ratio-".word(arithmetics, i).".dat"
# The labels come once, with points that are not drawn.
plot file(1) using 0:2:xticlabels(1) with points ps 0 notitle, \
    for [i = 1:words(arithmetics)] file(i) using ($0 + place(i)):2:3:4 with yerrorbars lw 2 pt 7 \
    title word(arithmetics, i), \
    1 with lines lc "grey" dt 2 notitle
