# Draws gap.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,304 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 608 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 3.166667 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "gap." . format

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
set xrange [-4.256:1.256]
set yrange [-1.156:1.17207196]
set label "{/:Italic Q}" at 0,0 center offset character 0.6,-0.9 front tc rgb INK
set label "{/:Italic θ}" at -1.48881923,0.182804015 center offset character -0.9,0 front tc rgb GREY
set label "{/:Italic g}" at -0.291088718,0.0725765687 center offset character 0.6,1.2 front tc rgb PINK
set label "{/:Italic g} sin {/:Italic θ}" at -0.582177436,0 center offset character 0,-0.9 front tc rgb PINK
set label "{/:Italic g}" at -2.40646856,0.3 center offset character -0.9,0 front tc rgb GREEN
set label "along the normal" at -2.40646856,0 center offset character 0,-0.9 front tc rgb GREEN
set label "along the path" at -0.582177436,0.145153137 center offset character 3.5,2.5 front tc rgb PINK
set label "{/:Italic E}′" at 1.1,0 right offset character -0.4,0.7 front tc rgb GREY
set label "{/:Italic E}" at 1.1,-0.75 right offset character -0.4,0.7 front tc rgb BLUE
$s0 << EOD
-4.1 -0.75
1.1 -0.75
1.1 -1
-4.1 -1
EOD
$s1 << EOD
-4.1 -0.75
1.1 -0.75
EOD
$s2 << EOD
-4.1 0
1.1 0
EOD
$s3 << EOD
-1.5 0
-1.4993 0.045808
-1.4972 0.091573
-1.4937 0.13725
-1.4888 0.1828
-1.4825 0.22819
-1.4749 0.27335
-1.4658 0.31827
-1.4554 0.36288
EOD
$s4 << EOD
-4.0752 1.0161 4.0752 -1.0161
EOD
$s5 << EOD
-0.58218 0.14515
-0.58218 0

-0.55799 0.24218
0.024192 0.09703
EOD
$s6 << EOD
-2.4065 0.6
-2.4065 0
EOD
$s7 << EOD
0 0

-0.58218 0.14515

-2.4065 0.6
EOD
plot $s0 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s1 with lines lc rgb BLUE lw 1.6 dt solid notitle, \
 $s2 with lines lc rgb GREY lw 1.2 dt (6,5) notitle, \
 $s3 with lines lc rgb GREY lw 1.2 dt solid notitle, \
 $s4 with vectors filled head size screen 0.022,18,60 lc rgb RED lw 2.4 dt solid notitle, \
 $s5 with lines lc rgb PINK lw 3 dt solid notitle, \
 $s6 with lines lc rgb GREEN lw 3 dt solid notitle, \
 $s7 with points pt 7 ps 0.5 lc rgb INK notitle
