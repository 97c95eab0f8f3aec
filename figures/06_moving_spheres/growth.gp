# Draws growth.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 760,560 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1520,magnify * 1120 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.916667,magnify * 5.833333 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "growth." . format

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
$alike << EOD
2 3.2133 3.2735 2.2672
2.4997 4.0646 3.9348 2.7938
3 4.9344 4.53 3.4052
3.5 5.7723 5.1052 3.9082
4 6.6103 5.6592 4.4301
4.5 7.4457 6.1983 4.9338
5 8.2817 6.7312 5.4417
EOD
$uneven << EOD
2 3.2348 3.4339 2.5079
2.4997 4.0844 4.097 3.0584
3 4.9476 4.6918 3.629
3.5 5.7893 5.2583 4.1468
4 6.6284 5.8043 4.6656
4.5 7.4646 6.3377 5.1743
5 8.3018 6.8652 5.6821
EOD
tests = "tests"
spheres = "spheres {/:Italic n}"
every_pair = "every pair"
one_axis = "sorted along {/:Italic x}"
uneven = "boxes, if uneven"
alike = "boxes, if alike"
swept = "pairs swept"
unset key
set grid
set lmargin at screen 0.095
set rmargin at screen 0.74
set tmargin at screen 0.925
set bmargin at screen 0.165
set xrange [2:5]
set xtics 2, 1 font ",14"
set format x "10^{%.0f}"
set yrange [2:10]
set ytics 2, 2 font ",14"
set format y "10^{%.0f}"
set xlabel spheres font ",16" offset 0, 0.3
log2(x) = log(x) / log(2)
set label 1 tests at graph -0.07, 1.055 left font ",16" tc rgb INK
set label 2 every_pair at 5.05, 9.7 left font ",15" tc rgb GREY
set label 3 one_axis at 5.05, 8.28 left font ",15" tc rgb ORANGE
set label 4 uneven at 5.05, 7.02 left font ",15" tc rgb RED
set label 5 alike at 5.05, 6.62 left font ",15" tc rgb BLUE
set label 6 "{/:Italic n} log_2 {/:Italic n}" at 5.05, 6.18 left font ",15" tc rgb GREY
set label 7 swept at 5.05, 5.44 left font ",15" tc rgb GREEN
plot [2:5] log10(10**x * (10**x - 1) / 2) with lines lc rgb GREY lw 1.6 dt (6,5), \
 log10(10**x * log2(10**x)) with lines lc rgb GREY lw 1.6 dt (6,5), \
 $alike using 1:2 with linespoints lc rgb ORANGE lw 2.2 pt 7 ps 0.5, \
 $uneven using 1:3 with linespoints lc rgb RED lw 2.2 pt 7 ps 0.5, \
 $alike using 1:3 with linespoints lc rgb BLUE lw 2.2 pt 7 ps 0.5, \
 $alike using 1:4 with linespoints lc rgb GREEN lw 2.2 pt 7 ps 0.5
