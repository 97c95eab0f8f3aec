# Draws figure-05.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,519 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 1038 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 5.406250 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "figure-05." . format

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
set xrange [-1.10929514:1.87058302]
set yrange [-0.580350539:1.56769593]
set label "{/:Italic Q}_1" at 0.761287881,0.0537689736 center offset character 1.3,-0.2 front tc rgb INK
set label "{/:Bold N}" at -0.716811835,0.346622342 center offset character 1.6,-0.4 front tc rgb INK
set label "{/:Italic E}" at 1.71094669,0.0415537955 left offset character 0.6,0 front tc rgb BLUE
set label "{/:Italic E}′" at 1.71094669,0.497268376 left offset character 0.6,0 front tc rgb GREY
set label "{/:Italic Q}({/:Italic t})" at 0.475804926,0.390251802 center offset character 1.9,0.5 front tc rgb INK
set label "{/:Italic t}{/:Bold V}" at 0.237902463,0.670654159 center offset character 1.3,0.8 front tc rgb RED
set label "{/:Italic Q}_0" at 0,1.4067711 center offset character 0,0.9 front tc rgb INK
set label "{/:Italic C}" at 0.382728778,-0.0667512787 center offset character 0.2,-0.9 front tc rgb INK
$s0 << EOD
-0.94966 -0.14629
1.0449 -0.42071
1.7109 0.041554
-0.28363 0.31597
EOD
$s1 << EOD
-0.94966 -0.14629
1.0449 -0.42071
1.7109 0.041554
-0.28363 0.31597
-0.94966 -0.14629
EOD
$s2 << EOD
-0.33868 -0.10844
0.033626 -0.10329
0.46538 0.0064425
0.33868 0.10844
-0.033626 0.10329
-0.46538 -0.0064425
-0.33868 -0.10844
EOD
$s3 << EOD
0.13713 -0.1739
0.50943 -0.16875
0.94119 -0.05902
0.81448 0.042977
0.44218 0.037823
0.010424 -0.071905
0.13713 -0.1739
EOD
$s4 << EOD
0.38273 -0.066751
0.81448 0.51851

0.44218 0.83037
0.81448 0.51851

0.81448 0.51851
0.94119 0.53539
EOD
$s5 << EOD
0.010424 0.24511
0.13713 0.262
0.56888 0.84725
0.44218 0.83037
EOD
$s6 << EOD
0.010424 0.24511
0.38273 -0.066751
0.50943 -0.049867
0.13713 0.262
EOD
$s7 << EOD
0.13713 0.262
0.56888 0.84725
0.94119 0.53539
0.50943 -0.049867
EOD
$s8 << EOD
0.010424 0.24511
0.44218 0.83037

0.13713 0.262
0.56888 0.84725

0.50943 -0.049867
0.94119 0.53539

0.010424 0.24511
0.38273 -0.066751

0.13713 0.262
0.50943 -0.049867

0.56888 0.84725
0.94119 0.53539

0.010424 0.24511
0.13713 0.262

0.44218 0.83037
0.56888 0.84725

0.38273 -0.066751
0.50943 -0.049867
EOD
$s9 << EOD
-0.94966 0.30942
1.0449 0.035
1.7109 0.49727
-0.28363 0.77169
EOD
$s10 << EOD
-0.94966 0.30942
1.0449 0.035
1.7109 0.49727
-0.28363 0.77169
-0.94966 0.30942
EOD
$s11 << EOD
0.4758 0.39025
0.76129 0.053769
EOD
$s12 << EOD
-0.46538 0.80592
-0.33868 0.8228
0.093076 1.4081
-0.033626 1.3912
EOD
$s13 << EOD
-0.46538 0.80592
-0.093076 0.49405
0.033626 0.51094
-0.33868 0.8228
EOD
$s14 << EOD
-0.71681 -0.10909 0 0.45571
EOD
$s15 << EOD
-0.33868 0.8228
0.093076 1.4081
0.46538 1.0962
0.033626 0.51094
EOD
$s16 << EOD
-0.46538 0.80592
-0.033626 1.3912

-0.33868 0.8228
0.093076 1.4081

0.033626 0.51094
0.46538 1.0962

-0.46538 0.80592
-0.093076 0.49405

-0.33868 0.8228
0.033626 0.51094

0.093076 1.4081
0.46538 1.0962

-0.46538 0.80592
-0.33868 0.8228

-0.033626 1.3912
0.093076 1.4081

-0.093076 0.49405
0.033626 0.51094
EOD
$s17 << EOD
0 0.95106 0.4758 -0.5608
EOD
$s18 << EOD
0.38273 -0.066751
EOD
$s19 << EOD
0 0.95106

0.4758 0.39025

0.76129 0.053769
EOD
plot $s0 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s1 with lines lc rgb BLUE lw 1.2 dt solid notitle, \
 $s2 with filledcurves closed fc rgb fade(SHADOW,0.6) fs solid noborder notitle, \
 $s3 with filledcurves closed fc rgb SHADOW fs solid noborder notitle, \
 $s4 with lines lc rgb GREY lw 1 dt (6,5) notitle, \
 $s5 with filledcurves closed fc rgb tone(0x80E9B141) fs solid noborder notitle, \
 $s6 with filledcurves closed fc rgb tone(0x808F6C27) fs solid noborder notitle, \
 $s7 with filledcurves closed fc rgb tone(0x80BD8F33) fs solid noborder notitle, \
 $s8 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s9 with filledcurves closed fc rgb fade(FLOOR,0) fs solid noborder notitle, \
 $s10 with lines lc rgb GREY lw 1.2 dt (6,5) notitle, \
 $s11 with lines lc rgb RED lw 1.4 dt (6,5) notitle, \
 $s12 with filledcurves closed fc rgb tone(0x00E9B141) fs solid border lc rgb tone(0x00E9B141) lw 1.1 notitle, \
 $s13 with filledcurves closed fc rgb tone(0x008F6C27) fs solid border lc rgb tone(0x008F6C27) lw 1.1 notitle, \
 $s14 with vectors filled head size screen 0.022,18,60 lc rgb INK lw 2.4 dt solid notitle, \
 $s15 with filledcurves closed fc rgb tone(0x00BD8F33) fs solid border lc rgb tone(0x00BD8F33) lw 1.1 notitle, \
 $s16 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s17 with vectors filled head size screen 0.022,18,60 lc rgb RED lw 2.4 dt solid notitle, \
 $s18 with points pt 7 ps 0.5 lc rgb RED notitle, \
 $s19 with points pt 7 ps 0.5 lc rgb INK notitle
