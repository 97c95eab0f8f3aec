# Draws accuracy.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
# before the script's name, the other pictures.
if (!exists("format")) format = "svg"
if (!exists("theme")) theme = "light"
if (theme eq "dark") {
  PAPER = 0x15191C
  INK = 0xDDE3E3
  GREY = 0x9AA4A4
  PALE = 0x3A4347
  BLUE = 0x58ACE6
  SKY = 0x7CC6F0
  GREEN = 0x35C79B
  RED = 0xFF8A3D
  ORANGE = 0xF4B942
  AMBER = 0xE3AB3C
  PINK = 0xE59BC3
  YELLOW = 0xE5DA4A
  FLOOR = 0x22394A
  SHADOW = 0x16262F
  MIST = 0x1D2429
} else {
  PAPER = 0xFFFFFF
  INK = 0x222222
  GREY = 0x8A8A8A
  PALE = 0xD9D9D9
  BLUE = 0x0072B2
  SKY = 0x56B4E9
  GREEN = 0x009E73
  RED = 0xD55E00
  ORANGE = 0xE69F00
  AMBER = 0xF4B942
  PINK = 0xCC79A7
  YELLOW = 0xF0E442
  FLOOR = 0xCFE3F1
  SHADOW = 0xB3CADB
  MIST = 0xEEF3F6
}
# -e "own='FILE'" reads gnuplot commands of your own here: they may set these and the colours.
font = "DejaVu Serif"; letters = 1.0; magnify = 1.0
if (exists("own")) load own

# fade(c, a): colour c with opacity a.  tone(c): a shaded colour, in grey if the theme is.
fade(c, a) = c + int((1 - a) * 255 + 0.5) * 16777216
luminance(c) = int(0.299 * (c / 65536 & 255) + 0.587 * (c / 256 & 255) + 0.114 * (c & 255))
tone(c) = theme eq "grey" ? (c & 0xFF000000) + luminance(c & 0xFFFFFF) * 65793 : c
if (theme eq "grey") {
  PAPER = 0xFFFFFF; INK = 0x222222
  array hues[13] = [GREY, PALE, BLUE, SKY, GREEN, RED, ORANGE, AMBER, PINK, YELLOW, FLOOR, SHADOW, MIST]
  do for [i = 1:13] { hues[i] = tone(hues[i]) }
  GREY = hues[1]; PALE = hues[2]; BLUE = hues[3]; SKY = hues[4]; GREEN = hues[5]; RED = hues[6]
  ORANGE = hues[7]; AMBER = hues[8]; PINK = hues[9]; YELLOW = hues[10]; FLOOR = hues[11]; SHADOW = hues[12]; MIST = hues[13]
}
if (format eq "svg") {
  set terminal svg enhanced size 720,780 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 1560 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 8.125000 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "accuracy." . format

set encoding utf8
set minussign
set border 3 lw 1 lc rgb INK
set tics nomirror out textcolor rgb INK scale 0.6
set xlabel textcolor rgb INK
set ylabel textcolor rgb INK
set title textcolor rgb INK
set key textcolor rgb INK
set grid lc rgb PALE lw 0.6 lt 1
unset grid
set style line 1 lc rgb BLUE  lw 2.2
set style line 2 lc rgb RED   lw 2.2
set style line 3 lc rgb GREEN lw 2.2
set style line 4 lc rgb PINK  lw 2.2
set style line 10 lc rgb INK  lw 1.4
set style line 11 lc rgb GREY lw 1.2 dt (6,5)
set style arrow 1 head filled size screen 0.022,18,60 front lt 1 lc rgb RED  lw 2.4
set style arrow 2 head filled size screen 0.022,18,60 front lt 1 lc rgb INK  lw 2.0
set style arrow 3 nohead front lt 1 lc rgb GREY lw 1.2 dt (6,5)
set style arrow 4 nohead front lt 1 lc rgb INK lw 1.4
$book_single << EOD
0.5 -6.715
1 -6.272
1.5 -5.798
2 -5.27
2.5 -4.778
3 -4.276
3.5 -3.701
4 -3.466
4.5 -3.371
5 -3.388
5.5 -3.384
6 -3.371
6.5 -3.382
EOD
$stable_single << EOD
0.5 -7.225
1 -7.26
1.5 -7.287
2 -7.251
2.5 -7.262
3 -7.27
3.5 -7.256
4 -7.268
4.5 -7.286
5 -7.271
5.5 -7.268
6 -7.27
6.5 -7.264
EOD
$book_double << EOD
0.5 -15.44
1 -14.98
1.5 -14.49
2 -14
2.5 -13.47
3 -13.01
3.5 -12.48
4 -11.96
4.5 -11.5
5 -11
5.5 -10.5
6 -9.972
6.5 -9.48
7 -8.977
7.5 -8.471
8 -7.966
8.5 -7.799
9 -7.725
9.5 -7.72
10 -7.727
EOD
$stable_double << EOD
0.5 -15.87
1 -15.92
1.5 -15.87
2 -15.87
2.5 -15.87
3 -15.87
3.5 -15.87
4 -15.86
4.5 -15.87
5 -15.88
5.5 -15.86
6 -15.86
6.5 -15.86
7 -15.86
7.5 -15.89
8 -15.85
8.5 -15.86
9 -15.87
9.5 -15.88
10 -15.86
EOD
$determinant << EOD
-6 50
-5.75 50
-5.5 50
-5.25 50
-5 50
-4.75 50
-4.5 50
-4.25 50
-4 50
-3.75 50
-3.5 50
-3.25 50
-3 50
-2.75 50
-2.5 50
-2.25 50
-2 50
-1.75 29.8
-1.5 0
-1.25 0
-1 0
-0.75 0
-0.5 0
-0.25 0
0 0
0.25 0
0.5 0
0.75 0
1 0
1.25 0
1.5 0
1.75 0
2 0
2.25 0
2.5 0
2.75 0
3 0
3.25 0
3.5 0
3.75 0
4 0
4.25 0
4.5 0
4.75 0
5 0
5.25 0
5.5 0
5.75 0
6 0
EOD
$areas_single << EOD
-6 50
-5.75 50
-5.5 50
-5.25 50
-5 50
-4.75 50
-4.5 50
-4.25 50
-4 50
-3.75 50
-3.5 50
-3.25 50
-3 50
-2.75 50
-2.5 47.45
-2.25 22.9
-2 4.15
-1.75 0
-1.5 0
-1.25 0
-1 0
-0.75 0
-0.5 0
-0.25 0
0 0
0.25 0
0.5 0
0.75 0.05
1 2.7
1.25 22.3
1.5 29.7
1.75 26.65
2 26.95
2.25 28.3
2.5 29.1
2.75 27.45
3 28.3
3.25 28.15
3.5 27.4
3.75 27.95
4 27.05
4.25 27.8
4.5 25.9
4.75 27.9
5 27.6
5.25 26.85
5.5 26.4
5.75 27.05
6 27.5
EOD
$areas_double << EOD
-6 50
-5.75 50
-5.5 50
-5.25 50
-5 50
-4.75 50
-4.5 50
-4.25 50
-4 50
-3.75 50
-3.5 50
-3.25 50
-3 50
-2.75 50
-2.5 47.45
-2.25 22.9
-2 4.15
-1.75 0
-1.5 0
-1.25 0
-1 0
-0.75 0
-0.5 0
-0.25 0
0 0
0.25 0
0.5 0
0.75 0
1 0
1.25 0
1.5 0
1.75 0
2 0
2.25 0
2.5 0
2.75 0
3 0
3.25 0
3.5 0
3.75 0
4 0
4.25 0
4.5 0
4.75 0
5 0
5.25 0.25
5.5 13.35
5.75 28.65
6 28.6
EOD
$weights << EOD
-6 0
-5.75 0
-5.5 0
-5.25 0
-5 0
-4.75 0
-4.5 0
-4.25 0
-4 0
-3.75 0
-3.5 0
-3.25 0
-3 0
-2.75 0
-2.5 0
-2.25 0
-2 0
-1.75 0
-1.5 0
-1.25 0
-1 0
-0.75 0
-0.5 0
-0.25 0
0 0
0.25 0
0.5 0
0.75 0
1 0
1.25 0
1.5 0
1.75 0
2 0
2.25 0
2.5 0
2.75 0
3 0
3.25 0
3.5 0
3.75 0
4 0
4.25 0
4.5 0
4.75 0
5 0
5.25 0
5.5 0
5.75 0
6 0
EOD
error = "relative error of {/:Italic t}, at an edge"
distance = "distance at the start, in {/:Italic r}"
book_s = "textbook, single"
book_d = "textbook, double"
stable_s = "stable, single"
stable_d = "stable, double"
wrong = "wrong answers, %"
size = "size of the scene"
determinant = "determinant, 10^{−5}"
areas_s = "areas, 10^{−5}, single"
areas_d = "areas, double"
none = "no tolerance"
unset key
set grid
set lmargin at screen 0.115
set rmargin at screen 0.96
set format x "10^{%.0f}"
set multiplot
set tmargin at screen 0.935
set bmargin at screen 0.58
set xrange [0:10]
set xtics 0, 2 font ",14"
set yrange [-17:0]
set ytics -16, 4 font ",14"
set format y "10^{%.0f}"
set label 1 error at graph -0.08, 1.08 left font ",16" tc rgb INK
set label 2 book_s at 3.2, -2.2 right font ",15" tc rgb PINK
set label 3 stable_s at 6.3, -6.2 right font ",15" tc rgb GREEN
set label 4 book_d at 5.2, -9.5 right font ",15" tc rgb PINK
set label 5 stable_d at 6.3, -14.4 left font ",15" tc rgb GREEN
set xlabel distance font ",16" offset 0, 0.6
plot $book_single using 1:2 with lines lc rgb PINK lw 2.2 dt (8,5), \
 $stable_single using 1:2 with lines lc rgb GREEN lw 2.2 dt (8,5), \
 $book_double using 1:2 with lines lc rgb PINK lw 2.2, \
 $stable_double using 1:2 with lines lc rgb GREEN lw 2.2
unset label
set tmargin at screen 0.405
set bmargin at screen 0.125
set xrange [-6:6]
set xtics -6, 2 font ",14"
set yrange [-2:60]
set ytics 0, 25 font ",14"
set format y "%g"
set label 1 wrong at graph -0.08, 1.1 left font ",16" tc rgb INK
set label 2 determinant at -5.8, 55 left font ",15" tc rgb ORANGE
set label 3 areas_s at 1.6, 36 left font ",15" tc rgb PINK
set label 4 areas_d at 5.05, 14 right font ",15" tc rgb PINK
set label 5 none at -0.45, 5 center font ",15" tc rgb GREEN
set xlabel size font ",16" offset 0, 0.6
plot $determinant using 1:2 with lines lc rgb ORANGE lw 2.2, \
 $areas_single using 1:2 with lines lc rgb PINK lw 2.2 dt (8,5), \
 $areas_double using 1:2 with lines lc rgb PINK lw 2.2, \
 $weights using 1:2 with lines lc rgb GREEN lw 2.2
unset multiplot
