# Draws figure-04.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,398 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 796 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 4.145833 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "figure-04." . format

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
set xrange [-2.86549704:3.32226977]
set yrange [-0.832835184:2.59528983]
set label "{/:Bold S}" at -0.670148268,0.37622959 center offset character -1,-0.7 front tc rgb GREEN
set label "{/:Bold R}" at -0.723153506,1.28281549 center offset character -1.1,0.5 front tc rgb RED
set label "{/:Bold T}" at 0.0713401115,2.17864673 center offset character -0.2,0.9 front tc rgb PINK
set label "|{/:Bold S}·{/:Bold N}|" at 2.35584855,0.487630483 left offset character 0.8,0 front tc rgb GREEN
set label "|{/:Bold R}·{/:Bold N}|" at 2.35584855,1.44889218 left offset character 0.8,0 front tc rgb RED
set label "|{/:Bold T}·{/:Bold N}|" at 2.35584855,2.16983845 left offset character 0.8,0 front tc rgb PINK
set label "" at 3.04100764,2.22994385 center offset character 0,0 front tc rgb INK
set label "{/:Italic Q}" at 0,1.10545095 center offset character 0.9,0.4 front tc rgb INK
set label "{/:Italic r}_{eff}" at 0,0.840142722 center offset character 1.8,0 front tc rgb INK
set label "{/:Italic C}" at -0.223382756,-0.00275836287 center offset character 0.2,-0.9 front tc rgb INK
set label "{/:Italic E}" at -2.35584855,-0.103125805 right offset character -0.7,0 front tc rgb BLUE
set label "{/:Italic E}′" at -2.35584855,1.00232515 right offset character -0.7,0 front tc rgb GREY
set label "" at -2.58423492,-0.0750978518 center offset character 0,0 front tc rgb INK
set label "{/:Bold N}" at -1.98010075,0.695201821 center offset character 1.5,-0.3 front tc rgb INK
$s0 << EOD
-2.3558 -0.10313
1.2983 -0.55157
2.3558 0.10313
-1.2983 0.55157
EOD
$s1 << EOD
-2.3558 -0.10313
1.2983 -0.55157
2.3558 0.10313
-1.2983 0.55157
-2.3558 -0.10313
EOD
$s2 << EOD
-0.81283 -0.23214
0.080703 -0.22111
1.1169 0.013792
0.81283 0.23214
-0.080703 0.22111
-1.1169 -0.013792
-0.81283 -0.23214
EOD
$s3 << EOD
-0.22338 -0.0027584
0.81283 1.3857

-0.080703 2.1436
0.81283 1.3857

0.81283 1.3857
1.1169 1.4557
EOD
$s4 << EOD
-1.1169 0.75522
-0.81283 0.82524
0.22338 2.2137
-0.080703 2.1436
EOD
$s5 << EOD
-1.1169 0.75522
-0.22338 -0.0027584
0.080703 0.067269
-0.81283 0.82524
EOD
$s6 << EOD
-0.81283 0.82524
0.22338 2.2137
1.1169 1.4557
0.080703 0.067269
EOD
$s7 << EOD
-1.1169 0.75522
-0.080703 2.1436

-0.81283 0.82524
0.22338 2.2137

0.080703 0.067269
1.1169 1.4557

-1.1169 0.75522
-0.22338 -0.0027584

-0.81283 0.82524
0.080703 0.067269

0.22338 2.2137
1.1169 1.4557

-1.1169 0.75522
-0.81283 0.82524

-0.080703 2.1436
0.22338 2.2137

-0.22338 -0.0027584
0.080703 0.067269
EOD
$s8 << EOD
-2.3558 1.0023
1.2983 0.55388
2.3558 1.2086
-1.2983 1.657
EOD
$s9 << EOD
-2.3558 1.0023
1.2983 0.55388
2.3558 1.2086
-1.2983 1.657
-2.3558 1.0023
EOD
$s10 << EOD
-1.1169 0.75522 1.0362 1.3884
EOD
$s11 << EOD
-1.1169 0.75522 0.89353 -0.75798
EOD
$s12 << EOD
0 1.1055
0 0
EOD
$s13 << EOD
-0.080703 2.1436 0.30409 0.070027
EOD
$s14 << EOD
-1.9801 -0.073808 0 0.76901
EOD
$s15 << EOD
2.3558 0.10313
2.3558 0.87214
EOD
$s16 << EOD
2.3558 0.87214
2.3558 2.0256
EOD
$s17 << EOD
2.3558 2.0256
2.3558 2.314
EOD
$s18 << EOD
0 0

-0.22338 -0.0027584

0 1.1055
EOD
plot $s0 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s1 with lines lc rgb BLUE lw 1.2 dt solid notitle, \
 $s2 with filledcurves closed fc rgb SHADOW fs solid noborder notitle, \
 $s3 with lines lc rgb GREY lw 1 dt (6,5) notitle, \
 $s4 with filledcurves closed fc rgb tone(0x80E9B141) fs solid noborder notitle, \
 $s5 with filledcurves closed fc rgb tone(0x808F6C27) fs solid noborder notitle, \
 $s6 with filledcurves closed fc rgb tone(0x80BD8F33) fs solid noborder notitle, \
 $s7 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s8 with filledcurves closed fc rgb fade(FLOOR,0) fs solid noborder notitle, \
 $s9 with lines lc rgb GREY lw 1.2 dt (6,5) notitle, \
 $s10 with vectors filled head size screen 0.022,18,60 lc rgb RED lw 2.4 dt solid notitle, \
 $s11 with vectors filled head size screen 0.022,18,60 lc rgb GREEN lw 2.4 dt solid notitle, \
 $s12 with lines lc rgb INK lw 2 dt solid notitle, \
 $s13 with vectors filled head size screen 0.022,18,60 lc rgb PINK lw 2.4 dt solid notitle, \
 $s14 with vectors filled head size screen 0.022,18,60 lc rgb INK lw 2.4 dt solid notitle, \
 $s15 with lines lc rgb GREEN lw 4 dt solid notitle, \
 $s16 with lines lc rgb RED lw 4 dt solid notitle, \
 $s17 with lines lc rgb PINK lw 4 dt solid notitle, \
 $s18 with points pt 7 ps 0.5 lc rgb INK notitle
