# Draws frustum-above.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,727 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 1454 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 7.572917 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "frustum-above." . format

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
set xrange [-0.236613927:8.03661393]
set yrange [-3.59661393:4.76374484]
set label "" at 4,0.3 center offset character 0,0 front tc rgb INK
set label "" at 4.8,-2.4 center offset character 0,0 front tc rgb INK
set label "{/:Italic E}·{/:Italic Q} < −{/:Italic r}_{eff}" at 2.4,3.6 center offset character 0,0.9 front tc rgb INK
set label "" at 3,3.1 center offset character 0,0 front tc rgb INK
set label "{/:Italic E}·{/:Italic Q} < −{/:Italic r}_{eff}" at 7.2,-0.1 center offset character 0,0.9 front tc rgb INK
set label "" at 7.8,-0.6 center offset character 0,0 front tc rgb INK
set label "" at 6.78,3.66 center offset character 0,0 front tc rgb INK
$s0 << EOD
1.2 0.672
1.2 -0.672
6 -3.36
6 3.36
EOD
$s1 << EOD
1.2 0.672
1.2 -0.672
6 -3.36
6 3.36
1.2 0.672
EOD
$s2 << EOD
6 3.36
6 -3.36
6 -3.36
6 3.36
EOD
$s3 << EOD
6 3.36
6 -3.36
6 -3.36
6 3.36
6 3.36
EOD
$s4 << EOD
0 0
1.2 0.672

0 0
1.2 -0.672

0 0
1.2 -0.672

0 0
1.2 0.672
EOD
$s5 << EOD
3.2407 -0.2428
3.9428 0.14074
3.5593 0.8428
2.8572 0.45926
EOD
$s6 << EOD
3.2407 -0.2428
3.9428 0.14074

2.8572 0.45926
3.5593 0.8428

3.2407 -0.2428
2.8572 0.45926

3.9428 0.14074
3.5593 0.8428
EOD
$s7 << EOD
3.8093 -2.9894
4.7894 -2.7907
4.5907 -1.8106
3.6106 -2.0093
EOD
$s8 << EOD
3.8093 -2.9894
4.7894 -2.7907

3.6106 -2.0093
4.5907 -1.8106

3.8093 -2.9894
3.6106 -2.0093

4.7894 -2.7907
4.5907 -1.8106
EOD
$s9 << EOD
2.1608 2.5103
2.9897 2.8608
2.6392 3.6897
1.8103 3.3392
EOD
$s10 << EOD
2.1608 2.5103
2.9897 2.8608

1.8103 3.3392
2.6392 3.6897

2.1608 2.5103
1.8103 3.3392

2.9897 2.8608
2.6392 3.6897
EOD
$s11 << EOD
7.4103 2.7929
7.5369 3.0085
4.9497 4.5271
4.8231 4.3115
EOD
$s12 << EOD
7.4103 2.7929
7.5369 3.0085

4.8231 4.3115
4.9497 4.5271

7.4103 2.7929
4.8231 4.3115

7.5369 3.0085
4.9497 4.5271
EOD
$s13 << EOD
6.7972 -1.0927
7.6927 -1.0028
7.6028 -0.10732
6.7073 -0.19717
EOD
$s14 << EOD
6.7972 -1.0927
7.6927 -1.0028

6.7073 -0.19717
7.6028 -0.10732

6.7972 -1.0927
6.7073 -0.19717

7.6927 -1.0028
7.6028 -0.10732
EOD
$s15 << EOD
1.2 0.672
1.2 -0.672
1.2 -0.672
1.2 0.672
EOD
$s16 << EOD
1.2 0.672
1.2 -0.672
1.2 -0.672
1.2 0.672
1.2 0.672

1.2 -0.672
6 -3.36

1.2 0.672
6 3.36
EOD
$s17 << EOD
0 0
EOD
plot $s0 with filledcurves closed fc rgb fade(SKY,0.3) fs solid noborder notitle, \
 $s1 with lines lc rgb BLUE lw 1.4 dt solid notitle, \
 $s2 with filledcurves closed fc rgb fade(SKY,0.18) fs solid noborder notitle, \
 $s3 with lines lc rgb BLUE lw 1.4 dt solid notitle, \
 $s4 with lines lc rgb GREY lw 1.2 dt (6,5) notitle, \
 $s5 with filledcurves closed fc rgb tone(0x00008B65) fs solid border lc rgb tone(0x00008B65) lw 1.1 notitle, \
 $s6 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s7 with filledcurves closed fc rgb tone(0x00008B65) fs solid border lc rgb tone(0x00008B65) lw 1.1 notitle, \
 $s8 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s9 with filledcurves closed fc rgb tone(0x00BFBFBF) fs solid border lc rgb tone(0x00BFBFBF) lw 1.1 notitle, \
 $s10 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s11 with filledcurves closed fc rgb tone(0x00D7A33A) fs solid border lc rgb tone(0x00D7A33A) lw 1.1 notitle, \
 $s12 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s13 with filledcurves closed fc rgb tone(0x00BFBFBF) fs solid border lc rgb tone(0x00BFBFBF) lw 1.1 notitle, \
 $s14 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s15 with filledcurves closed fc rgb fade(SKY,0.18) fs solid noborder notitle, \
 $s16 with lines lc rgb BLUE lw 1.4 dt solid notitle, \
 $s17 with points pt 7 ps 0.5 lc rgb INK notitle
