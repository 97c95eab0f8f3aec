# Draws sixteen-numbers.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 560,197 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1120,magnify * 394 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 5.833333,magnify * 2.052083 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "sixteen-numbers." . format

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
set xrange [-4.50305296:11.2557007]
set yrange [-4.45305296:1.09285506]
set label "{/:Italic s} = 0" at 0,-4.15 center offset character 0,0 front tc rgb INK
set label "0.25" at 2.5,-4.15 center offset character 0,0 front tc rgb INK
set label "0.5" at 5,-4.15 center offset character 0,0 front tc rgb INK
set label "0.75" at 7.5,-4.15 center offset character 0,0 front tc rgb INK
set label "1" at 10,-4.15 center offset character 0,0 front tc rgb INK
set label "numbers" at -1.4,-2.77555756e-17 right offset character 0,0 front tc rgb PINK
set label "angle" at -1.4,-2.7 right offset character 0,0 front tc rgb ORANGE
$s0 << EOD
7.9763 -0.39998
7.8224 -0.61141
7.8224 0.25462
7.9763 0.46605

2.8224 -0.61141
2.9763 -0.39998
2.9763 0.46605
2.8224 0.25462
EOD
$s1 << EOD
5.1321 -3.6093
5.1321 -2.7433
5.7136 -1.9446
5.7136 -2.8106
EOD
$s2 << EOD
7.4514 -3.6133
7.4514 -2.7473
6.7329 -1.9769
6.7329 -2.8429
EOD
$s3 << EOD
7.8224 -0.61141
7.8224 0.25462
7.0237 0.39998
7.0237 -0.46605

2.0237 -0.46605
2.0237 0.39998
2.8224 0.25462
2.8224 -0.61141
EOD
$s4 << EOD
8.2671 -2.5571
7.5486 -1.7867
6.7329 -1.9769
7.4514 -2.7473
EOD
$s5 << EOD
7.9763 0.46605
7.1776 0.61141
7.0237 0.39998
7.8224 0.25462
EOD
$s6 << EOD
-0.95265 -2.3331
0.64483 -2.6238
0.95265 -2.2009
-0.64483 -1.9102

1.9198 -2.6505
3.4605 -2.2913
3.0802 -1.8835
1.5395 -2.2427

5.1321 -2.7433
5.7136 -1.9446
4.8679 -1.7907
4.2864 -2.5894

10.953 -2.2009
9.3552 -1.9102
9.0474 -2.3331
10.645 -2.6238
EOD
$s7 << EOD
-0.95265 0.36694
0.64483 0.076223
0.95265 0.49908
-0.64483 0.7898

2.0237 0.39998
2.8224 0.25462
2.9763 0.46605
2.1776 0.61141
EOD
$s8 << EOD
5 0.43301
5 0.43301
5 0.43301
5 0.43301
EOD
$s9 << EOD
5 0.43301
5 0.43301

5 0.43301
5 0.43301

5 0.43301
5 0.43301

5 0.43301
5 0.43301
EOD
$s10 << EOD
10.953 0.49908
9.3552 0.7898
9.0474 0.36694
10.645 0.076223
EOD
$s11 << EOD
10.953 -3.0669
10.645 -3.4898
10.645 -2.6238
10.953 -2.2009

0.64483 -3.4898
0.95265 -3.0669
0.95265 -2.2009
0.64483 -2.6238
EOD
$s12 << EOD
0.64483 -0.7898
0.95265 -0.36694
0.95265 0.49908
0.64483 0.076223

10.953 -0.36694
10.645 -0.7898
10.645 0.076223
10.953 0.49908
EOD
$s13 << EOD
1.9198 -3.5165
1.5395 -3.1087
1.5395 -2.2427
1.9198 -2.6505
EOD
$s14 << EOD
1.9198 -3.5165
1.9198 -2.6505
3.4605 -2.2913
3.4605 -3.1573
EOD
$s15 << EOD
-0.95265 -0.49908
-0.95265 0.36694
0.64483 0.076223
0.64483 -0.7898
EOD
$s16 << EOD
-0.95265 -3.1991
-0.95265 -2.3331
0.64483 -2.6238
0.64483 -3.4898

10.645 -3.4898
10.645 -2.6238
9.0474 -2.3331
9.0474 -3.1991
EOD
$s17 << EOD
10.645 -0.7898
10.645 0.076223
9.0474 0.36694
9.0474 -0.49908
EOD
$s18 << EOD
7.8224 -0.61141
7.0237 -0.46605

7.9763 0.46605
7.1776 0.61141

7.8224 0.25462
7.0237 0.39998

7.9763 -0.39998
7.8224 -0.61141

7.9763 0.46605
7.8224 0.25462

7.1776 0.61141
7.0237 0.39998

7.9763 -0.39998
7.9763 0.46605

7.8224 -0.61141
7.8224 0.25462

7.0237 -0.46605
7.0237 0.39998

2.0237 -0.46605
2.8224 -0.61141

2.0237 0.39998
2.8224 0.25462

2.1776 0.61141
2.9763 0.46605

2.0237 0.39998
2.1776 0.61141

2.8224 -0.61141
2.9763 -0.39998

2.8224 0.25462
2.9763 0.46605

2.0237 -0.46605
2.0237 0.39998

2.8224 -0.61141
2.8224 0.25462

2.9763 -0.39998
2.9763 0.46605
EOD
$s19 << EOD
8.2671 -3.4231
7.4514 -3.6133
7.4514 -2.7473
8.2671 -2.5571
EOD
$s20 << EOD
5.1321 -3.6093
4.2864 -3.4554
4.2864 -2.5894
5.1321 -2.7433
EOD
$s21 << EOD
-0.95265 -0.49908
0.64483 -0.7898

-0.95265 0.36694
0.64483 0.076223

-0.64483 0.7898
0.95265 0.49908

-0.95265 0.36694
-0.64483 0.7898

0.64483 -0.7898
0.95265 -0.36694

0.64483 0.076223
0.95265 0.49908

-0.95265 -0.49908
-0.95265 0.36694

0.64483 -0.7898
0.64483 0.076223

0.95265 -0.36694
0.95265 0.49908

-0.95265 -3.1991
0.64483 -3.4898

-0.95265 -2.3331
0.64483 -2.6238

-0.64483 -1.9102
0.95265 -2.2009

-0.95265 -2.3331
-0.64483 -1.9102

0.64483 -3.4898
0.95265 -3.0669

0.64483 -2.6238
0.95265 -2.2009

-0.95265 -3.1991
-0.95265 -2.3331

0.64483 -3.4898
0.64483 -2.6238

0.95265 -3.0669
0.95265 -2.2009

10.645 -3.4898
9.0474 -3.1991

10.953 -2.2009
9.3552 -1.9102

10.645 -2.6238
9.0474 -2.3331

10.953 -3.0669
10.645 -3.4898

10.953 -2.2009
10.645 -2.6238

9.3552 -1.9102
9.0474 -2.3331

10.953 -3.0669
10.953 -2.2009

10.645 -3.4898
10.645 -2.6238

9.0474 -3.1991
9.0474 -2.3331

10.645 -0.7898
9.0474 -0.49908

10.953 0.49908
9.3552 0.7898

10.645 0.076223
9.0474 0.36694

10.953 -0.36694
10.645 -0.7898

10.953 0.49908
10.645 0.076223

9.3552 0.7898
9.0474 0.36694

10.953 -0.36694
10.953 0.49908

10.645 -0.7898
10.645 0.076223

9.0474 -0.49908
9.0474 0.36694

1.9198 -3.5165
3.4605 -3.1573

1.9198 -2.6505
3.4605 -2.2913

1.5395 -2.2427
3.0802 -1.8835

1.9198 -3.5165
1.5395 -3.1087

1.9198 -2.6505
1.5395 -2.2427

3.4605 -2.2913
3.0802 -1.8835

1.9198 -3.5165
1.9198 -2.6505

3.4605 -3.1573
3.4605 -2.2913

1.5395 -3.1087
1.5395 -2.2427

5.1321 -3.6093
5.7136 -2.8106

5.1321 -2.7433
5.7136 -1.9446

4.2864 -2.5894
4.8679 -1.7907

5.1321 -3.6093
4.2864 -3.4554

5.1321 -2.7433
4.2864 -2.5894

5.7136 -1.9446
4.8679 -1.7907

5.1321 -3.6093
5.1321 -2.7433

5.7136 -2.8106
5.7136 -1.9446

4.2864 -3.4554
4.2864 -2.5894

7.4514 -3.6133
6.7329 -2.8429

8.2671 -2.5571
7.5486 -1.7867

7.4514 -2.7473
6.7329 -1.9769

8.2671 -3.4231
7.4514 -3.6133

8.2671 -2.5571
7.4514 -2.7473

7.5486 -1.7867
6.7329 -1.9769

8.2671 -3.4231
8.2671 -2.5571

7.4514 -3.6133
7.4514 -2.7473

6.7329 -2.8429
6.7329 -1.9769
EOD
$s22 << EOD
5 -0.43301
5 0.43301
EOD
$s23 << EOD
7.5486 -1.7867

9.3552 -1.9102

9.3552 0.7898

5.7136 -1.9446

7.1776 0.61141

5 0.43301

3.4605 -2.2913

2.8224 0.25462

0.64483 -2.6238

0.64483 0.076223
EOD
plot $s0 with filledcurves closed fc rgb tone(0x00764661) fs solid border lc rgb tone(0x00764661) lw 1.1 notitle, \
 $s1 with filledcurves closed fc rgb tone(0x008E6B26) fs solid border lc rgb tone(0x008E6B26) lw 1.1 notitle, \
 $s2 with filledcurves closed fc rgb tone(0x00CF9D38) fs solid border lc rgb tone(0x00CF9D38) lw 1.1 notitle, \
 $s3 with filledcurves closed fc rgb tone(0x00AB658C) fs solid border lc rgb tone(0x00AB658C) lw 1.1 notitle, \
 $s4 with filledcurves closed fc rgb tone(0x00D9A53B) fs solid border lc rgb tone(0x00D9A53B) lw 1.1 notitle, \
 $s5 with filledcurves closed fc rgb tone(0x00B56C95) fs solid border lc rgb tone(0x00B56C95) lw 1.1 notitle, \
 $s6 with filledcurves closed fc rgb tone(0x00D9A53B) fs solid border lc rgb tone(0x00D9A53B) lw 1.1 notitle, \
 $s7 with filledcurves closed fc rgb tone(0x00B56C95) fs solid border lc rgb tone(0x00B56C95) lw 1.1 notitle, \
 $s8 with filledcurves closed fc rgb tone(0x00764661) fs solid border lc rgb tone(0x00764661) lw 1.1 notitle, \
 $s9 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s10 with filledcurves closed fc rgb tone(0x00B56C95) fs solid border lc rgb tone(0x00B56C95) lw 1.1 notitle, \
 $s11 with filledcurves closed fc rgb tone(0x008E6B26) fs solid border lc rgb tone(0x008E6B26) lw 1.1 notitle, \
 $s12 with filledcurves closed fc rgb tone(0x00764661) fs solid border lc rgb tone(0x00764661) lw 1.1 notitle, \
 $s13 with filledcurves closed fc rgb tone(0x00CF9D38) fs solid border lc rgb tone(0x00CF9D38) lw 1.1 notitle, \
 $s14 with filledcurves closed fc rgb tone(0x00A57D2D) fs solid border lc rgb tone(0x00A57D2D) lw 1.1 notitle, \
 $s15 with filledcurves closed fc rgb tone(0x00AB658C) fs solid border lc rgb tone(0x00AB658C) lw 1.1 notitle, \
 $s16 with filledcurves closed fc rgb tone(0x00CC9B37) fs solid border lc rgb tone(0x00CC9B37) lw 1.1 notitle, \
 $s17 with filledcurves closed fc rgb tone(0x00AB658C) fs solid border lc rgb tone(0x00AB658C) lw 1.1 notitle, \
 $s18 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s19 with filledcurves closed fc rgb tone(0x00A57D2D) fs solid border lc rgb tone(0x00A57D2D) lw 1.1 notitle, \
 $s20 with filledcurves closed fc rgb tone(0x00CC9B37) fs solid border lc rgb tone(0x00CC9B37) lw 1.1 notitle, \
 $s21 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s22 with lines lc rgb PINK lw 2.4 dt solid notitle, \
 $s23 with points pt 7 ps 0.5 lc rgb INK notitle
