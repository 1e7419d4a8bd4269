# Share of draws of body-on-plane:layout=noisy,noise=0 solved, by contacts and normal_noise, and the 50 % line.
# To restyle: edit, then gnuplot frontier.gp > frontier.svg
DATA = 'frontier.dat'
set terminal svg size 1286,1004 enhanced background '#ffffff' font 'sans-serif,12'
set datafile missing NaN
set multiplot
unset key
set lmargin at screen 0.00000
set rmargin at screen 1.00000
set tmargin at screen 1.00000
set bmargin at screen 0.89641
unset border
unset tics
set xrange [0:1286]
set yrange [104:0]
set label 1 'body-on-plane:layout=noisy,noise=0: share of draws solved, by contacts and normal_noise' at 14,20 left noenhanced font ',15'
set label 2 'normal_noise: rad, of each normal; layout=noisy;  contacts: points before the reduction' at 14,46 left noenhanced font ',11' tc rgb '#555555'
set object 1 rectangle from 14,67 to 48,85 fs solid 1 border lc rgb '#bbbbbb' fc rgb '#ffffff'
set label 10 '0 %' at 31,76 center font ',10' tc rgb '#333333'
set object 2 rectangle from 48,67 to 82,85 fs solid 1 border lc rgb '#bbbbbb' fc rgb '#bfdcec'
set label 11 '25 %' at 65,76 center font ',10' tc rgb '#333333'
set object 3 rectangle from 82,67 to 116,85 fs solid 1 border lc rgb '#bbbbbb' fc rgb '#80b9d9'
set label 12 '50 %' at 99,76 center font ',10' tc rgb '#333333'
set object 4 rectangle from 116,67 to 150,85 fs solid 1 border lc rgb '#bbbbbb' fc rgb '#4095c5'
set label 13 '75 %' at 133,76 center font ',10' tc rgb '#ffffff'
set object 5 rectangle from 150,67 to 184,85 fs solid 1 border lc rgb '#bbbbbb' fc rgb '#0072b2'
set label 14 '100 %' at 167,76 center font ',10' tc rgb '#ffffff'
set arrow 1 from 208,76 to 244,76 nohead lw 2.5 lc rgb '#D55E00'
set arrow 2 from 226,65 to 226,87 nohead lw 5 lc rgb '#E69F00'
set label 20 'half are solved; bar: its 95 % band' at 252,76 left font ',11'
set label 21 '{/:Bold x}  where a share that is not monotone crosses 1/2' at 488,76 left font ',11'
set label 22 'numbers: % solved of 8 to 1000 draws; blank: none' at 798,76 left font ',11'
plot NaN
unset label
unset object
unset arrow
set lmargin at screen 0.06532
set rmargin at screen 0.24417
set tmargin at screen 0.85259
set bmargin at screen 0.66335
set title 'lemke' noenhanced offset 0,0.5 font ',12'
set label 1 'no line, 1 above, 4 below' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 0 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 1 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 1 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 1 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 2 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 0 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
set lmargin at screen 0.30949
set rmargin at screen 0.48834
set tmargin at screen 0.85259
set bmargin at screen 0.66335
set title 'lemke-revised' noenhanced offset 0,0.5 font ',12'
set label 1 'no line: below 1/2 in every column' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 3 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 4 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 4 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 4 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 5 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 3 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
set lmargin at screen 0.55365
set rmargin at screen 0.73250
set tmargin at screen 0.85259
set bmargin at screen 0.66335
set title 'lexicographic' noenhanced offset 0,0.5 font ',12'
set label 1 'line in every column' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 6 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 7 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 7 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 7 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 8 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 6 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
set lmargin at screen 0.79782
set rmargin at screen 0.97667
set tmargin at screen 0.85259
set bmargin at screen 0.66335
set title 'lexicographic-pivot' noenhanced offset 0,0.5 font ',12'
set label 1 'line in 2 of 5 columns, 1 above, 2 not monotone' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 9 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 10 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 10 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 10 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 11 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 9 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
set lmargin at screen 0.06532
set rmargin at screen 0.24417
set tmargin at screen 0.55378
set bmargin at screen 0.36454
set title 'lexicographic-revised' noenhanced offset 0,0.5 font ',12'
set label 1 'line in 4 of 5 columns, 1 above' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 12 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 13 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 13 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 13 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 14 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 12 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
set lmargin at screen 0.30949
set rmargin at screen 0.48834
set tmargin at screen 0.55378
set bmargin at screen 0.36454
set title 'best-first' noenhanced offset 0,0.5 font ',12'
set label 1 'no line: above 1/2 in every column' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 15 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 16 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 16 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 16 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 17 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 15 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
set lmargin at screen 0.55365
set rmargin at screen 0.73250
set tmargin at screen 0.55378
set bmargin at screen 0.36454
set title 'best-first-lexicographic' noenhanced offset 0,0.5 font ',12'
set label 1 'no line: above 1/2 in every column' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 18 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 19 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 19 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 19 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 20 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 18 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
set lmargin at screen 0.79782
set rmargin at screen 0.97667
set tmargin at screen 0.55378
set bmargin at screen 0.36454
set title 'projected-gauss-seidel' noenhanced offset 0,0.5 font ',12'
set label 1 'no line: above 1/2 in every column' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 21 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 22 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 22 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 22 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 23 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 21 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
set lmargin at screen 0.06532
set rmargin at screen 0.24417
set tmargin at screen 0.25498
set bmargin at screen 0.06574
set title 'siconos-lexicographic-lemke' noenhanced offset 0,0.5 font ',12'
set label 1 'no line: above 1/2 in every column' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 24 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 25 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 25 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 25 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 26 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 24 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
set lmargin at screen 0.30949
set rmargin at screen 0.48834
set tmargin at screen 0.25498
set bmargin at screen 0.06574
set title 'dart-lemke' noenhanced offset 0,0.5 font ',12'
set label 1 'no line: above 1/2 in every column' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [3:18]
set yrange [-9.5:-1.5]
set xtics nomirror out ('4' 4, '6' 6, '8' 8, '12' 12, '16' 16) font ',10'
set ytics nomirror out ('1e-09' -9, '1e-08' -8, '1e-07' -7, '1e-06' -6, '1e-05' -5, '0.0001' -4, '0.001' -3, '0.01' -2) font ',10'
set xlabel 'contacts' noenhanced offset 0,0.4
set ylabel 'normal_noise (geometric)' noenhanced offset 1.2,0
plot DATA index 27 using 1:2:($3+0.02*($4-$3)):($4-0.02*($4-$3)):($5+0.02*($6-$5)):($6-0.02*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index 28 using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index 28 using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index 28 using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index 29 using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index 27 using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
unset multiplot
