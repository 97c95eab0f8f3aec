# Draws slabs.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,439 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 878 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 4.572917 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "slabs." . format

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
set xrange [-4.876:4.876]
set yrange [-2.976:2.976]
set label "enters {/:Italic x}" at -1.8,-1.12142857 left offset character 0.6,-0.9 front tc rgb INK
set label "enters {/:Italic z}" at -2.05116279,-1.25 right offset character -0.6,0.9 front tc rgb INK
set label "leaves {/:Italic x}" at 1.8,0.721428571 left offset character 0.6,-0.9 front tc rgb INK
set label "leaves {/:Italic z}" at 2.83255814,1.25 right offset character -0.6,0.9 front tc rgb INK
$s0 << EOD
-1.8 -2.7
1.8 -2.7
1.8 2.7
-1.8 2.7

-4.6 -1.25
4.6 -1.25
4.6 1.25
-4.6 1.25
EOD
$s1 << EOD
-1.3 -0.75
1.3 -0.75
1.3 0.75
-1.3 0.75
EOD
$s2 << EOD
-1.3 -0.75
1.3 -0.75
1.3 0.75
-1.3 0.75
-1.3 -0.75
EOD
$s3 << EOD
-4.6 -1.25
4.6 -1.25

-1.8 -2.7
-1.8 2.7

1.8 -2.7
1.8 2.7

-4.6 1.25
4.6 1.25
EOD
$s4 << EOD
-4.2 -2.35 8.4 4.3
EOD
$s5 << EOD
-1.8 -1.1214
1.8 0.72143
EOD
$s6 << EOD
-2.0512 -1.25

-1.8 -1.1214

1.8 0.72143

2.8326 1.25
EOD
plot $s0 with filledcurves closed fc rgb fade(SKY,0.22) fs solid noborder notitle, \
 $s1 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s2 with lines lc rgb BLUE lw 1.6 dt solid notitle, \
 $s3 with lines lc rgb GREY lw 1.4 dt (6,5) notitle, \
 $s4 with vectors filled head size screen 0.022,18,60 lc rgb RED lw 2.4 dt solid notitle, \
 $s5 with lines lc rgb GREEN lw 5 dt solid notitle, \
 $s6 with points pt 7 ps 0.5 lc rgb INK notitle
