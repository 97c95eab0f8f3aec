# Draws slerp.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 560,183 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1120,magnify * 366 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 5.833333,magnify * 1.906250 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "slerp." . format

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
set xrange [-1.13475488:3.73475488]
set yrange [-0.337816314:1.25781631]
set label "{/:Italic a}" at -0.996938566,0.464880088 center offset character 0,0 front tc rgb INK
set label "{/:Italic b}" at 0.996938566,0.464880088 center offset character 0,0 front tc rgb INK
set label "steps of the chord" at 0,-0.14 center offset character 0,0 front tc rgb PINK
set label "{/:Italic a}" at 1.60306143,0.464880088 center offset character 0,0 front tc rgb INK
set label "{/:Italic b}" at 3.59693857,0.464880088 center offset character 0,0 front tc rgb INK
set label "steps of the angle" at 2.6,-0.14 center offset character 0,0 front tc rgb GREEN
$s0 << EOD
-0.98836 0.15212
-0.98007 0.19866
-0.96959 0.24474
-0.95694 0.29028
-0.94215 0.33518
-0.92526 0.37932
-0.90631 0.42262
-0.88533 0.46497
-0.86237 0.50628
-0.83748 0.54647
-0.81072 0.58543
-0.78216 0.62308
-0.75184 0.65935
-0.71984 0.69414
-0.68624 0.72737
-0.65111 0.75899
-0.61451 0.78891
-0.57655 0.81706
-0.5373 0.84339
-0.49685 0.86784
-0.45529 0.89035
-0.41271 0.91086
-0.36921 0.92935
-0.32488 0.94576
-0.27983 0.96005
-0.23415 0.9722
-0.18795 0.98218
-0.14133 0.98996
-0.094398 0.99553
-0.047252 0.99888
0 1
0.047252 0.99888
0.094398 0.99553
0.14133 0.98996
0.18795 0.98218
0.23415 0.9722
0.27983 0.96005
0.32488 0.94576
0.36921 0.92935
0.41271 0.91086
0.45529 0.89035
0.49685 0.86784
0.5373 0.84339
0.57655 0.81706
0.61451 0.78891
0.65111 0.75899
0.68624 0.72737
0.71984 0.69414
0.75184 0.65935
0.78216 0.62308
0.81072 0.58543
0.83748 0.54647
0.86237 0.50628
0.88533 0.46497
0.90631 0.42262
0.92526 0.37932
0.94215 0.33518
0.95694 0.29028
0.96959 0.24474
0.98007 0.19866
0.98836 0.15212

1.6116 0.15212
1.6199 0.19866
1.6304 0.24474
1.6431 0.29028
1.6578 0.33518
1.6747 0.37932
1.6937 0.42262
1.7147 0.46497
1.7376 0.50628
1.7625 0.54647
1.7893 0.58543
1.8178 0.62308
1.8482 0.65935
1.8802 0.69414
1.9138 0.72737
1.9489 0.75899
1.9855 0.78891
2.0234 0.81706
2.0627 0.84339
2.1032 0.86784
2.1447 0.89035
2.1873 0.91086
2.2308 0.92935
2.2751 0.94576
2.3202 0.96005
2.3658 0.9722
2.412 0.98218
2.4587 0.98996
2.5056 0.99553
2.5527 0.99888
2.6 1
2.6473 0.99888
2.6944 0.99553
2.7413 0.98996
2.788 0.98218
2.8342 0.9722
2.8798 0.96005
2.9249 0.94576
2.9692 0.92935
3.0127 0.91086
3.0553 0.89035
3.0968 0.86784
3.1373 0.84339
3.1766 0.81706
3.2145 0.78891
3.2511 0.75899
3.2862 0.72737
3.3198 0.69414
3.3518 0.65935
3.3822 0.62308
3.4107 0.58543
3.4375 0.54647
3.4624 0.50628
3.4853 0.46497
3.5063 0.42262
3.5253 0.37932
3.5422 0.33518
3.5569 0.29028
3.5696 0.24474
3.5801 0.19866
3.5884 0.15212
EOD
$s1 << EOD
-0.90631 0.42262
0.90631 0.42262
EOD
$s2 << EOD
0 0
-0.90631 0.42262

0 0
-0.73132 0.68204

0 0
0 1

0 0
0.73132 0.68204

0 0
0.90631 0.42262
EOD
$s3 << EOD
2.6 0
1.6937 0.42262

2.6 0
2.0627 0.84339

2.6 0
2.6 1

2.6 0
3.1373 0.84339

2.6 0
3.5063 0.42262
EOD
$s4 << EOD
-0.90631 0.42262
EOD
$s5 << EOD
-0.90631 0.42262
EOD
$s6 << EOD
-0.45315 0.42262
EOD
$s7 << EOD
-0.73132 0.68204
EOD
$s8 << EOD
0 0.42262
EOD
$s9 << EOD
0 1
EOD
$s10 << EOD
0.45315 0.42262
EOD
$s11 << EOD
0.73132 0.68204
EOD
$s12 << EOD
0.90631 0.42262
EOD
$s13 << EOD
0.90631 0.42262
EOD
$s14 << EOD
1.6937 0.42262
EOD
$s15 << EOD
1.6937 0.42262
EOD
$s16 << EOD
2.0627 0.84339
EOD
$s17 << EOD
2.0627 0.84339
EOD
$s18 << EOD
2.6 1
EOD
$s19 << EOD
2.6 1
EOD
$s20 << EOD
3.1373 0.84339
EOD
$s21 << EOD
3.1373 0.84339
EOD
$s22 << EOD
3.5063 0.42262
EOD
$s23 << EOD
3.5063 0.42262
EOD
plot $s0 with lines lc rgb GREY lw 1.2 dt solid notitle, \
 $s1 with lines lc rgb PINK lw 2 dt solid notitle, \
 $s2 with lines lc rgb PINK lw 1.2 dt solid notitle, \
 $s3 with lines lc rgb GREEN lw 1.2 dt solid notitle, \
 $s4 with points pt 7 ps 0.5 lc rgb PINK notitle, \
 $s5 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s6 with points pt 7 ps 0.5 lc rgb PINK notitle, \
 $s7 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s8 with points pt 7 ps 0.5 lc rgb PINK notitle, \
 $s9 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s10 with points pt 7 ps 0.5 lc rgb PINK notitle, \
 $s11 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s12 with points pt 7 ps 0.5 lc rgb PINK notitle, \
 $s13 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s14 with points pt 7 ps 0.5 lc rgb GREEN notitle, \
 $s15 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s16 with points pt 7 ps 0.5 lc rgb GREEN notitle, \
 $s17 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s18 with points pt 7 ps 0.5 lc rgb GREEN notitle, \
 $s19 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s20 with points pt 7 ps 0.5 lc rgb GREEN notitle, \
 $s21 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s22 with points pt 7 ps 0.5 lc rgb GREEN notitle, \
 $s23 with points pt 7 ps 0.5 lc rgb INK notitle
