# Draws figure-13-animated.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
set output "figure-13-animated." . format

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
if (format eq "gif") {
  set terminal gif animate delay 4 loop 0 optimize enhanced size 720,530 font "DejaVu Serif,13" background rgb "#ffffff"
  set output "figure-13-animated.gif"
}
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
if (format eq "gif") { set xtics font ",12"; set ytics font ",12" }
$trail << EOD
0 25
0 25
0.04 23.0098
0.07 21.5275
0.08 21.0354
0.12 19.0766
0.14 18.1031
0.16 17.1336
0.2 15.2062
0.21 14.7268
0.24 13.2946
0.28 11.3987
0.28 11.3987
0.32 9.5185
0.36 7.65401
0.36 7.65401
0.4 5.80524
0.44 3.97218
0.44 3.97218
0.48 2.15483
0.52 0.353196
0.52 0.353196
0.53 0
0.56 0.555564
0.57 0.738395
0.6 1.27982
0.62 1.63488
0.64 1.98522
0.67 2.5019
0.68 2.67176
0.72 3.33946
0.72 3.33946
0.76 3.98829
0.77 4.14756
0.8 4.61827
0.82 4.9262
0.84 5.2294
0.87 5.67538
0.88 5.82168
0.92 6.3951
0.92 6.3951
0.96 6.94966
0.97 7.08536
1 7.48537
1.02 7.74616
1.04 8.00223
1.07 8.3775
1.08 8.50023
1.12 8.97938
1.12 8.97938
1.16 9.43967
1.17 9.5518
1.2 9.88111
1.22 10.0948
1.24 10.3037
1.27 10.6083
1.28 10.7074
1.32 11.0923
1.32 11.0923
1.36 11.4583
1.37 11.5469
1.4 11.8055
1.42 11.972
1.44 12.1338
1.47 12.3677
1.48 12.4433
1.52 12.7339
1.52 12.7339
1.56 13.0056
1.57 13.0706
1.6 13.2585
1.62 13.3779
1.64 13.4925
1.67 13.6557
1.68 13.7077
1.72 13.9041
1.72 13.9041
1.76 14.0815
1.77 14.123
1.8 14.2402
1.82 14.3124
1.84 14.3799
1.87 14.4724
1.88 14.5008
1.92 14.6029
1.92 14.6029
1.96 14.6861
1.97 14.704
2 14.7505
2.02 14.7756
2.04 14.7959
2.07 14.8177
2.08 14.8226
2.12 14.8304
2.12 14.8304
2.16 14.8193
2.17 14.8136
2.2 14.7894
2.22 14.7674
2.24 14.7406
2.27 14.6917
2.28 14.673
2.32 14.5865
2.32 14.5865
2.36 14.4812
2.37 14.4519
2.4 14.357
2.42 14.2878
2.44 14.2139
2.47 14.0943
2.48 14.052
2.52 13.8713
2.52 13.8713
2.56 13.6716
2.57 13.6188
2.6 13.4532
2.62 13.3369
2.64 13.2159
2.66 13.0901
2.68 12.9597
2.71 12.7552
2.72 12.6847
2.76 12.3908
2.76 12.3908
2.8 12.078
2.81 11.9969
2.84 11.7464
2.86 11.5736
2.88 11.396
2.91 11.1208
2.92 11.0267
2.96 10.6385
2.96 10.6385
3 10.2315
3.01 10.1268
3.04 9.80567
3.05 9.69625
3.08 9.36095
3.1 9.13152
3.12 8.89738
3.15 8.53732
3.16 8.41495
3.2 7.91367
3.2 7.91367
3.24 7.39353
3.25 7.26055
3.28 6.85454
3.3 6.57797
3.32 6.2967
3.34 6.0107
3.36 5.72
3.39 5.2751
3.4 5.12444
3.44 4.51003
3.44 4.51003
3.48 3.87677
3.48 3.87677
3.52 3.22466
3.53 3.05868
3.56 2.55368
3.59 2.03808
3.6 1.86386
3.64 1.15518
3.64 1.15518
3.68 0.427644
3.7 0.0568064
3.71 0
3.72 0
3.76 0
3.8 0
3.84 0
3.88 0
3.92 0
3.96 0
4 0
4.04 0
4.08 0
4.12 0
4.16 0
4.2 0
4.24 0
4.28 0
4.32 0
4.36 0
4.4 0
4.44 0
4.48 0
4.52 0
4.56 0
4.6 0
4.64 0
4.68 0
4.72 0
4.76 0
4.8 0
4.84 0
4.88 0
4.92 0
4.96 0
5 0
5.04 0
5.08 0
5.12 0
5.16 0
5.2 0
5.24 0
5.28 0
5.32 0
5.36 0
5.4 0
5.44 0
5.48 0
5.52 0
5.56 0
5.6 0
5.64 0
5.68 0
5.72 0
5.76 0
5.8 0
5.84 0
5.88 0
5.92 0
5.96 0
6 0
EOD
$frames << EOD
0 25
0.04 23.0098
0.08 21.0354
0.12 19.0766
0.16 17.1336
0.2 15.2062
0.24 13.2946
0.28 11.3987
0.32 9.5185
0.36 7.65401
0.4 5.80524
0.44 3.97218
0.48 2.15483
0.52 0.353196
0.56 0.555564
0.6 1.27982
0.64 1.98522
0.68 2.67176
0.72 3.33946
0.76 3.98829
0.8 4.61827
0.84 5.2294
0.88 5.82168
0.92 6.3951
0.96 6.94966
1 7.48537
1.04 8.00223
1.08 8.50023
1.12 8.97938
1.16 9.43967
1.2 9.88111
1.24 10.3037
1.28 10.7074
1.32 11.0923
1.36 11.4583
1.4 11.8055
1.44 12.1338
1.48 12.4433
1.52 12.7339
1.56 13.0056
1.6 13.2585
1.64 13.4925
1.68 13.7077
1.72 13.9041
1.76 14.0815
1.8 14.2402
1.84 14.3799
1.88 14.5008
1.92 14.6029
1.96 14.6861
2 14.7505
2.04 14.7959
2.08 14.8226
2.12 14.8304
2.16 14.8193
2.2 14.7894
2.24 14.7406
2.28 14.673
2.32 14.5865
2.36 14.4812
2.4 14.357
2.44 14.2139
2.48 14.052
2.52 13.8713
2.56 13.6716
2.6 13.4532
2.64 13.2159
2.68 12.9597
2.72 12.6847
2.76 12.3908
2.8 12.078
2.84 11.7464
2.88 11.396
2.92 11.0267
2.96 10.6385
3 10.2315
3.04 9.80567
3.08 9.36095
3.12 8.89738
3.16 8.41495
3.2 7.91367
3.24 7.39353
3.28 6.85454
3.32 6.2967
3.36 5.72
3.4 5.12444
3.44 4.51003
3.48 3.87677
3.52 3.22466
3.56 2.55368
3.6 1.86386
3.64 1.15518
3.68 0.427644
3.72 0
3.76 0
3.8 0
3.84 0
3.88 0
3.92 0
3.96 0
4 0
4.04 0
4.08 0
4.12 0
4.16 0
4.2 0
4.24 0
4.28 0
4.32 0
4.36 0
4.4 0
4.44 0
4.48 0
4.52 0
4.56 0
4.6 0
4.64 0
4.68 0
4.72 0
4.76 0
4.8 0
4.84 0
4.88 0
4.92 0
4.96 0
5 0
5.04 0
5.08 0
5.12 0
5.16 0
5.2 0
5.24 0
5.28 0
5.32 0
5.36 0
5.4 0
5.44 0
5.48 0
5.52 0
5.56 0
5.6 0
5.64 0
5.68 0
5.72 0
5.76 0
5.8 0
5.84 0
5.88 0
5.92 0
5.96 0
EOD
if (format eq "gif") {
  do for [k = 0:149] {
    T = 0.04 * k + 1e-9
    plot $obstacle using 1:2 with filledcurves closed fc rgb YELLOW fs solid border lc rgb INK lw 0.8 title obstacle, \
     $trail using ($1 <= T ? $1 : NaN):2 with lines lc rgb RED lw 2 notitle, \
     $frames every ::k::k using 1:2:(BALL_X):(BALL_Y) with ellipses fc rgb BLUE fs solid noborder notitle
  }
} else {
  plot $obstacle using 1:2 with filledcurves closed fc rgb YELLOW fs solid border lc rgb INK lw 0.8 title obstacle
}
