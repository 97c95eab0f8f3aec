# Draws figure-15.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,530 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 1060 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 5.520833 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "figure-15." . format

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
$obstacle << EOD
-0.1 -1
20 -1
20 -1.3
-0.1 -1.3
-0.1 -1
EOD
set lmargin at screen 0.115
set rmargin at screen 0.965
set bmargin at screen 0.15
set tmargin at screen 0.9
set xrange [-1:15]
set yrange [-5:30]
set title "Rigid ball object collides an obstacle in 2D space." offset 0, -0.3
set label 21 "distance" at screen 0.03, 0.525 center rotate by 90 tc rgb INK
set label 22 "time" at screen 0.54, 0.045 center tc rgb INK
set grid
set border 15
set xtics 5 font ",15"
set ytics 5 font ",15"
set key top right box lc rgb PALE width -1 height 0.6 opaque fillcolor rgb PAPER samplen 2.2
obstacle = "obstacle"
path = "trajectory"
BALL_X = 0.593837535
BALL_Y = 2
$path << EOD
0 25
0.07 21.5275
0.14 18.1031
0.21 14.7268
0.28 11.3987
0.36 7.65401
0.44 3.97218
0.52 0.353196
0.53 0
0.57 0.738395
0.62 1.63488
0.67 2.5019
0.72 3.33946
0.77 4.14756
0.82 4.9262
0.87 5.67538
0.92 6.3951
0.97 7.08536
1.02 7.74616
1.07 8.3775
1.12 8.97938
1.17 9.5518
1.22 10.0948
1.27 10.6083
1.32 11.0923
1.37 11.5469
1.42 11.972
1.47 12.3677
1.52 12.7339
1.57 13.0706
1.62 13.3779
1.67 13.6557
1.72 13.9041
1.77 14.123
1.82 14.3124
1.87 14.4724
1.92 14.6029
1.97 14.704
2.02 14.7756
2.07 14.8177
2.12 14.8304
2.17 14.8136
2.22 14.7674
2.27 14.6917
2.32 14.5865
2.37 14.4519
2.42 14.2878
2.47 14.0943
2.52 13.8713
2.57 13.6188
2.62 13.3369
2.66 13.0901
2.71 12.7552
2.76 12.3908
2.81 11.9969
2.86 11.5736
2.91 11.1208
2.96 10.6385
3.01 10.1268
3.05 9.69625
3.1 9.13152
3.15 8.53732
3.2 7.91367
3.25 7.26055
3.3 6.57797
3.34 6.0107
3.39 5.2751
3.44 4.51003
3.48 3.87677
3.53 3.05868
3.59 2.03808
3.64 1.15518
3.7 0.0568064
3.71 0
15 0
EOD
$stamps << EOD
0 25
0.1 20.054
0.2 15.2062
0.3 10.4566
0.4 5.80524
0.5 1.25205
0.6 1.27982
0.7 3.00797
0.8 4.61827
0.9 6.11074
1 7.48537
1.1 8.74216
1.2 9.88111
1.3 10.9022
1.4 11.8055
1.5 12.5909
1.6 13.2585
1.7 13.8082
1.8 14.2402
1.9 14.5542
2 14.7505
2.1 14.8288
2.2 14.7894
2.3 14.6321
2.4 14.357
2.5 13.964
2.6 13.4532
2.7 12.8245
2.8 12.078
2.9 11.2137
3 10.2315
3.1 9.13152
3.2 7.91367
3.3 6.57797
3.4 5.12444
3.5 3.55307
3.6 1.86386
3.7 0.0568064
EOD
$ball << EOD
3.7 0.0568064
EOD
set label 1 "fast" at 0.556,20.3604912 left tc rgb INK
set label 2 "slow" at 3.365,11.8737416 left tc rgb INK
plot $obstacle using 1:2 with filledcurves closed fc rgb YELLOW fs solid border lc rgb INK lw 0.8 title obstacle, \
     $path using 1:2 with lines lc rgb RED lw 2 notitle, \
     $stamps using 1:2:(BALL_X):(BALL_Y) with ellipses fc rgb fade(BLUE,0.28) fs solid border lc rgb BLUE lw 0.7 notitle, \
     $ball using 1:2:(BALL_X):(BALL_Y) with ellipses fc rgb BLUE fs solid noborder notitle
