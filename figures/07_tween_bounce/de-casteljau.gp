# Draws de-casteljau.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 540,174 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1080,magnify * 348 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 5.625000,magnify * 1.812500 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "de-casteljau." . format

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
set xrange [-0.993:12.893]
set yrange [-1.393:3.093]
set label "{/:Italic P}_0" at 0,0 center offset character -1.3,0 front tc rgb INK
set label "{/:Italic P}_1" at 0.7,2.2 center offset character -1,0.7 front tc rgb INK
set label "{/:Italic P}_2" at 3,1.5 center offset character 1.4,0.3 front tc rgb INK
set label "both sides" at 1.6,-0.75 center offset character 0,0 front tc rgb INK
set label "{/:Italic P}_0" at 4.5,0 center offset character -1.3,0 front tc rgb INK
set label "{/:Italic P}_1" at 5.2,2.2 center offset character -1,0.7 front tc rgb INK
set label "{/:Italic P}_2" at 7.5,1.5 center offset character 1.4,0.3 front tc rgb INK
set label "between" at 6.1,-0.75 center offset character 0,0 front tc rgb INK
set label "{/:Italic P}_0" at 9,0 center offset character -1.3,0 front tc rgb INK
set label "{/:Italic P}_1" at 9.7,2.2 center offset character -1,0.7 front tc rgb INK
set label "{/:Italic P}_2" at 12,1.5 center offset character 1.4,0.3 front tc rgb INK
set label "every {/:Italic s}" at 10.6,-0.75 center offset character 0,0 front tc rgb INK
$s0 << EOD
0 0
0.7 2.2
3 1.5

4.5 0
5.2 2.2
7.5 1.5
EOD
$s1 << EOD
4.78 0.88
6.12 1.92
EOD
$s2 << EOD
9 0
9.7 2.2
12 1.5
EOD
$s3 << EOD
9.07 0.22
9.93 2.13

9.14 0.44
10.16 2.06

9.21 0.66
10.39 1.99

9.28 0.88
10.62 1.92

9.35 1.1
10.85 1.85

9.42 1.32
11.08 1.78

9.49 1.54
11.31 1.71

9.56 1.76
11.54 1.64

9.63 1.98
11.77 1.57
EOD
$s4 << EOD
9 0
9.036 0.10819
9.074 0.21275
9.114 0.31369
9.156 0.411
9.2 0.50469
9.246 0.59475
9.294 0.68119
9.344 0.764
9.396 0.84319
9.45 0.91875
9.506 0.99069
9.564 1.059
9.624 1.1237
9.686 1.1848
9.75 1.2422
9.816 1.296
9.884 1.3462
9.954 1.3928
10.026 1.4357
10.1 1.475
10.176 1.5107
10.254 1.5428
10.334 1.5712
10.416 1.596
10.5 1.6172
10.586 1.6348
10.674 1.6487
10.764 1.659
10.856 1.6657
10.95 1.6688
11.046 1.6682
11.144 1.664
11.244 1.6562
11.346 1.6448
11.45 1.6297
11.556 1.611
11.664 1.5887
11.774 1.5627
11.886 1.5332
12 1.5
EOD
$s5 << EOD
0 0

0.7 2.2

3 1.5
EOD
$s6 << EOD
0.28 0.88

1.62 1.92
EOD
$s7 << EOD
4.5 0

5.2 2.2

7.5 1.5
EOD
$s8 << EOD
4.78 0.88

6.12 1.92
EOD
$s9 << EOD
5.316 1.296
EOD
$s10 << EOD
9 0

9.7 2.2

12 1.5
EOD
$s11 << EOD
9.816 1.296
EOD
plot $s0 with lines lc rgb GREY lw 1.2 dt solid notitle, \
 $s1 with lines lc rgb BLUE lw 2 dt solid notitle, \
 $s2 with lines lc rgb GREY lw 1.2 dt solid notitle, \
 $s3 with lines lc rgb SKY lw 1 dt solid notitle, \
 $s4 with lines lc rgb RED lw 2.6 dt solid notitle, \
 $s5 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s6 with points pt 7 ps 0.5 lc rgb BLUE notitle, \
 $s7 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s8 with points pt 7 ps 0.5 lc rgb BLUE notitle, \
 $s9 with points pt 7 ps 0.5 lc rgb RED notitle, \
 $s10 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s11 with points pt 7 ps 0.5 lc rgb RED notitle
