# Draws printed-and-physical.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,440 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 880 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 4.583333 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "printed-and-physical." . format

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
$printed << EOD
0 25
0.04 23.0098
0.07 21.5275
0.1 20.054
0.14 18.1031
0.17 16.6502
0.21 14.7268
0.25 12.8192
0.28 11.3987
0.32 9.5185
0.36 7.65401
0.4 5.80524
0.44 3.97218
0.48 2.15483
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
3.56 2.55368
3.59 2.03808
3.64 1.15518
3.67 0.611295
3.7 0.0568064
3.71 0
13.01 0
EOD
$physical << EOD
0 25
0.05 22.4877
0.1 19.9509
0.15 17.3895
0.2 14.8036
0.24 12.7172
0.27 11.1421
0.33 7.9653
0.36 6.36366
0.4 4.2144
0.43 2.59214
0.47 0.415381
0.48 0.0655896
0.52 1.15059
0.57 2.48475
0.61 3.5344
0.65 4.56834
0.69 5.58656
0.73 6.58908
0.78 7.82013
0.82 8.78729
0.86 9.73874
0.91 10.906
0.95 11.8221
0.99 12.7224
1.04 13.8258
1.08 14.6909
1.12 15.5402
1.17 16.5797
1.21 17.3937
1.25 18.192
1.29 18.9745
1.34 19.9306
1.39 20.8621
1.43 21.5897
1.47 22.3015
1.52 23.1692
1.56 23.8457
1.61 24.6693
1.65 25.3104
1.7 26.0897
1.74 26.6955
1.79 27.4306
1.83 28.0011
1.87 28.5558
1.91 29.0948
1.95 29.6181
2 30.2501
2.04 30.7381
2.08 31.2103
2.13 31.7785
2.17 32.2154
2.21 32.6366
2.25 33.042
2.3 33.5268
2.34 33.8969
2.38 34.2513
2.43 34.6721
2.47 34.9912
2.51 35.2945
2.56 35.6516
2.6 35.9196
2.65 36.2324
2.69 36.4651
2.73 36.682
2.77 36.8832
2.82 37.1126
2.86 37.2784
2.91 37.4637
2.96 37.6243
3 37.7352
3.04 37.8303
3.08 37.9098
3.12 37.9735
3.17 38.031
3.21 38.0594
3.26 38.0728
3.3 38.0658
3.35 38.035
3.39 37.9926
3.43 37.9346
3.47 37.8608
3.52 37.7466
3.56 37.6374
3.6 37.5126
3.64 37.3721
3.69 37.1743
3.73 36.9984
3.78 36.7565
3.82 36.5452
3.86 36.3183
3.9 36.0756
3.95 35.7502
3.99 35.4722
4.04 35.1026
4.08 34.7892
4.12 34.4601
4.17 34.0267
4.21 33.6623
4.25 33.2821
4.3 32.7849
4.35 32.263
4.39 31.8279
4.44 31.2619
4.48 30.7914
4.52 30.3052
4.56 29.8033
4.61 29.1538
4.65 28.6166
4.69 28.0636
4.73 27.4949
4.77 26.9105
4.82 26.1579
4.86 25.5382
4.9 24.9027
4.94 24.2515
4.99 23.4155
5.03 22.7289
5.08 21.8487
5.12 21.1268
5.16 20.3892
5.2 19.6359
5.25 18.6722
5.3 17.6839
5.34 16.8756
5.38 16.0516
5.42 15.2119
5.46 14.3565
5.51 13.2651
5.56 12.1491
5.6 11.2387
5.64 10.3126
5.68 9.37075
5.71 8.65405
5.75 7.68471
5.79 6.69966
5.83 5.69889
5.88 4.42584
5.94 2.86577
5.99 1.53871
6.04 0.187095
6.05 0.0430137
6.09 0.580821
6.14 1.23098
6.18 1.73344
6.22 2.22018
6.26 2.69121
6.31 3.25791
6.35 3.69359
6.4 4.21609
6.44 4.61642
6.48 5.00103
6.53 5.45971
6.57 5.80897
6.61 6.14252
6.65 6.46036
6.69 6.76249
6.74 7.11805
6.78 7.38483
6.83 7.6962
6.87 7.92763
6.91 8.14334
6.95 8.34334
7 8.57124
7.04 8.73589
7.09 8.9196
7.13 9.0489
7.18 9.18842
7.22 9.28236
7.26 9.36059
7.3 9.42311
7.35 9.47917
7.4 9.51067
7.44 9.5182
7.48 9.51001
7.52 9.48612
7.56 9.44651
7.61 9.3749
7.66 9.27875
7.7 9.18415
7.75 9.0438
7.79 8.91385
7.83 8.76818
7.87 8.60681
7.92 8.38299
7.96 8.18626
8 7.97382
8.05 7.68617
8.09 7.43838
8.14 7.10655
8.18 6.8234
8.22 6.52454
8.26 6.20997
8.31 5.79467
8.35 5.44475
8.39 5.07912
8.43 4.69777
8.48 4.19899
8.52 3.7823
8.56 3.34989
8.6 2.90177
8.65 2.31952
8.7 1.71273
8.74 1.20961
8.78 0.690789
8.83 0.0201627
8.84 0.057919
8.89 0.383271
8.94 0.684073
8.98 0.907039
9.01 1.06395
9.05 1.25942
9.1 1.48166
9.14 1.64178
9.18 1.78619
9.22 1.91488
9.27 2.05365
9.31 2.147
9.36 2.24158
9.4 2.29957
9.44 2.34185
9.49 2.3726
9.53 2.37952
9.58 2.36609
9.62 2.33766
9.66 2.29352
9.7 2.23367
9.74 2.15811
9.79 2.04156
9.83 1.93065
9.87 1.80402
9.91 1.66168
9.96 1.46166
10 1.28397
10.04 1.09057
10.08 0.881457
10.13 0.597969
10.18 0.289931
10.22 0.0258252
10.23 0.021044
10.28 0.176625
10.32 0.283414
10.36 0.374491
10.41 0.466243
10.45 0.521968
10.49 0.561981
10.53 0.586282
10.57 0.594871
10.61 0.587748
10.65 0.564913
10.69 0.526366
10.74 0.456087
10.78 0.382188
10.83 0.267719
10.87 0.158468
10.92 9.52695e-05
10.96 0.0605799
11.01 0.114091
11.05 0.139223
11.09 0.148644
11.13 0.142353
11.18 0.112393
11.22 0.0707501
11.27 0.00167074
11.31 0.0272192
11.36 0.0370598
11.4 0.0272562
11.44 0.0017407
11.49 0.00919881
11.53 0.000192187
13.01 0
EOD
set lmargin at screen 0.08
set rmargin at screen 0.965
set bmargin at screen 0.175
set tmargin at screen 0.88
set grid
unset key
set xtics font ",15"
set ytics font ",15"
set label 21 "height" at screen 0.02, 0.945 left tc rgb INK
set label 22 "time" at screen 0.5225, 0.05 center tc rgb INK
set xrange [0:13.0100326]
set yrange [0:42.6415206]
set label 1 "as printed" at graph 0.19, 0.42 left tc rgb PINK
set label 2 "solved at its impacts" at graph 0.36, 0.84 left tc rgb GREEN
set arrow 3 from 11.6161005,0 to 11.6161005,23.4528363 nohead lc rgb GREY lw 1.2 dt (6,5)
set label 3 "rest, after infinitely\nmany impacts" at graph 0.998, 0.67 right tc rgb INK
plot $physical using 1:2 with lines lc rgb GREEN lw 2.2, $printed using 1:2 with lines lc rgb PINK lw 2.2
