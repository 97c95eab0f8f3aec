# Draws costs.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 760,760 font "DejaVu Serif,17" rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size 1520,1520 font "DejaVu Serif,17" fontscale 2 linewidth 2 pointscale 2 rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size 7.916667,7.916667 font "DejaVu Serif,13" rounded background rgb PAPER
} }
set output "costs." . format

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
$even << EOD
3 1.875 2 8 5.675
4 2.0625 3 4.2 7.06
5 2.3438 3 8.72 9.045
6 2.7031 4 12.995 13.27
7 3.1094 5 8.4 16.43
8 3.4453 5 16.44 20.41
9 3.7285 6 16.405 22.045
10 4.0947 7 10.45 23.305
11 4.4385 7 17.41 26.285
12 4.7737 8 16.58 27.585
13 5.1329 9 9.21 24.38
14 5.4474 9 15.69 29.01
EOD
$clustered << EOD
3 4.375 7 8 6.68
4 5.3125 9 3.77 8.45
5 6.6562 11 5.83 11.42
6 7.1406 12 7.725 17.71
7 7.6172 16 12.025 21.79
8 7.8242 14 12.47 18.71
9 8.1777 15 9.725 24.235
10 8.75 16 10.415 26.38
11 8.9189 16 18.19 32.64
12 9.2502 18 31.795 41.615
13 9.5908 18 34.6 56.125
14 9.9709 18 59.14 93.11
EOD
steps = "depth of an object, octree"
tests = "tests on a flight"
objects = "objects {/:Italic k}"
evenly = "evenly spread"
crowded = "clustered"
none = "no structure: {/:Italic k}"
in_bsp = "BSP tree"
in_octree = "octree"
unset key
set grid
set xrange [3:14]
set xtics ("8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
set lmargin at screen 0.115
set rmargin at screen 0.775
set multiplot
set tmargin at screen 0.935
set bmargin at screen 0.56
set yrange [0:12]
set ytics 0, 2 font ",14"
set xtics ("" 3, "" 6, "" 9, "" 12)
set label 1 steps at graph -0.09, 1.07 left font ",16" tc rgb INK
set label 2 "log_8 {/:Italic k}" at 14.15, 4.67 left font ",15" tc rgb GREY
set label 3 evenly at 14.15, 5.6 left font ",15" tc rgb BLUE
set label 4 crowded at 14.15, 10 left font ",15" tc rgb RED
plot [3:14] x / 3 with lines lc rgb GREY lw 1.6 dt (6,5), \
 $even using 1:2 with linespoints lc rgb BLUE lw 2.2 pt 7 ps 0.5, \
 $clustered using 1:2 with linespoints lc rgb RED lw 2.2 pt 7 ps 0.5
unset label
set xtics ("8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
set tmargin at screen 0.46
set bmargin at screen 0.13
set yrange [0:14]
set ytics ("1" 0, "8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
set label 1 tests at graph -0.09, 1.07 left font ",16" tc rgb INK
set label 2 none at 12.0, 12.6 right font ",15" tc rgb GREY
set label 3 in_bsp at 14.15, 6.9 left font ",15" tc rgb RED
set label 4 in_octree at 14.15, 5.9 left font ",15" tc rgb RED
set label 5 in_bsp at 14.15, 4.85 left font ",15" tc rgb BLUE
set label 6 in_octree at 14.15, 3.8 left font ",15" tc rgb BLUE
set xlabel objects font ",16" offset 0, 0.3
log2(x) = log(x) / log(2)
plot [3:14] x with lines lc rgb GREY lw 1.6 dt (6,5), \
 $even using 1:(log2($4)) with linespoints lc rgb BLUE lw 2.2 pt 7 ps 0.5, \
 $even using 1:(log2($5)) with linespoints lc rgb BLUE lw 2.2 dt (8,4) pt 5 ps 0.5, \
 $clustered using 1:(log2($4)) with linespoints lc rgb RED lw 2.2 pt 7 ps 0.5, \
 $clustered using 1:(log2($5)) with linespoints lc rgb RED lw 2.2 dt (8,4) pt 5 ps 0.5
unset multiplot
