# Draws signs.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 900,524 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1800,magnify * 1048 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 9.375000,magnify * 5.458333 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "signs." . format

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
set xrange [-3.47019622:3.47019622]
set yrange [-1.6964262:2.3520854]
set label "{/:Italic Q}" at -1.45544359,0.42739281 center offset character 0.9,0.5 front tc rgb INK
set label "one common sign" at -1.45544359,-1.5 center offset character 0,0 front tc rgb PINK
set label "{/:Italic Q}" at 1.45544359,1.02805078 center offset character 0.9,0.5 front tc rgb INK
set label "three signs of their own" at 1.45544359,-1.5 center offset character 0,0 front tc rgb GREEN
$s0 << EOD
-3.2738 -0.17653
2.548 -0.52768
3.2738 0.17653
-2.548 0.52768
EOD
$s1 << EOD
-3.2738 -0.17653
2.548 -0.52768
3.2738 0.17653
-2.548 0.52768
-3.2738 -0.17653
EOD
$s2 << EOD
-2.1097 -0.14701
-1.2367 -0.099936
-0.36419 0.14663
-0.80121 0.32259
-1.6742 0.27551
-2.5467 0.028948
-2.1097 -0.14701

0.80121 -0.32259
1.6742 -0.27551
2.5467 -0.028948
2.1097 0.14701
1.2367 0.099936
0.36419 -0.14663
0.80121 -0.32259
EOD
$s3 << EOD
-1.6737 -0.70022
-0.80121 0.71071

-1.6742 1.4399
-0.80121 0.71071

-0.80121 0.71071
-0.36419 0.82584

1.2372 -0.099558
2.1097 1.3114

1.2367 2.0405
2.1097 1.3114

2.1097 1.3114
2.5467 1.4265
EOD
$s4 << EOD
-2.5467 0.028948
-2.1097 0.14408
-1.2372 1.555
-1.6742 1.4399
EOD
$s5 << EOD
-2.5467 0.028948
-1.6737 -0.70022
-1.2367 -0.58508
-2.1097 0.14408
EOD
$s6 << EOD
-2.1097 0.14408
-1.2372 1.555
-0.36419 0.82584
-1.2367 -0.58508
EOD
$s7 << EOD
-2.5467 0.028948
-1.6742 1.4399

-2.1097 0.14408
-1.2372 1.555

-1.2367 -0.58508
-0.36419 0.82584

-2.5467 0.028948
-1.6737 -0.70022

-2.1097 0.14408
-1.2367 -0.58508

-1.2372 1.555
-0.36419 0.82584

-2.5467 0.028948
-2.1097 0.14408

-1.6742 1.4399
-1.2372 1.555

-1.6737 -0.70022
-1.2367 -0.58508
EOD
$s8 << EOD
0.36419 0.62961
0.80121 0.74474
1.6737 2.1557
1.2367 2.0405
EOD
$s9 << EOD
0.36419 0.62961
1.2372 -0.099558
1.6742 0.015574
0.80121 0.74474
EOD
$s10 << EOD
0.80121 0.74474
1.6737 2.1557
2.5467 1.4265
1.6742 0.015574
EOD
$s11 << EOD
0.36419 0.62961
1.2367 2.0405

0.80121 0.74474
1.6737 2.1557

1.6742 0.015574
2.5467 1.4265

0.36419 0.62961
1.2372 -0.099558

0.80121 0.74474
1.6742 0.015574

1.6737 2.1557
2.5467 1.4265

0.36419 0.62961
0.80121 0.74474

1.2367 2.0405
1.6737 2.1557

1.2372 -0.099558
1.6742 0.015574
EOD
$s12 << EOD
-2.5467 0.028948
-1.7823 -0.12936
-0.87314 0.0028001
-1.092 0.2404
EOD
$s13 << EOD
-2.5467 0.028948
-1.7823 -0.12936
-0.87314 0.0028001
-1.092 0.2404
-2.5467 0.028948
EOD
$s14 << EOD
-0.36419 0.82584
EOD
$s15 << EOD
2.1097 1.3114
EOD
$s16 << EOD
-1.4554 0.42739
EOD
$s17 << EOD
-2.5467 0.028948
EOD
$s18 << EOD
1.2367 2.0405

1.2372 -0.099558

2.5467 1.4265
EOD
$s19 << EOD
1.4554 1.0281
EOD
$s20 << EOD
0.36419 0.62961

1.6737 2.1557

1.6742 0.015574

0.80121 0.74474
EOD
plot $s0 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s1 with lines lc rgb BLUE lw 1.2 dt solid notitle, \
 $s2 with filledcurves closed fc rgb SHADOW fs solid noborder notitle, \
 $s3 with lines lc rgb GREY lw 1 dt (6,5) notitle, \
 $s4 with filledcurves closed fc rgb tone(0x80E9B141) fs solid noborder notitle, \
 $s5 with filledcurves closed fc rgb tone(0x808F6C27) fs solid noborder notitle, \
 $s6 with filledcurves closed fc rgb tone(0x80BD8F33) fs solid noborder notitle, \
 $s7 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s8 with filledcurves closed fc rgb tone(0x80E9B141) fs solid noborder notitle, \
 $s9 with filledcurves closed fc rgb tone(0x808F6C27) fs solid noborder notitle, \
 $s10 with filledcurves closed fc rgb tone(0x80BD8F33) fs solid noborder notitle, \
 $s11 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s12 with filledcurves closed fc rgb fade(PINK,0.45) fs solid noborder notitle, \
 $s13 with lines lc rgb PINK lw 2 dt solid notitle, \
 $s14 with points pt 7 ps 0.5 lc rgb PINK notitle, \
 $s15 with points pt 7 ps 0.5 lc rgb GREEN notitle, \
 $s16 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s17 with points pt 7 ps 0.5 lc rgb PINK notitle, \
 $s18 with points pt 7 ps 0.5 lc rgb GREEN notitle, \
 $s19 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s20 with points pt 7 ps 0.5 lc rgb GREEN notitle
