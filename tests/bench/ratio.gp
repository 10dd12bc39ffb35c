# SPDX-License-Identifier: MIT
# POV-Ray's user CPU over ours, with spread: gnuplot -e "folder='...'; arithmetics='fx f64'" ratio.gp
set terminal pngcairo size 900,460 font "sans,11"
set output folder."/ratio.png"
set title "User CPU: POV-Ray over superframe, 640 x 400, the same N and threshold; median, least and largest"
set ylabel "times as fast"
set logscale y
set grid ytics
set key outside right
set offsets 0.5, 0.5, 0, 0
place(i) = (i - (words(arithmetics) + 1) / 2.0) * 0.15
plot for [i = 1:words(arithmetics)] folder."/ratio-".word(arithmetics, i).".dat" \
    using ($0 + place(i)):2:3:4:xticlabels(1) with yerrorbars lw 2 pt 7 title word(arithmetics, i), \
    1 with lines lc "grey" dt 2 notitle
