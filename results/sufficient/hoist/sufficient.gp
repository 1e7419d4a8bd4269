# Physical error of models of a scene against the time they save.
# To restyle: edit, then gnuplot sufficient.gp > sufficient.svg
DATA = 'sufficient.dat'
set terminal svg size 1031,404 enhanced background '#ffffff' font 'sans-serif,12'
set datafile missing NaN
set multiplot
COLOURS = '0x0072B2 0xD55E00 0x009E73 0xCC79A7 0xE69F00 0x56B4E9 0x000000'  # Okabe and Ito
FILLED = '7 5 9 13 11 15 3'  # by axis
OPEN = '6 4 8 12 10 14 1'    # not simulated to the end
colour(kind) = int(word(COLOURS, int(kind) + 1))
marker(kind, whole) = int(word(whole > 0 ? FILLED : OPEN, int(kind) + 1))
unset key
set lmargin at screen 0.07564
set rmargin at screen 0.57991
set tmargin at screen 0.88614
set bmargin at screen 0.14356
set title 'hoist: which model is enough, over 0.25 s' noenhanced offset 0,-0.4 font ',14'
set border 3 lc rgb '#555555'
set logscale y
set xrange [-20:100]
set yrange [5e-05:3000]
set xtics nomirror 20 format '%g'
set nomytics
set ytics nomirror 10 format '10^{%L}'
set grid xtics ytics lc rgb '#e6e6e6' lt 1 lw 0.8
set xlabel 'saved of a step''s processor time (%; least: -100)'
set ylabel 'largest physical error / its tolerance (least: 10^{-4})'
set object 1 rectangle from graph 0, first 1 to graph 1, graph 1 fc rgb '#f2dcd3' fs solid 0.6 noborder behind
set object 2 rectangle from graph 0, graph 0 to first 0, first 1 fc rgb '#eeeeee' fs solid 0.8 noborder behind
set label 1 'fails' at graph 0.01, first 1 left offset 0,0.7 tc rgb '#a04000' font ',11'
set label 2 'passes, saves nothing' at graph 0.01, first 1 left offset 0,-0.7 tc rgb '#666666' font ',11'
set label 3 'passes and saves' at graph 0.99, first 1 right offset 0,-0.7 tc rgb '#006644' font ',11'
plot DATA index 0 using 4:5:($8 > 0 ? $6 - $4 : 0):($8 > 0 ? $7 - $5 : 0) with vectors nohead lw 0.6 lc rgb '#999999', \
     DATA index 0 using 4:5:(marker($2, $3)):(colour($2)) with points pt variable ps 0.9 lw 1.5 lc rgb variable, \
     DATA index 0 using 6:7:(sprintf('%d', $1)) with labels font ',11' tc rgb '#222222'
unset object 1
unset object 2
unset label 1
unset label 2
unset label 3
unset logscale
unset grid
unset xlabel
unset ylabel
unset border
unset tics
set lmargin at screen 0.61094
set rmargin at screen 1.00000
set tmargin at screen 0.88614
set bmargin at screen 0.14356
set title ''
set xrange [0:401.2]
set yrange [17.147058823529413:-0.5]
plot DATA index 0 using (10):0:(marker($2, $3)):(colour($2)) with points pt variable ps 0.9 lw 1.5 lc rgb variable, \
     DATA index 0 using (38):0:(sprintf('%d', $1)) with labels right font ',11' tc rgb '#222222', \
     DATA index 0 using (46):0:9 with labels left noenhanced font ',11'
unset multiplot
