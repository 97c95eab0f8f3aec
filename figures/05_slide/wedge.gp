# Draws wedge.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,366 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 732 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 3.812500 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "wedge." . format

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
set xrange [-4.71499802:6.30071419]
set yrange [-2.70071419:2.90071419]
set label "{/:Bold N}" at -1.1,0.7 center offset character 1.2,0.2 front tc rgb INK
set label "{/:Bold M}" at -3.28403559,1.83655602 center offset character 1.3,0.2 front tc rgb INK
set label "{/:Bold w}" at -1.58870862,-1.0068466 center offset character 0,-0.9 front tc rgb RED
set label "{/:Bold N}" at 5.5,0.7 center offset character 1.2,0.2 front tc rgb INK
set label "{/:Bold M}" at 3.31596441,1.83655602 center offset character 1.3,0.2 front tc rgb INK
set label "{/:Bold w}" at 2.69579266,-1.32442139 center offset character 0,-0.9 front tc rgb RED
set label "{/:Bold v}" at -1.58870862,0 center offset character 0.2,0.8 front tc rgb GREEN
set label "along one wall" at -2.4,-2.1 center offset character 0,0 front tc rgb INK
set label "along the crease, toward you" at 4.2,-2.1 center offset character 0,0 front tc rgb INK
set label "{/:Italic Q}" at -3.2,0 center offset character -1.2,-0.6 front tc rgb INK
set label "{/:Italic Q}" at 3.4,0 center offset character 1.1,-0.6 front tc rgb INK
$s0 << EOD
-3.2 0
-0.8 0
-0.80913 0.20917
-0.83646 0.41676
-0.88178 0.62117
-0.94474 0.82085
-1.0249 1.0143
-1.1215 1.2
-1.234 1.3766
-1.3615 1.5427
-1.5029 1.6971
-1.6573 1.8385
-1.8234 1.966
-2 2.0785
-2.1857 2.1751
-2.3792 2.2553
-2.5788 2.3182
-2.7832 2.3635
-2.9908 2.3909
-3.2 2.4
-3.4092 2.3909
-3.6168 2.3635
-3.8212 2.3182
-4.0208 2.2553
-4.2143 2.1751

3.4 0
5.8 0
5.7909 0.20917
5.7635 0.41676
5.7182 0.62117
5.6553 0.82085
5.5751 1.0143
5.4785 1.2
5.366 1.3766
5.2385 1.5427
5.0971 1.6971
4.9427 1.8385
4.7766 1.966
4.6 2.0785
4.4143 2.1751
4.2208 2.2553
4.0212 2.3182
3.8168 2.3635
3.6092 2.3909
3.4 2.4
3.1908 2.3909
2.9832 2.3635
2.7788 2.3182
2.5792 2.2553
2.3857 2.1751
EOD
$s1 << EOD
-0.8 0
-3.2 0
-4.2143 2.1751

5.8 0
3.4 0
2.3857 2.1751

2.6958 -1.3244
3.4 0

-1.5887 -1.0068
-1.5887 0
EOD
$s2 << EOD
3.4 0 -0.70421 -1.3244

-3.2 0 1.6113 -1.0068
EOD
$s3 << EOD
-1.1 0 0 0.7

5.5 0 0 0.7

-3.9185 1.5407 0.63442 0.29583

2.6815 1.5407 0.63442 0.29583
EOD
$s4 << EOD
-3.2 0 1.6113 0
EOD
$s5 << EOD
0 -2.2
EOD
$s6 << EOD
-3.2 0

3.4 0
EOD
plot $s0 with filledcurves closed fc rgb fade(GREEN,0.16) fs solid noborder notitle, \
 $s1 with lines lc rgb GREY lw 1.2 dt (6,5) notitle, \
 $s2 with vectors filled head size screen 0.022,18,60 lc rgb RED lw 2.4 dt solid notitle, \
 $s3 with vectors filled head size screen 0.022,18,60 lc rgb INK lw 2 dt solid notitle, \
 $s4 with vectors filled head size screen 0.022,18,60 lc rgb GREEN lw 2.4 dt solid notitle, \
 $s5 with points pt 7 ps 0.5 lc rgb PAPER notitle, \
 $s6 with points pt 7 ps 0.5 lc rgb INK notitle
