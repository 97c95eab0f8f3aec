# Draws frustum.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,622 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 1244 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 6.479167 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "frustum." . format

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
set xrange [-0.232628949:7.98692725]
set yrange [-2.5509366:4.55584303]
set label "" at 3.8502169,0.702279466 center offset character 0,0 front tc rgb INK
set label "" at 5.19409654,-1.002932 center offset character 0,0 front tc rgb INK
set label "{/:Italic E}·{/:Italic Q} < −{/:Italic r}_{eff}" at 1.59907215,3.48952753 center offset character 0,0.9 front tc rgb INK
set label "" at 2.28991656,2.71693201 center offset character 0,0 front tc rgb INK
set label "{/:Italic E}·{/:Italic Q} < −{/:Italic r}_{eff}" at 7.06345389,1.67544472 center offset character 0,0.9 front tc rgb INK
set label "" at 7.7542983,0.902849203 center offset character 0,0 front tc rgb INK
set label "" at 5.87088394,3.70804111 center offset character 0,0 front tc rgb INK
$s0 << EOD
1.0341 0.5133
1.3135 -0.46366
6.5675 -2.3183
5.1703 2.5665
EOD
$s1 << EOD
1.0341 0.5133
1.3135 -0.46366
6.5675 -2.3183
5.1703 2.5665
1.0341 0.5133
EOD
$s2 << EOD
5.1703 2.5665
6.5675 -2.3183
6.5675 -0.71239
5.1703 4.1724
EOD
$s3 << EOD
5.1703 2.5665
6.5675 -2.3183
6.5675 -0.71239
5.1703 4.1724
5.1703 2.5665
EOD
$s4 << EOD
6.6677 2.9075
3.8213 3.6116
3.8213 4.1469
6.6677 3.4428
EOD
$s5 << EOD
6.6677 3.4428
6.7467 3.619
3.9003 4.3232
3.8213 4.1469
EOD
$s6 << EOD
6.6677 2.9075
6.6677 3.4428
6.7467 3.619
6.7467 3.0837
EOD
$s7 << EOD
6.6677 2.9075
6.7467 3.0837

6.6677 3.4428
6.7467 3.619

3.8213 4.1469
3.9003 4.3232

6.6677 2.9075
3.8213 3.6116

6.6677 3.4428
3.8213 4.1469

6.7467 3.619
3.9003 4.3232

6.6677 2.9075
6.6677 3.4428

6.7467 3.0837
6.7467 3.619

3.8213 3.6116
3.8213 4.1469
EOD
$s8 << EOD
1.5916 1.8909
1.0765 2.4394
1.0765 2.9747
1.5916 2.4262
EOD
$s9 << EOD
1.5916 1.8909
1.5916 2.4262
2.3296 2.8091
2.3296 2.2738
EOD
$s10 << EOD
1.5916 2.4262
2.3296 2.8091
1.8144 3.3575
1.0765 2.9747
EOD
$s11 << EOD
1.5916 1.8909
2.3296 2.2738

1.5916 2.4262
2.3296 2.8091

1.0765 2.9747
1.8144 3.3575

1.5916 1.8909
1.0765 2.4394

1.5916 2.4262
1.0765 2.9747

2.3296 2.8091
1.8144 3.3575

1.5916 1.8909
1.5916 2.4262

2.3296 2.2738
2.3296 2.8091

1.0765 2.4394
1.0765 2.9747
EOD
$s12 << EOD
3.2204 -0.077252
2.6993 0.37382
2.6993 0.90913
3.2204 0.45805
EOD
$s13 << EOD
3.2204 -0.077252
3.2204 0.45805
3.8274 0.84533
3.8274 0.31002
EOD
$s14 << EOD
3.2204 0.45805
3.8274 0.84533
3.3063 1.2964
2.6993 0.90913
EOD
$s15 << EOD
0 0
1.0341 0.5133
EOD
$s16 << EOD
6.8758 0.088666
6.6017 0.72573
6.6017 1.3279
6.8758 0.69088
EOD
$s17 << EOD
0 0
1.0341 0.83448
EOD
$s18 << EOD
6.8758 0.088666
6.8758 0.69088
7.7331 0.89456
7.7331 0.29234
EOD
$s19 << EOD
3.2204 -0.077252
3.8274 0.31002

3.2204 0.45805
3.8274 0.84533

2.6993 0.90913
3.3063 1.2964

3.2204 -0.077252
2.6993 0.37382

3.2204 0.45805
2.6993 0.90913

3.8274 0.84533
3.3063 1.2964

3.2204 -0.077252
3.2204 0.45805

3.8274 0.31002
3.8274 0.84533

2.6993 0.37382
2.6993 0.90913
EOD
$s20 << EOD
6.8758 0.69088
7.7331 0.89456
7.459 1.5316
6.6017 1.3279
EOD
$s21 << EOD
0 0
1.3135 -0.46366

0 0
1.3135 -0.14248
EOD
$s22 << EOD
6.8758 0.088666
7.7331 0.29234

6.8758 0.69088
7.7331 0.89456

6.6017 1.3279
7.459 1.5316

6.8758 0.088666
6.6017 0.72573

6.8758 0.69088
6.6017 1.3279

7.7331 0.89456
7.459 1.5316

6.8758 0.088666
6.8758 0.69088

7.7331 0.29234
7.7331 0.89456

6.6017 0.72573
6.6017 1.3279
EOD
$s23 << EOD
4.3476 -1.8521
3.9495 -1.1704
3.9495 -0.63505
4.3476 -1.3168
EOD
$s24 << EOD
4.3476 -1.3168
5.2649 -1.0209
4.8668 -0.3392
3.9495 -0.63505
EOD
$s25 << EOD
4.3476 -1.8521
4.3476 -1.3168
5.2649 -1.0209
5.2649 -1.5562
EOD
$s26 << EOD
4.3476 -1.8521
5.2649 -1.5562

4.3476 -1.3168
5.2649 -1.0209

3.9495 -0.63505
4.8668 -0.3392

4.3476 -1.8521
3.9495 -1.1704

4.3476 -1.3168
3.9495 -0.63505

5.2649 -1.0209
4.8668 -0.3392

4.3476 -1.8521
4.3476 -1.3168

5.2649 -1.5562
5.2649 -1.0209

3.9495 -1.1704
3.9495 -0.63505
EOD
$s27 << EOD
1.0341 0.83448
5.1703 4.1724
EOD
$s28 << EOD
1.0341 0.5133
1.3135 -0.46366
1.3135 -0.14248
1.0341 0.83448
EOD
$s29 << EOD
1.0341 0.5133
1.3135 -0.46366
1.3135 -0.14248
1.0341 0.83448
1.0341 0.5133

1.3135 -0.14248
6.5675 -0.71239
EOD
$s30 << EOD
0 0
EOD
plot $s0 with filledcurves closed fc rgb fade(SKY,0.3) fs solid noborder notitle, \
 $s1 with lines lc rgb BLUE lw 1.4 dt solid notitle, \
 $s2 with filledcurves closed fc rgb fade(SKY,0.18) fs solid noborder notitle, \
 $s3 with lines lc rgb BLUE lw 1.4 dt solid notitle, \
 $s4 with filledcurves closed fc rgb tone(0x00D3A039) fs solid border lc rgb tone(0x00D3A039) lw 1.1 notitle, \
 $s5 with filledcurves closed fc rgb tone(0x00D9A53B) fs solid border lc rgb tone(0x00D9A53B) lw 1.1 notitle, \
 $s6 with filledcurves closed fc rgb tone(0x00947028) fs solid border lc rgb tone(0x00947028) lw 1.1 notitle, \
 $s7 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s8 with filledcurves closed fc rgb tone(0x00ACACAC) fs solid border lc rgb tone(0x00ACACAC) lw 1.1 notitle, \
 $s9 with filledcurves closed fc rgb tone(0x00A7A7A7) fs solid border lc rgb tone(0x00A7A7A7) lw 1.1 notitle, \
 $s10 with filledcurves closed fc rgb tone(0x00C1C1C1) fs solid border lc rgb tone(0x00C1C1C1) lw 1.1 notitle, \
 $s11 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s12 with filledcurves closed fc rgb tone(0x0000805D) fs solid border lc rgb tone(0x0000805D) lw 1.1 notitle, \
 $s13 with filledcurves closed fc rgb tone(0x00007656) fs solid border lc rgb tone(0x00007656) lw 1.1 notitle, \
 $s14 with filledcurves closed fc rgb tone(0x00008D66) fs solid border lc rgb tone(0x00008D66) lw 1.1 notitle, \
 $s15 with lines lc rgb GREY lw 1.2 dt (6,5) notitle, \
 $s16 with filledcurves closed fc rgb tone(0x009D9D9D) fs solid border lc rgb tone(0x009D9D9D) lw 1.1 notitle, \
 $s17 with lines lc rgb GREY lw 1.2 dt (6,5) notitle, \
 $s18 with filledcurves closed fc rgb tone(0x00B3B3B3) fs solid border lc rgb tone(0x00B3B3B3) lw 1.1 notitle, \
 $s19 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s20 with filledcurves closed fc rgb tone(0x00C1C1C1) fs solid border lc rgb tone(0x00C1C1C1) lw 1.1 notitle, \
 $s21 with lines lc rgb GREY lw 1.2 dt (6,5) notitle, \
 $s22 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s23 with filledcurves closed fc rgb tone(0x00007656) fs solid border lc rgb tone(0x00007656) lw 1.1 notitle, \
 $s24 with filledcurves closed fc rgb tone(0x00008D66) fs solid border lc rgb tone(0x00008D66) lw 1.1 notitle, \
 $s25 with filledcurves closed fc rgb tone(0x0000805D) fs solid border lc rgb tone(0x0000805D) lw 1.1 notitle, \
 $s26 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s27 with lines lc rgb BLUE lw 1.4 dt solid notitle, \
 $s28 with filledcurves closed fc rgb fade(SKY,0.18) fs solid noborder notitle, \
 $s29 with lines lc rgb BLUE lw 1.4 dt solid notitle, \
 $s30 with points pt 7 ps 0.5 lc rgb INK notitle
