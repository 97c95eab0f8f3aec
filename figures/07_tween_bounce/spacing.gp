# Draws spacing.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,220 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 440 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 2.291667 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "spacing." . format

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
$arch << EOD
0 0
0.015304 0.1188
0.031228 0.2352
0.047794 0.3492
0.065024 0.4608
0.082937 0.57
0.10156 0.6768
0.1209 0.7812
0.14099 0.8832
0.16185 0.9828
0.1835 1.08
0.20596 1.1748
0.22925 1.2672
0.25339 1.3572
0.2784 1.4448
0.30431 1.53
0.33114 1.6128
0.3589 1.6932
0.38761 1.7712
0.41731 1.8468
0.448 1.92
0.47971 1.9908
0.51247 2.0592
0.54628 2.1252
0.58118 2.1888
0.61719 2.25
0.65432 2.3088
0.69259 2.3652
0.73203 2.4192
0.77266 2.4708
0.8145 2.52
0.85757 2.5668
0.90189 2.6112
0.94748 2.6532
0.99436 2.6928
1.0426 2.73
1.0921 2.7648
1.143 2.7972
1.1953 2.8272
1.2489 2.8548
1.304 2.88
1.3605 2.9028
1.4185 2.9232
1.478 2.9412
1.5389 2.9568
1.6014 2.97
1.6655 2.9808
1.7311 2.9892
1.7983 2.9952
1.8671 2.9988
1.9375 3
2.0096 2.9988
2.0833 2.9952
2.1588 2.9892
2.2359 2.9808
2.3148 2.97
2.3955 2.9568
2.4779 2.9412
2.5621 2.9232
2.6481 2.9028
2.736 2.88
2.8257 2.8548
2.9173 2.8272
3.0109 2.7972
3.1063 2.7648
3.2037 2.73
3.303 2.6928
3.4044 2.6532
3.5077 2.6112
3.6131 2.5668
3.7205 2.52
3.83 2.4708
3.9416 2.4192
4.0553 2.3652
4.1711 2.3088
4.2891 2.25
4.4092 2.1888
4.5316 2.1252
4.6561 2.0592
4.7829 1.9908
4.912 1.92
5.0433 1.8468
5.177 1.7712
5.313 1.6932
5.4513 1.6128
5.5919 1.53
5.735 1.4448
5.8805 1.3572
6.0284 1.2672
6.1787 1.1748
6.3315 1.08
6.4868 0.9828
6.6446 0.8832
6.8049 0.7812
6.9678 0.6768
7.1333 0.57
7.3014 0.4608
7.4721 0.3492
7.6454 0.2352
7.8213 0.1188
8 0
EOD
$parameter << EOD
0 0
0.067962 0.47917
0.14786 0.91667
0.24121 1.3125
0.34954 1.6667
0.47436 1.9792
0.61719 2.25
0.77955 2.4792
0.96296 2.6667
1.1689 2.8125
1.399 2.9167
1.6547 2.9792
1.9375 3
2.249 2.9792
2.5906 2.9167
2.9639 2.8125
3.3704 2.6667
3.8116 2.4792
4.2891 2.25
4.8043 1.9792
5.3588 1.6667
5.9541 1.3125
6.5917 0.91667
7.2732 0.47917
8 0
EOD
$length << EOD
0 0
0.062463 0.44463
0.14168 0.88657
0.24421 1.3237
0.38016 1.7514
0.56516 2.1601
0.82136 2.5277
1.167 2.8114
1.586 2.967
2.0329 2.9979
2.4779 2.9412
2.9124 2.8287
3.336 2.6801
3.7502 2.5068
4.1566 2.3159
4.5566 2.112
4.9514 1.8982
5.3419 1.6765
5.7287 1.4485
6.1126 1.2155
6.4938 0.97837
6.8729 0.73772
7.2502 0.49416
7.6258 0.24813
8 0
EOD
unset border
unset tics
unset key
set xrange [-0.4:8.4]
set yrange [-0.35:3.35]
set multiplot
set bmargin at screen 0.27
set tmargin at screen 0.9027
set lmargin at screen 0.02
set rmargin at screen 0.48
set label 1 "equal steps of the parameter" at graph 0.5, -0.2 center tc rgb PINK
plot $arch with lines lc rgb PALE lw 2, $parameter with points pt 7 ps 0.75 lc rgb PINK
set lmargin at screen 0.52
set rmargin at screen 0.98
set label 1 "equal steps of the arc length" at graph 0.5, -0.2 center tc rgb GREEN
plot $arch with lines lc rgb PALE lw 2, $length with points pt 7 ps 0.75 lc rgb GREEN
unset multiplot
