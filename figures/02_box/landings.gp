# Draws landings.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 900,382 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1800,magnify * 764 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 9.375000,magnify * 3.979167 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "landings." . format

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
unset border; unset tics; unset key; set size ratio -1
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set xrange [-4.60156104:4.60156104]
set yrange [-1.25588181:2.65901051]
set label "{/:Italic C}" at -2.74102022,0.236050317 center offset character 0.2,-0.9 front tc rgb INK
set label "{/:Italic C}_1" at -0.581786214,-0.192513571 center offset character -0.783929485,-0.767309352 front tc rgb INK
set label "{/:Italic C}_2" at -0.291479939,0.281072221 center offset character 0.783929485,0.767309352 front tc rgb INK
set label "{/:Italic C}_1" at 1.5043496,-0.404070345 center offset character -1.48435878,-0.129631954 front tc rgb INK
set label "{/:Italic C}_2" at 3.2508819,-0.581187645 center offset character 1.36949593,-0.36716906 front tc rgb INK
set label "{/:Italic C}_3" at 3.54118818,-0.107601853 center offset character 1.48435878,0.129631954 front tc rgb INK
set label "{/:Italic C}_4" at 1.79465587,0.0695154464 center offset character -1.36949593,0.36716906 front tc rgb INK
$s0 << EOD
-4.3411 -0.18855
3.6153 -0.99542
4.3411 0.18855
-3.6153 0.99542
EOD
$s1 << EOD
-4.3411 -0.18855
3.6153 -0.99542
4.3411 0.18855
-3.6153 0.99542
-4.3411 -0.18855
EOD
$s2 << EOD
-3.177 -0.13892
-2.304 -0.059782
-1.4315 0.35477
-1.8685 0.6506
-2.7415 0.57145
-3.614 0.15691
-3.177 -0.13892

0.29148 -0.28107
0.81544 -0.33421
1.1057 0.13938
-0.81544 0.33421
-1.1057 -0.13938

3.2509 -0.58119
3.5412 -0.1076
1.7947 0.069515
1.5043 -0.40407
EOD
$s3 << EOD
-2.741 0.23605
-1.8685 1.7469

-2.7415 2.3985
-1.8685 1.7469

-1.8685 1.7469
-1.4315 1.7251

-0.29148 0.28107
1.1057 1.126

-0.58179 -0.19251
-0.29148 0.28107

-0.29148 0.28107
-0.81544 0.99196

1.7947 0.069515
3.5412 -0.1076

1.5043 -0.40407
1.7947 0.069515

1.7947 0.069515
1.7947 0.89171
EOD
$s4 << EOD
-3.614 0.88774
-2.741 0.23605
-2.304 0.21428
-3.177 0.86598
EOD
$s5 << EOD
-3.614 0.88774
-3.177 0.86598
-2.3045 2.3768
-2.7415 2.3985
EOD
$s6 << EOD
-3.177 0.86598
-2.3045 2.3768
-1.4315 1.7251
-2.304 0.21428
EOD
$s7 << EOD
-1.1057 0.51837
0.29148 1.3633
0.58179 1.8369
-0.81544 0.99196
EOD
$s8 << EOD
0.81544 0.65242
1.1057 1.126
0.58179 1.8369
0.29148 1.3633
EOD
$s9 << EOD
-3.614 0.88774
-2.7415 2.3985

-3.177 0.86598
-2.3045 2.3768

-2.304 0.21428
-1.4315 1.7251

-3.614 0.88774
-2.741 0.23605

-3.177 0.86598
-2.304 0.21428

-2.3045 2.3768
-1.4315 1.7251

-3.614 0.88774
-3.177 0.86598

-2.7415 2.3985
-2.3045 2.3768

-2.741 0.23605
-2.304 0.21428
EOD
$s10 << EOD
-0.58179 -0.19251
-1.1057 0.51837
0.29148 1.3633
0.81544 0.65242
EOD
$s11 << EOD
1.5043 0.41812
3.2509 0.241
3.5412 0.71459
1.7947 0.89171
EOD
$s12 << EOD
3.2509 -0.58119
3.5412 -0.1076
3.5412 0.71459
3.2509 0.241
EOD
$s13 << EOD
1.5043 -0.40407
1.5043 0.41812
3.2509 0.241
3.2509 -0.58119
EOD
$s14 << EOD
-0.58179 -0.19251
0.81544 0.65242

-1.1057 0.51837
0.29148 1.3633

-0.81544 0.99196
0.58179 1.8369

-1.1057 0.51837
-0.81544 0.99196

0.81544 0.65242
1.1057 1.126

0.29148 1.3633
0.58179 1.8369

-0.58179 -0.19251
-1.1057 0.51837

0.81544 0.65242
0.29148 1.3633

1.1057 1.126
0.58179 1.8369

1.5043 -0.40407
3.2509 -0.58119

1.5043 0.41812
3.2509 0.241

1.7947 0.89171
3.5412 0.71459

1.5043 0.41812
1.7947 0.89171

3.2509 -0.58119
3.5412 -0.1076

3.2509 0.241
3.5412 0.71459

1.5043 -0.40407
1.5043 0.41812

3.2509 -0.58119
3.2509 0.241

3.5412 -0.1076
3.5412 0.71459
EOD
$s15 << EOD
1.5043 -0.40407
3.2509 -0.58119
3.5412 -0.1076
1.7947 0.069515
EOD
$s16 << EOD
-0.58179 -0.19251
-0.29148 0.28107

1.5043 -0.40407
3.2509 -0.58119
3.5412 -0.1076
1.7947 0.069515
1.5043 -0.40407
EOD
$s17 << EOD
-0.29148 0.28107

-2.741 0.23605

1.7947 0.069515

3.5412 -0.1076

-0.58179 -0.19251

1.5043 -0.40407

1.5043 -0.40407

3.2509 -0.58119
EOD
plot $s0 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s1 with lines lc rgb BLUE lw 1.2 dt solid notitle, \
 $s2 with filledcurves closed fc rgb SHADOW fs solid noborder notitle, \
 $s3 with lines lc rgb GREY lw 1 dt (6,5) notitle, \
 $s4 with filledcurves closed fc rgb tone(0x808F6C27) fs solid noborder notitle, \
 $s5 with filledcurves closed fc rgb tone(0x80E9B141) fs solid noborder notitle, \
 $s6 with filledcurves closed fc rgb tone(0x80BD8F33) fs solid noborder notitle, \
 $s7 with filledcurves closed fc rgb tone(0x80DBA63B) fs solid noborder notitle, \
 $s8 with filledcurves closed fc rgb tone(0x80A37C2C) fs solid noborder notitle, \
 $s9 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s10 with filledcurves closed fc rgb tone(0x80CC9B37) fs solid noborder notitle, \
 $s11 with filledcurves closed fc rgb tone(0x80D9A53B) fs solid noborder notitle, \
 $s12 with filledcurves closed fc rgb tone(0x808E6B26) fs solid noborder notitle, \
 $s13 with filledcurves closed fc rgb tone(0x80CC9B37) fs solid noborder notitle, \
 $s14 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s15 with filledcurves closed fc rgb fade(RED,0.25) fs solid noborder notitle, \
 $s16 with lines lc rgb RED lw 2.4 dt solid notitle, \
 $s17 with points pt 7 ps 0.5 lc rgb RED notitle
