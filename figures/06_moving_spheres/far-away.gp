# Draws far-away.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,700 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 1400 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 7.291667 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "far-away." . format

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
$printed_single << EOD
0 -7.595 0
0.5 -6.607 0
1 -5.544 0
1.5 -4.478 0
2 -3.446 0
2.5 -2.407 0
3 -1.544 0
3.5 -0.359 4.95
4 -0.0005426 19.4
4.5 0.8585 21.7
5 1.492 23.8
5.5 1.953 41.35
6 2.407 32.9
6.5 3.01 34.72
EOD
$printed_double << EOD
0 -16.32 0
0.5 -15.26 0
1 -14.16 0
1.5 -13.19 0
2 -12.12 0
2.5 -11.09 0
3 -10.22 0
3.5 -9.099 0
4 -8.171 0
4.5 -7.234 0
5 -6.106 0
5.5 -5.157 0
6 -4.241 0
6.5 -3.143 0
7 -2.17 0
7.5 -1.167 0.25
8 -0.05331 10.05
8.5 0.5287 33.95
9 1.018 26.85
9.5 1.646 30.25
10 2.104 23
EOD
$stable_single << EOD
0 -7.693 0
0.5 -6.95 0
1 -6.415 0
1.5 -5.921 0
2 -5.394 0
2.5 -4.808 0
3 -4.485 0
3.5 -3.815 0
4 -3.408 0
4.5 -2.969 0
5 -2.465 0
5.5 -1.777 0
6 -1.491 0
6.5 -0.9163 0
EOD
$stable_double << EOD
0 -16.44 0
0.5 -15.7 0
1 -15.12 0
1.5 -14.65 0
2 -14.09 0
2.5 -13.56 0
3 -13.19 0
3.5 -12.6 0
4 -12.07 0
4.5 -11.68 0
5 -11.09 0
5.5 -10.56 0
6 -10.2 0
6.5 -9.592 0
7 -9.08 0
7.5 -8.668 0
8 -7.959 0
8.5 -7.551 0
9 -7.219 0
9.5 -6.602 0
10 -6.113 0
EOD
printed_s = "printed, single"
printed_d = "printed, double"
stable_s = "stable, single"
stable_d = "stable, double"
error = "error of the contact, in {/:Italic d}"
lost = "hits lost, %"
distance = "distance at the start, in {/:Italic d}"
unset key
set grid
set xrange [0:10]
set xtics 0, 2 font ",14"
set lmargin at screen 0.115
set rmargin at screen 0.96
set multiplot
set tmargin at screen 0.925
set bmargin at screen 0.43
set yrange [-17:2]
set ytics -16, 4 font ",14"
set format y "10^{%.0f}"
set format x ""
set label 1 error at graph -0.08, 1.075 left font ",16" tc rgb INK
set label 2 printed_s at 2.7, -0.95 right font ",15" tc rgb PINK
set label 3 stable_s at 4.4, -6.5 right font ",15" tc rgb GREEN
set label 4 printed_d at 3.1, -8.6 right font ",15" tc rgb PINK
set label 5 stable_d at 6.3, -11.3 left font ",15" tc rgb GREEN
set arrow 1 from 0, 0 to 10, 0 nohead lc rgb GREY lw 1.2 dt (6,5)
plot $printed_single using 1:2 with lines lc rgb PINK lw 2.2 dt (8,5), \
 $stable_single using 1:2 with lines lc rgb GREEN lw 2.2 dt (8,5), \
 $printed_double using 1:2 with lines lc rgb PINK lw 2.2, \
 $stable_double using 1:2 with lines lc rgb GREEN lw 2.2
set tmargin at screen 0.335
set bmargin at screen 0.14
unset label
unset arrow 1
set yrange [-2:50]
set ytics 0, 20 font ",14"
set format y "%g"
set format x "10^{%.0f}"
set label 1 lost at graph -0.08, 1.15 left font ",16" tc rgb INK
set xlabel distance font ",16" offset 0, 0.3
plot $printed_single using 1:3 with lines lc rgb PINK lw 2.2 dt (8,5), \
 $printed_double using 1:3 with lines lc rgb PINK lw 2.2, \
 $stable_single using 1:3 with lines lc rgb GREEN lw 2.2 dt (8,5), \
 $stable_double using 1:3 with lines lc rgb GREEN lw 2.2
unset multiplot
