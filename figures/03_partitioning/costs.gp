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
  set terminal svg enhanced size 760,900 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1520,magnify * 1800 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.916667,magnify * 9.375000 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
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
$both << EOD
3 1.5 2.2222 3.125 0 14.25 6.5 8 5.675 3.77
4 1.9375 3.9474 4.375 1 39 10.25 4.2 7.06 5.505
5 2.2812 5.7556 5.125 1 64.188 13.5 8.72 9.045 6.095
6 2.7344 5.6602 6.1719 1.4844 71.734 18.125 12.995 13.27 7.245
7 3.1172 6.4488 7.2109 2 88.031 22.062 8.4 16.43 8.55
8 3.4609 7.8495 8.207 2.0742 122.95 26.125 16.44 20.41 10.08
9 3.7285 8.4682 9.2148 2.5586 140.9 30.172 16.405 22.045 11.2
10 4.1064 9.4708 10.179 2.9844 161.1 34.004 10.45 23.305 11
11 4.4849 10.612 11.198 3.0757 187.44 38.01 17.41 26.285 11.33
12 4.7808 11.564 12.206 3.5422 212.13 42.129 16.58 27.585 11.73
13 5.139 12.616 13.197 3.9915 232.39 45.974 9.21 24.38 10.36
14 5.4648 13.547 14.197 4.068 252.94 50.002 15.69 29.01 10.415


3 3 2.1 3.75 0 9 9.5 8 6.68 3.165
4 5.8125 4.2174 4.8125 4.0625 33.75 12.75 3.77 8.45 6.17
5 5.9688 4.4091 6.3125 4 51.125 17.875 5.83 11.42 8.335
6 6.4688 4.9583 8.1719 5.2031 68.141 26.25 7.725 17.71 9.795
7 7.4766 6.4439 9.4531 6.0469 94.797 31.062 12.025 21.79 13.785
8 7.6875 7.2349 11.07 6.25 115.59 37.797 12.47 18.71 10.785
9 8.0957 8.4501 12.863 6.9277 143.23 44.594 9.725 24.235 11.19
10 8.5283 9.5048 13.327 7.2998 169.9 46.492 10.415 26.38 13.855
11 8.998 10.42 14.727 7.668 191.6 52.152 18.19 32.64 17.26
12 9.3279 11.482 16.761 7.9832 213.44 60.288 31.795 41.615 24.07
13 9.6182 12.43 18.132 8.4028 233.29 65.782 34.6 56.125 34.315
14 9.9694 13.424 18.629 8.6664 251.98 67.77 59.14 93.11 55.865
EOD
steps = "depth of an object"
building = "building: looks at an object"
tests = "tests on a flight"
objects = "objects {/:Italic k}"
evenly = "evenly spread"
crowded = "clustered"
none = "no structure"
in_octree = "octree"
unset key
set grid
set xrange [3:14]
log2(x) = log(x) / log(2)
left(c) = c == 0 ? 0.1 : 0.505
right(c) = c == 0 ? 0.47 : 0.875
shade(t) = t == 0 ? BLUE : t == 1 ? RED : GREEN
set multiplot
do for [c = 0:1] {
  set lmargin at screen left(c)
  set rmargin at screen right(c)
  set xtics ("" 3, "" 6, "" 9, "" 12)
  unset xlabel

  set tmargin at screen 0.895
  set bmargin at screen 0.665
  set yrange [0:20]
  set ytics 0, 5 font ",14"
  if (c == 1) { set format y "" }
  set label 1 (c == 0 ? steps : "") at graph -0.13, 1.1 left font ",16" tc rgb INK
  set label 2 (c == 0 ? evenly : crowded) at screen 0.5 * (left(c) + right(c)), screen 0.975 center font ",17" tc rgb GREY
  if (c == 1) {
    set label 3 "log_2 {/:Italic k}" at 14.2, 14.2 left font ",14" tc rgb GREY
    set label 4 "log_8 {/:Italic k}" at 14.2, 4.667 left font ",14" tc rgb GREY
  }
  plot [3:14] x / 3 with lines lc rgb GREY lw 1.6 dt (6,5), x with lines lc rgb GREY lw 1.2 dt (2,4), \
   for [t = 0:2] $both index c using 1:(column(2 + t)) with linespoints lc rgb shade(t) lw 2.2 pt 7 ps 0.45
  unset label

  set tmargin at screen 0.605
  set bmargin at screen 0.375
  set yrange [0:9]
  set ytics ("1" 0, "4" 2, "16" 4, "64" 6, "256" 8) font ",14"
  if (c == 1) {
    set ytics ("" 0, "" 2, "" 4, "" 6, "" 8)
    set label 3 "BSP tree" at 14.2, 7.9 left font ",14" tc rgb RED
    set label 4 "BVH" at 14.2, 6.05 left font ",14" tc rgb GREEN
    set label 5 in_octree at 14.2, 3.1 left font ",14" tc rgb BLUE
  }
  set label 1 (c == 0 ? building : "") at graph -0.13, 1.1 left font ",16" tc rgb INK
  plot for [t = 0:2] $both index c using 1:(log2(column(5 + t))) with linespoints lc rgb shade(t) lw 2.2 pt 7 ps 0.45
  unset label

  set tmargin at screen 0.315
  set bmargin at screen 0.105
  set xtics ("8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
  set xlabel (c == 0 ? objects : "") font ",16" offset 0, 0.6 textcolor rgb INK
  set yrange [0:14]
  set ytics ("1" 0, "8" 3, "64" 6, "512" 9, "4096" 12) font ",14"
  if (c == 1) { set ytics ("" 0, "" 3, "" 6, "" 9, "" 12) }
  set label 1 (c == 0 ? tests : "") at graph -0.13, 1.1 left font ",16" tc rgb INK
  set label 2 (c == 0 ? none : "") at 10.6, 12.2 right font ",14" tc rgb GREY
  plot [3:14] x with lines lc rgb GREY lw 1.6 dt (6,5), \
   for [t = 0:2] $both index c using 1:(log2(column(8 + t))) with linespoints lc rgb shade(t) lw 2.2 pt 7 ps 0.45
  unset label
  set format y
}
unset multiplot
