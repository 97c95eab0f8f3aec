# Draws cones.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,537 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 1074 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 5.593750 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "cones." . format

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
set xrange [-3.71:3.71]
set yrange [-1.68:3.86]
set label "{/:Bold c}" at 0,1.35 center offset character -0.9,0.8 front tc rgb INK
set label "{/:Bold x}" at 1.5,-0.27 center offset character 0.2,-1.2 front tc rgb INK
set label "{/:Bold n}" at 2.0080792,1.14133112 center offset character 0.9,0.2 front tc rgb BLUE
set label "{/:Italic d}" at 0.75,0.54 center offset character -0.6,-0.8 front tc rgb RED
set label "{/:Italic θ}" at 2.24518283,1.79995231 center offset character -0.9,0.8 front tc rgb BLUE
$s0 << EOD
2.3 1.35
2.2912 1.5505
2.2651 1.7494
2.2216 1.9453
2.1613 2.1366
2.0845 2.322
1.9919 2.5
1.884 2.6692
1.7619 2.8284
1.6263 2.9763
1.4784 3.1119
1.3192 3.234
1.15 3.3419
0.97202 3.4345
0.78665 3.5113
0.59528 3.5716
0.39939 3.6151
0.20046 3.6412
1.4083e-16 3.65
-0.20046 3.6412
-0.39939 3.6151
-0.59528 3.5716
-0.78665 3.5113
-0.97202 3.4345
-1.15 3.3419
-1.3192 3.234
-1.4784 3.1119
-1.6263 2.9763
-1.7619 2.8284
-1.884 2.6692
-1.9919 2.5
-2.0845 2.322
-2.1613 2.1366
-2.2216 1.9453
-2.2651 1.7494
-2.2912 1.5505
-2.3 1.35
-2.2912 1.1495
-2.2651 0.95061
-2.2216 0.75472
-2.1613 0.56335
-2.0845 0.37798
-1.9919 0.2
-1.884 0.030774
-1.7619 -0.12841
-1.6263 -0.27635
-1.4784 -0.4119
-1.3192 -0.53405
-1.15 -0.64186
-0.97202 -0.73451
-0.78665 -0.81129
-0.59528 -0.87163
-0.39939 -0.91506
-0.20046 -0.94125
-4.225e-16 -0.95
0.20046 -0.94125
0.39939 -0.91506
0.59528 -0.87163
0.78665 -0.81129
0.97202 -0.73451
1.15 -0.64186
1.3192 -0.53405
1.4784 -0.4119
1.6263 -0.27635
1.7619 -0.12841
1.884 0.030774
1.9919 0.2
2.0845 0.37798
2.1613 0.56335
2.2216 0.75472
2.2651 0.95061
2.2912 1.1495
2.3 1.35
EOD
$s1 << EOD
2.3 1.35
2.2912 1.5505
2.2651 1.7494
2.2216 1.9453
2.1613 2.1366
2.0845 2.322
1.9919 2.5
1.884 2.6692
1.7619 2.8284
1.6263 2.9763
1.4784 3.1119
1.3192 3.234
1.15 3.3419
0.97202 3.4345
0.78665 3.5113
0.59528 3.5716
0.39939 3.6151
0.20046 3.6412
1.4083e-16 3.65
-0.20046 3.6412
-0.39939 3.6151
-0.59528 3.5716
-0.78665 3.5113
-0.97202 3.4345
-1.15 3.3419
-1.3192 3.234
-1.4784 3.1119
-1.6263 2.9763
-1.7619 2.8284
-1.884 2.6692
-1.9919 2.5
-2.0845 2.322
-2.1613 2.1366
-2.2216 1.9453
-2.2651 1.7494
-2.2912 1.5505
-2.3 1.35
-2.2912 1.1495
-2.2651 0.95061
-2.2216 0.75472
-2.1613 0.56335
-2.0845 0.37798
-1.9919 0.2
-1.884 0.030774
-1.7619 -0.12841
-1.6263 -0.27635
-1.4784 -0.4119
-1.3192 -0.53405
-1.15 -0.64186
-0.97202 -0.73451
-0.78665 -0.81129
-0.59528 -0.87163
-0.39939 -0.91506
-0.20046 -0.94125
-4.225e-16 -0.95
0.20046 -0.94125
0.39939 -0.91506
0.59528 -0.87163
0.78665 -0.81129
0.97202 -0.73451
1.15 -0.64186
1.3192 -0.53405
1.4784 -0.4119
1.6263 -0.27635
1.7619 -0.12841
1.884 0.030774
1.9919 0.2
2.0845 0.37798
2.1613 0.56335
2.2216 0.75472
2.2651 0.95061
2.2912 1.1495
2.3 1.35
2.3 1.35
EOD
$s2 << EOD
1.5 -0.27
1.8897 1.8952
1.95 1.8835
2.0099 1.8701
2.0695 1.855
2.1285 1.8383
2.1871 1.8199
2.2452 1.8
2.3027 1.7784
2.3595 1.7552
2.4157 1.7304
2.4712 1.704
2.5259 1.6762
2.5798 1.6468
1.5 -0.27
EOD
$s3 << EOD
1.5 -0.27
1.8897 1.8952
1.95 1.8835
2.0099 1.8701
2.0695 1.855
2.1285 1.8383
2.1871 1.8199
2.2452 1.8
2.3027 1.7784
2.3595 1.7552
2.4157 1.7304
2.4712 1.704
2.5259 1.6762
2.5798 1.6468
1.5 -0.27
1.5 -0.27
EOD
$s4 << EOD
0 0
-0.3667 2.1692
-0.30602 2.1786
-0.2451 2.1863
-0.18399 2.1923
-0.12274 2.1966
-0.061395 2.1991
0 2.2
0.061395 2.1991
0.12274 2.1966
0.18399 2.1923
0.2451 2.1863
0.30602 2.1786
0.3667 2.1692
0 0
EOD
$s5 << EOD
0 0
-0.3667 2.1692
-0.30602 2.1786
-0.2451 2.1863
-0.18399 2.1923
-0.12274 2.1966
-0.061395 2.1991
0 2.2
0.061395 2.1991
0.12274 2.1966
0.18399 2.1923
0.2451 2.1863
0.30602 2.1786
0.3667 2.1692
0 0
0 0
EOD
$s6 << EOD
-3.5 -1.47
-3 -1.08
-2.5 -0.75
-2 -0.48
-1.5 -0.27
-1 -0.12
-0.5 -0.03
0 0
0.5 -0.03
1 -0.12
1.5 -0.27
2 -0.48
2.5 -0.75
3 -1.08
3.5 -1.47
EOD
$s7 << EOD
1 -0.12
1.5 -0.27
2 -0.48
EOD
$s8 << EOD
-0.5 -0.03
0 0
0.5 -0.03
EOD
$s9 << EOD
1.5 -0.27 0.50808 1.4113
EOD
$s10 << EOD
1.5 -0.27 -1.5 1.62
EOD
$s11 << EOD
-3.5 -1.47

3.5 -1.47

-3 -1.08

3 -1.08

-2.5 -0.75

2.5 -0.75

-2 -0.48

2 -0.48

-1.5 -0.27

1.5 -0.27

-1 -0.12

1 -0.12

-0.5 -0.03

0.5 -0.03

0 0

0 1.35
EOD
plot $s0 with filledcurves closed fc rgb fade(AMBER,0.35) fs solid noborder notitle, \
 $s1 with lines lc rgb ORANGE lw 1.2 dt solid notitle, \
 $s2 with filledcurves closed fc rgb fade(BLUE,0.2) fs solid noborder notitle, \
 $s3 with lines lc rgb BLUE lw 1 dt solid notitle, \
 $s4 with filledcurves closed fc rgb fade(GREEN,0.2) fs solid noborder notitle, \
 $s5 with lines lc rgb GREEN lw 1 dt solid notitle, \
 $s6 with lines lc rgb INK lw 2 dt solid notitle, \
 $s7 with lines lc rgb BLUE lw 4.5 dt solid notitle, \
 $s8 with lines lc rgb GREEN lw 4.5 dt solid notitle, \
 $s9 with vectors filled head size screen 0.022,18,60 lc rgb BLUE lw 2.4 dt solid notitle, \
 $s10 with vectors filled head size screen 0.022,18,60 lc rgb RED lw 2.2 dt solid notitle, \
 $s11 with points pt 7 ps 0.5 lc rgb INK notitle
