# Draws bsp-tree.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 960,355 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1920,magnify * 710 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 10.000000,magnify * 3.697917 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "bsp-tree." . format

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
set xrange [-0.2784:14.1984]
set yrange [-0.2784:5.0784]
set label "+" at 10.24,3.93 center offset character -0.4,0.4 front tc rgb GREY
set label "−" at 11.96,3.93 center offset character 0.4,0.4 front tc rgb GREY
set label "2" at 11.1,4.35 center offset character 0,0 front tc rgb BLUE
set label "4" at 9.38,3.08 center offset character 0,0 front tc rgb BLUE
set label "5" at 8.52,1.81 center offset character 0,0 front tc rgb BLUE
set label "{/:Italic A}" at 8.09,0.54 center offset character 0,0 front tc rgb INK
set label "{/:Italic A}" at 5.41181799,0.512175193 center offset character 0,0 front tc rgb INK
set label "{/:Italic B}" at 8.95,0.54 center offset character 0,0 front tc rgb INK
set label "{/:Italic B}" at 6.2974058,2.11204613 center offset character 0,0 front tc rgb INK
set label "{/:Italic C}" at 10.24,1.81 center offset character 0,0 front tc rgb INK
set label "{/:Italic C}" at 5.13694002,3.89667998 center offset character 0,0 front tc rgb INK
set label "1" at 12.82,3.08 center offset character 0,0 front tc rgb BLUE
set label "3" at 11.96,1.81 center offset character 0,0 front tc rgb BLUE
set label "{/:Italic D}" at 11.53,0.54 center offset character 0,0 front tc rgb INK
set label "{/:Italic D}" at 2.38986135,0.56190154 center offset character 0,0 front tc rgb INK
set label "{/:Italic E}" at 12.39,0.54 center offset character 0,0 front tc rgb INK
set label "{/:Italic E}" at 2.17335792,2.36110384 center offset character 0,0 front tc rgb INK
set label "{/:Italic F}" at 13.68,1.81 center offset character 0,0 front tc rgb INK
set label "{/:Italic F}" at 1.25128205,3.71555556 center offset character 0,0 front tc rgb INK
set label "1" at 1.71901389,3.30113782 center offset character 0,0 front tc rgb BLUE
set label "2" at 3.25190155,2.42751367 center offset character 0,0 front tc rgb BLUE
set label "3" at 1.57791369,1.29877675 center offset character 0,0 front tc rgb BLUE
set label "4" at 5.35149287,3.2940285 center offset character 0,0 front tc rgb BLUE
set label "5" at 5.30815152,1.3182357 center offset character 0,0 front tc rgb BLUE
$s0 << EOD
3.1167 0
6.9 0
6.9 0.057143
3.4341 2.2852

6.9 0.057143
6.9 3.475
3.4806 2.6201
3.4341 2.2852
EOD
$s1 << EOD
6.9 3.475
6.9 4.8
3.7833 4.8
3.4806 2.6201

0 0
3.1167 0
3.2956 1.2884
0 0.92222

3.2956 1.2884
3.7833 4.8
3.7538 4.8
0 1.5467
0 0.92222

3.7538 4.8
0 4.8
0 1.5467
EOD
$s2 << EOD
3.1167 0
3.7833 4.8

6.9 3.475
3.4806 2.6201

6.9 0.057143
3.4341 2.2852

3.7538 4.8
0 1.5467

3.2956 1.2884
0 0.92222
EOD
$s3 << EOD
11.1 4.35
9.38 3.08
EOD
$s4 << EOD
11.1 4.35
12.82 3.08
EOD
$s5 << EOD
9.38 3.08
8.52 1.81
EOD
$s6 << EOD
9.38 3.08
10.24 1.81
EOD
$s7 << EOD
8.52 1.81
8.09 0.54

8.52 1.81
8.95 0.54
EOD
$s8 << EOD
12.82 3.08
11.96 1.81

12.82 3.08
13.68 1.81

11.96 1.81
11.53 0.54

11.96 1.81
12.39 0.54
EOD
$s9 << EOD
11.37 4.35
11.368 4.3852
11.361 4.4199
11.349 4.4533
11.334 4.485
11.314 4.5144
11.291 4.5409
11.264 4.5642
11.235 4.5838
11.203 4.5994
11.17 4.6108
11.135 4.6177
11.1 4.62
11.065 4.6177
11.03 4.6108
10.997 4.5994
10.965 4.5838
10.936 4.5642
10.909 4.5409
10.886 4.5144
10.866 4.485
10.851 4.4533
10.839 4.4199
10.832 4.3852
10.83 4.35
10.832 4.3148
10.839 4.2801
10.851 4.2467
10.866 4.215
10.886 4.1856
10.909 4.1591
10.936 4.1358
10.965 4.1162
10.997 4.1006
11.03 4.0892
11.065 4.0823
11.1 4.08
11.135 4.0823
11.17 4.0892
11.203 4.1006
11.235 4.1162
11.264 4.1358
11.291 4.1591
11.314 4.1856
11.334 4.215
11.349 4.2467
11.361 4.2801
11.368 4.3148
11.37 4.35
EOD
$s10 << EOD
11.37 4.35
11.368 4.3852
11.361 4.4199
11.349 4.4533
11.334 4.485
11.314 4.5144
11.291 4.5409
11.264 4.5642
11.235 4.5838
11.203 4.5994
11.17 4.6108
11.135 4.6177
11.1 4.62
11.065 4.6177
11.03 4.6108
10.997 4.5994
10.965 4.5838
10.936 4.5642
10.909 4.5409
10.886 4.5144
10.866 4.485
10.851 4.4533
10.839 4.4199
10.832 4.3852
10.83 4.35
10.832 4.3148
10.839 4.2801
10.851 4.2467
10.866 4.215
10.886 4.1856
10.909 4.1591
10.936 4.1358
10.965 4.1162
10.997 4.1006
11.03 4.0892
11.065 4.0823
11.1 4.08
11.135 4.0823
11.17 4.0892
11.203 4.1006
11.235 4.1162
11.264 4.1358
11.291 4.1591
11.314 4.1856
11.334 4.215
11.349 4.2467
11.361 4.2801
11.368 4.3148
11.37 4.35
11.37 4.35
EOD
$s11 << EOD
9.65 3.08
9.6477 3.1152
9.6408 3.1499
9.6294 3.1833
9.6138 3.215
9.5942 3.2444
9.5709 3.2709
9.5444 3.2942
9.515 3.3138
9.4833 3.3294
9.4499 3.3408
9.4152 3.3477
9.38 3.35
9.3448 3.3477
9.3101 3.3408
9.2767 3.3294
9.245 3.3138
9.2156 3.2942
9.1891 3.2709
9.1658 3.2444
9.1462 3.215
9.1306 3.1833
9.1192 3.1499
9.1123 3.1152
9.11 3.08
9.1123 3.0448
9.1192 3.0101
9.1306 2.9767
9.1462 2.945
9.1658 2.9156
9.1891 2.8891
9.2156 2.8658
9.245 2.8462
9.2767 2.8306
9.3101 2.8192
9.3448 2.8123
9.38 2.81
9.4152 2.8123
9.4499 2.8192
9.4833 2.8306
9.515 2.8462
9.5444 2.8658
9.5709 2.8891
9.5942 2.9156
9.6138 2.945
9.6294 2.9767
9.6408 3.0101
9.6477 3.0448
9.65 3.08
EOD
$s12 << EOD
9.65 3.08
9.6477 3.1152
9.6408 3.1499
9.6294 3.1833
9.6138 3.215
9.5942 3.2444
9.5709 3.2709
9.5444 3.2942
9.515 3.3138
9.4833 3.3294
9.4499 3.3408
9.4152 3.3477
9.38 3.35
9.3448 3.3477
9.3101 3.3408
9.2767 3.3294
9.245 3.3138
9.2156 3.2942
9.1891 3.2709
9.1658 3.2444
9.1462 3.215
9.1306 3.1833
9.1192 3.1499
9.1123 3.1152
9.11 3.08
9.1123 3.0448
9.1192 3.0101
9.1306 2.9767
9.1462 2.945
9.1658 2.9156
9.1891 2.8891
9.2156 2.8658
9.245 2.8462
9.2767 2.8306
9.3101 2.8192
9.3448 2.8123
9.38 2.81
9.4152 2.8123
9.4499 2.8192
9.4833 2.8306
9.515 2.8462
9.5444 2.8658
9.5709 2.8891
9.5942 2.9156
9.6138 2.945
9.6294 2.9767
9.6408 3.0101
9.6477 3.0448
9.65 3.08
9.65 3.08
EOD
$s13 << EOD
8.79 1.81
8.7877 1.8452
8.7808 1.8799
8.7694 1.9133
8.7538 1.945
8.7342 1.9744
8.7109 2.0009
8.6844 2.0242
8.655 2.0438
8.6233 2.0594
8.5899 2.0708
8.5552 2.0777
8.52 2.08
8.4848 2.0777
8.4501 2.0708
8.4167 2.0594
8.385 2.0438
8.3556 2.0242
8.3291 2.0009
8.3058 1.9744
8.2862 1.945
8.2706 1.9133
8.2592 1.8799
8.2523 1.8452
8.25 1.81
8.2523 1.7748
8.2592 1.7401
8.2706 1.7067
8.2862 1.675
8.3058 1.6456
8.3291 1.6191
8.3556 1.5958
8.385 1.5762
8.4167 1.5606
8.4501 1.5492
8.4848 1.5423
8.52 1.54
8.5552 1.5423
8.5899 1.5492
8.6233 1.5606
8.655 1.5762
8.6844 1.5958
8.7109 1.6191
8.7342 1.6456
8.7538 1.675
8.7694 1.7067
8.7808 1.7401
8.7877 1.7748
8.79 1.81
EOD
$s14 << EOD
8.79 1.81
8.7877 1.8452
8.7808 1.8799
8.7694 1.9133
8.7538 1.945
8.7342 1.9744
8.7109 2.0009
8.6844 2.0242
8.655 2.0438
8.6233 2.0594
8.5899 2.0708
8.5552 2.0777
8.52 2.08
8.4848 2.0777
8.4501 2.0708
8.4167 2.0594
8.385 2.0438
8.3556 2.0242
8.3291 2.0009
8.3058 1.9744
8.2862 1.945
8.2706 1.9133
8.2592 1.8799
8.2523 1.8452
8.25 1.81
8.2523 1.7748
8.2592 1.7401
8.2706 1.7067
8.2862 1.675
8.3058 1.6456
8.3291 1.6191
8.3556 1.5958
8.385 1.5762
8.4167 1.5606
8.4501 1.5492
8.4848 1.5423
8.52 1.54
8.5552 1.5423
8.5899 1.5492
8.6233 1.5606
8.655 1.5762
8.6844 1.5958
8.7109 1.6191
8.7342 1.6456
8.7538 1.675
8.7694 1.7067
8.7808 1.7401
8.7877 1.7748
8.79 1.81
8.79 1.81
EOD
$s15 << EOD
7.85 0.3
8.33 0.3
8.33 0.78
7.85 0.78
EOD
$s16 << EOD
7.85 0.3
8.33 0.3
8.33 0.78
7.85 0.78
7.85 0.3
EOD
$s17 << EOD
8.71 0.3
9.19 0.3
9.19 0.78
8.71 0.78
EOD
$s18 << EOD
8.71 0.3
9.19 0.3
9.19 0.78
8.71 0.78
8.71 0.3
EOD
$s19 << EOD
10 1.57
10.48 1.57
10.48 2.05
10 2.05
EOD
$s20 << EOD
10 1.57
10.48 1.57
10.48 2.05
10 2.05
10 1.57
EOD
$s21 << EOD
13.09 3.08
13.088 3.1152
13.081 3.1499
13.069 3.1833
13.054 3.215
13.034 3.2444
13.011 3.2709
12.984 3.2942
12.955 3.3138
12.923 3.3294
12.89 3.3408
12.855 3.3477
12.82 3.35
12.785 3.3477
12.75 3.3408
12.717 3.3294
12.685 3.3138
12.656 3.2942
12.629 3.2709
12.606 3.2444
12.586 3.215
12.571 3.1833
12.559 3.1499
12.552 3.1152
12.55 3.08
12.552 3.0448
12.559 3.0101
12.571 2.9767
12.586 2.945
12.606 2.9156
12.629 2.8891
12.656 2.8658
12.685 2.8462
12.717 2.8306
12.75 2.8192
12.785 2.8123
12.82 2.81
12.855 2.8123
12.89 2.8192
12.923 2.8306
12.955 2.8462
12.984 2.8658
13.011 2.8891
13.034 2.9156
13.054 2.945
13.069 2.9767
13.081 3.0101
13.088 3.0448
13.09 3.08
EOD
$s22 << EOD
13.09 3.08
13.088 3.1152
13.081 3.1499
13.069 3.1833
13.054 3.215
13.034 3.2444
13.011 3.2709
12.984 3.2942
12.955 3.3138
12.923 3.3294
12.89 3.3408
12.855 3.3477
12.82 3.35
12.785 3.3477
12.75 3.3408
12.717 3.3294
12.685 3.3138
12.656 3.2942
12.629 3.2709
12.606 3.2444
12.586 3.215
12.571 3.1833
12.559 3.1499
12.552 3.1152
12.55 3.08
12.552 3.0448
12.559 3.0101
12.571 2.9767
12.586 2.945
12.606 2.9156
12.629 2.8891
12.656 2.8658
12.685 2.8462
12.717 2.8306
12.75 2.8192
12.785 2.8123
12.82 2.81
12.855 2.8123
12.89 2.8192
12.923 2.8306
12.955 2.8462
12.984 2.8658
13.011 2.8891
13.034 2.9156
13.054 2.945
13.069 2.9767
13.081 3.0101
13.088 3.0448
13.09 3.08
13.09 3.08
EOD
$s23 << EOD
12.23 1.81
12.228 1.8452
12.221 1.8799
12.209 1.9133
12.194 1.945
12.174 1.9744
12.151 2.0009
12.124 2.0242
12.095 2.0438
12.063 2.0594
12.03 2.0708
11.995 2.0777
11.96 2.08
11.925 2.0777
11.89 2.0708
11.857 2.0594
11.825 2.0438
11.796 2.0242
11.769 2.0009
11.746 1.9744
11.726 1.945
11.711 1.9133
11.699 1.8799
11.692 1.8452
11.69 1.81
11.692 1.7748
11.699 1.7401
11.711 1.7067
11.726 1.675
11.746 1.6456
11.769 1.6191
11.796 1.5958
11.825 1.5762
11.857 1.5606
11.89 1.5492
11.925 1.5423
11.96 1.54
11.995 1.5423
12.03 1.5492
12.063 1.5606
12.095 1.5762
12.124 1.5958
12.151 1.6191
12.174 1.6456
12.194 1.675
12.209 1.7067
12.221 1.7401
12.228 1.7748
12.23 1.81
EOD
$s24 << EOD
12.23 1.81
12.228 1.8452
12.221 1.8799
12.209 1.9133
12.194 1.945
12.174 1.9744
12.151 2.0009
12.124 2.0242
12.095 2.0438
12.063 2.0594
12.03 2.0708
11.995 2.0777
11.96 2.08
11.925 2.0777
11.89 2.0708
11.857 2.0594
11.825 2.0438
11.796 2.0242
11.769 2.0009
11.746 1.9744
11.726 1.945
11.711 1.9133
11.699 1.8799
11.692 1.8452
11.69 1.81
11.692 1.7748
11.699 1.7401
11.711 1.7067
11.726 1.675
11.746 1.6456
11.769 1.6191
11.796 1.5958
11.825 1.5762
11.857 1.5606
11.89 1.5492
11.925 1.5423
11.96 1.54
11.995 1.5423
12.03 1.5492
12.063 1.5606
12.095 1.5762
12.124 1.5958
12.151 1.6191
12.174 1.6456
12.194 1.675
12.209 1.7067
12.221 1.7401
12.228 1.7748
12.23 1.81
12.23 1.81
EOD
$s25 << EOD
11.29 0.3
11.77 0.3
11.77 0.78
11.29 0.78
EOD
$s26 << EOD
11.29 0.3
11.77 0.3
11.77 0.78
11.29 0.78
11.29 0.3
EOD
$s27 << EOD
12.15 0.3
12.63 0.3
12.63 0.78
12.15 0.78
EOD
$s28 << EOD
12.15 0.3
12.63 0.3
12.63 0.78
12.15 0.78
12.15 0.3
EOD
$s29 << EOD
13.44 1.57
13.92 1.57
13.92 2.05
13.44 2.05
EOD
$s30 << EOD
13.44 1.57
13.92 1.57
13.92 2.05
13.44 2.05
13.44 1.57
EOD
$s31 << EOD
1.1 2.5
2.6 3.8

3.2 0.6
3.7 4.2

0.7 1
2.5 1.2

4.6 2.9
6.2 3.3

4.5 1.6
5.9 0.7
EOD
$s32 << EOD
1.85 3.15 0.27507 -0.31739

3.45 2.4 0.41601 -0.057779

1.6 1.1 0.046381 -0.41743

5.4 3.1 0.10186 -0.40746

5.2 1.15 -0.22712 -0.35329
EOD
$s33 << EOD
5.8 2.35
5.7983 2.3761
5.7932 2.4018
5.7848 2.4265
5.7732 2.45
5.7587 2.4718
5.7414 2.4914
5.7218 2.5087
5.7 2.5232
5.6765 2.5348
5.6518 2.5432
5.6261 2.5483
5.6 2.55
5.5739 2.5483
5.5482 2.5432
5.5235 2.5348
5.5 2.5232
5.4782 2.5087
5.4586 2.4914
5.4413 2.4718
5.4268 2.45
5.4152 2.4265
5.4068 2.4018
5.4017 2.3761
5.4 2.35
5.4017 2.3239
5.4068 2.2982
5.4152 2.2735
5.4268 2.25
5.4413 2.2282
5.4586 2.2086
5.4782 2.1913
5.5 2.1768
5.5235 2.1652
5.5482 2.1568
5.5739 2.1517
5.6 2.15
5.6261 2.1517
5.6518 2.1568
5.6765 2.1652
5.7 2.1768
5.7218 2.1913
5.7414 2.2086
5.7587 2.2282
5.7732 2.25
5.7848 2.2735
5.7932 2.2982
5.7983 2.3239
5.8 2.35
EOD
$s34 << EOD
5.8 2.35
5.7983 2.3761
5.7932 2.4018
5.7848 2.4265
5.7732 2.45
5.7587 2.4718
5.7414 2.4914
5.7218 2.5087
5.7 2.5232
5.6765 2.5348
5.6518 2.5432
5.6261 2.5483
5.6 2.55
5.5739 2.5483
5.5482 2.5432
5.5235 2.5348
5.5 2.5232
5.4782 2.5087
5.4586 2.4914
5.4413 2.4718
5.4268 2.45
5.4152 2.4265
5.4068 2.4018
5.4017 2.3761
5.4 2.35
5.4017 2.3239
5.4068 2.2982
5.4152 2.2735
5.4268 2.25
5.4413 2.2282
5.4586 2.2086
5.4782 2.1913
5.5 2.1768
5.5235 2.1652
5.5482 2.1568
5.5739 2.1517
5.6 2.15
5.6261 2.1517
5.6518 2.1568
5.6765 2.1652
5.7 2.1768
5.7218 2.1913
5.7414 2.2086
5.7587 2.2282
5.7732 2.25
5.7848 2.2735
5.7932 2.2982
5.7983 2.3239
5.8 2.35
5.8 2.35
EOD
$s35 << EOD
4.1 1.6
4.0983 1.6261
4.0932 1.6518
4.0848 1.6765
4.0732 1.7
4.0587 1.7218
4.0414 1.7414
4.0218 1.7587
4 1.7732
3.9765 1.7848
3.9518 1.7932
3.9261 1.7983
3.9 1.8
3.8739 1.7983
3.8482 1.7932
3.8235 1.7848
3.8 1.7732
3.7782 1.7587
3.7586 1.7414
3.7413 1.7218
3.7268 1.7
3.7152 1.6765
3.7068 1.6518
3.7017 1.6261
3.7 1.6
3.7017 1.5739
3.7068 1.5482
3.7152 1.5235
3.7268 1.5
3.7413 1.4782
3.7586 1.4586
3.7782 1.4413
3.8 1.4268
3.8235 1.4152
3.8482 1.4068
3.8739 1.4017
3.9 1.4
3.9261 1.4017
3.9518 1.4068
3.9765 1.4152
4 1.4268
4.0218 1.4413
4.0414 1.4586
4.0587 1.4782
4.0732 1.5
4.0848 1.5235
4.0932 1.5482
4.0983 1.5739
4.1 1.6
EOD
$s36 << EOD
4.1 1.6
4.0983 1.6261
4.0932 1.6518
4.0848 1.6765
4.0732 1.7
4.0587 1.7218
4.0414 1.7414
4.0218 1.7587
4 1.7732
3.9765 1.7848
3.9518 1.7932
3.9261 1.7983
3.9 1.8
3.8739 1.7983
3.8482 1.7932
3.8235 1.7848
3.8 1.7732
3.7782 1.7587
3.7586 1.7414
3.7413 1.7218
3.7268 1.7
3.7152 1.6765
3.7068 1.6518
3.7017 1.6261
3.7 1.6
3.7017 1.5739
3.7068 1.5482
3.7152 1.5235
3.7268 1.5
3.7413 1.4782
3.7586 1.4586
3.7782 1.4413
3.8 1.4268
3.8235 1.4152
3.8482 1.4068
3.8739 1.4017
3.9 1.4
3.9261 1.4017
3.9518 1.4068
3.9765 1.4152
4 1.4268
4.0218 1.4413
4.0414 1.4586
4.0587 1.4782
4.0732 1.5
4.0848 1.5235
4.0932 1.5482
4.0983 1.5739
4.1 1.6
4.1 1.6
EOD
$s37 << EOD
5.6 2.35 -1.7 -0.75
EOD
plot $s0 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s1 with filledcurves closed fc rgb MIST fs solid noborder notitle, \
 $s2 with lines lc rgb GREY lw 1.4 dt (6,5) notitle, \
 $s3 with lines lc rgb RED lw 2.2 dt solid notitle, \
 $s4 with lines lc rgb GREY lw 1.4 dt solid notitle, \
 $s5 with lines lc rgb RED lw 2.2 dt solid notitle, \
 $s6 with lines lc rgb GREY lw 1.4 dt solid notitle, \
 $s7 with lines lc rgb RED lw 2.2 dt solid notitle, \
 $s8 with lines lc rgb GREY lw 1.4 dt solid notitle, \
 $s9 with filledcurves closed fc rgb PAPER fs solid noborder notitle, \
 $s10 with lines lc rgb RED lw 2.2 dt solid notitle, \
 $s11 with filledcurves closed fc rgb PAPER fs solid noborder notitle, \
 $s12 with lines lc rgb RED lw 2.2 dt solid notitle, \
 $s13 with filledcurves closed fc rgb PAPER fs solid noborder notitle, \
 $s14 with lines lc rgb RED lw 2.2 dt solid notitle, \
 $s15 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s16 with lines lc rgb RED lw 2.2 dt solid notitle, \
 $s17 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s18 with lines lc rgb RED lw 2.2 dt solid notitle, \
 $s19 with filledcurves closed fc rgb MIST fs solid noborder notitle, \
 $s20 with lines lc rgb GREY lw 1.4 dt solid notitle, \
 $s21 with filledcurves closed fc rgb PAPER fs solid noborder notitle, \
 $s22 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s23 with filledcurves closed fc rgb PAPER fs solid noborder notitle, \
 $s24 with lines lc rgb INK lw 1.4 dt solid notitle, \
 $s25 with filledcurves closed fc rgb MIST fs solid noborder notitle, \
 $s26 with lines lc rgb GREY lw 1.4 dt solid notitle, \
 $s27 with filledcurves closed fc rgb MIST fs solid noborder notitle, \
 $s28 with lines lc rgb GREY lw 1.4 dt solid notitle, \
 $s29 with filledcurves closed fc rgb MIST fs solid noborder notitle, \
 $s30 with lines lc rgb GREY lw 1.4 dt solid notitle, \
 $s31 with lines lc rgb BLUE lw 4 dt solid notitle, \
 $s32 with vectors filled head size screen 0.022,18,60 lc rgb INK lw 1.6 dt solid notitle, \
 $s33 with filledcurves closed fc rgb AMBER fs solid noborder notitle, \
 $s34 with lines lc rgb ORANGE lw 1.2 dt solid notitle, \
 $s35 with filledcurves closed fc rgb fade(AMBER,0.4) fs solid noborder notitle, \
 $s36 with lines lc rgb ORANGE lw 1.2 dt solid notitle, \
 $s37 with vectors filled head size screen 0.022,18,60 lc rgb RED lw 2.4 dt solid notitle
