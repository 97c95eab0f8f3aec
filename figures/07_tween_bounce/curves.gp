# Draws curves.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,380 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 760 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 3.958333 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "curves." . format

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
$control << EOD
0 0.4
0.6 3.2
2.6 3.4
3.6 0.2
5.4 0.1
6.2 2.9
8 3.1
EOD
$bezier << EOD
0 0.4
0.031431 0.53728
0.065616 0.6691
0.1024 0.79542
0.14163 0.91621
0.18317 1.0315
0.22688 1.1412
0.27263 1.2453
0.3203 1.344
0.36976 1.4371
0.42091 1.5249
0.47364 1.6072
0.52785 1.6841
0.58343 1.7558
0.64031 1.8223
0.69839 1.8836
0.75758 1.9399
0.81781 1.9912
0.87901 2.0377
0.94111 2.0795
1.004 2.1166
1.0677 2.1492
1.1321 2.1775
1.1972 2.2014
1.2628 2.2213
1.329 2.2372
1.3957 2.2492
1.4628 2.2576
1.5304 2.2624
1.5983 2.2638
1.6666 2.262
1.7352 2.2571
1.804 2.2492
1.8731 2.2387
1.9425 2.2255
2.012 2.2099
2.0817 2.1921
2.1515 2.1721
2.2214 2.1502
2.2915 2.1266
2.3616 2.1014
2.4318 2.0747
2.502 2.0468
2.5723 2.0178
2.6426 1.9879
2.7129 1.9572
2.7832 1.9259
2.8536 1.8941
2.9238 1.8621
2.9941 1.83
3.0643 1.7978
3.1344 1.7659
3.2045 1.7342
3.2746 1.7031
3.3445 1.6725
3.4144 1.6427
3.4842 1.6138
3.5539 1.5859
3.6235 1.5591
3.6931 1.5335
3.7625 1.5094
3.8318 1.4867
3.901 1.4656
3.9701 1.4462
4.0391 1.4286
4.108 1.4129
4.1768 1.3991
4.2454 1.3874
4.3139 1.3778
4.3823 1.3704
4.4506 1.3652
4.5188 1.3624
4.5868 1.3619
4.6547 1.3637
4.7225 1.368
4.7902 1.3748
4.8578 1.384
4.9252 1.3957
4.9926 1.4099
5.0599 1.4266
5.127 1.4458
5.1941 1.4675
5.2611 1.4915
5.328 1.518
5.3949 1.5469
5.4617 1.578
5.5285 1.6114
5.5952 1.6471
5.662 1.6848
5.7287 1.7246
5.7955 1.7663
5.8623 1.8098
5.9292 1.8551
5.9962 1.902
6.0633 1.9504
6.1305 2.0001
6.198 2.0511
6.2656 2.1031
6.3335 2.156
6.4016 2.2097
6.4701 2.2638
6.5389 2.3184
6.6082 2.373
6.6779 2.4277
6.7481 2.482
6.8189 2.5359
6.8903 2.589
6.9624 2.6411
7.0353 2.692
7.109 2.7414
7.1836 2.789
7.2592 2.8345
7.3359 2.8777
7.4137 2.9182
7.4928 2.9558
7.5733 2.99
7.6553 3.0206
7.7388 3.0473
7.824 3.0697
7.911 3.0874
8 3.1
EOD
$spline << EOD
0 0.4
0.061306 0.67108
0.12512 0.92463
0.19127 1.1611
0.2596 1.381
0.32994 1.5848
0.40213 1.7729
0.47602 1.9459
0.55143 2.1041
0.6282 2.2481
0.70617 2.3784
0.78518 2.4953
0.86507 2.5995
0.94566 2.6912
1.0268 2.7711
1.1083 2.8396
1.1901 2.8971
1.2719 2.9442
1.3536 2.9812
1.435 3.0087
1.516 3.0272
1.5965 3.037
1.6761 3.0388
1.7549 3.0328
1.8325 3.0197
1.909 2.9999
1.984 2.9739
2.0574 2.9421
2.1291 2.9049
2.1989 2.863
2.2667 2.8167
2.3322 2.7664
2.3957 2.7125
2.4571 2.6553
2.5167 2.5948
2.5744 2.5315
2.6304 2.4655
2.6848 2.397
2.7377 2.3264
2.7893 2.2539
2.8395 2.1796
2.8886 2.1039
2.9365 2.0271
2.9835 1.9492
3.0296 1.8707
3.075 1.7917
3.1197 1.7124
3.1638 1.6332
3.2075 1.5543
3.2508 1.4758
3.2938 1.3981
3.3367 1.3215
3.3796 1.246
3.4225 1.1721
3.4656 1.0999
3.509 1.0296
3.5527 0.96161
3.5969 0.89607
3.6416 0.83323
3.6871 0.77335
3.7333 0.71667
3.7804 0.6634
3.8284 0.61361
3.8771 0.56737
3.9266 0.5247
3.9767 0.48565
4.0275 0.45027
4.0788 0.4186
4.1307 0.39068
4.183 0.36657
4.2358 0.3463
4.2889 0.32991
4.3424 0.31747
4.3961 0.309
4.4501 0.30455
4.5042 0.30417
4.5584 0.3079
4.6127 0.31578
4.6669 0.32787
4.7212 0.3442
4.7753 0.36481
4.8293 0.38977
4.8831 0.4191
4.9366 0.45285
4.9899 0.49107
5.0427 0.5338
5.0952 0.58108
5.1472 0.63297
5.1987 0.6895
5.2497 0.75071
5.3 0.81667
5.3497 0.88732
5.3991 0.96232
5.4485 1.0413
5.4982 1.1237
5.5486 1.2092
5.6 1.2973
5.6527 1.3877
5.7071 1.4799
5.7635 1.5734
5.8222 1.6679
5.8836 1.7629
5.948 1.858
6.0157 1.9528
6.0871 2.0468
6.1625 2.1396
6.2422 2.2308
6.3266 2.32
6.416 2.4067
6.5107 2.4905
6.6111 2.571
6.7175 2.6478
6.8302 2.7203
6.9496 2.7883
7.076 2.8513
7.2097 2.9089
7.3511 2.9605
7.5005 3.0059
7.6582 3.0446
7.8246 3.0761
8 3.1
EOD
$loose << EOD
0.83333 2.7667
0.90003 2.8384
0.96993 2.9035
1.0427 2.962
1.1181 3.0136
1.1958 3.0583
1.2755 3.0961
1.3569 3.1267
1.4397 3.1501
1.5236 3.1663
1.6083 3.175
1.6935 3.1762
1.7789 3.1699
1.8642 3.1558
1.9491 3.1339
2.0333 3.1042
2.1165 3.0664
2.1984 3.0205
2.2787 2.9665
2.3571 2.9041
2.4333 2.8333
2.5071 2.7542
2.5786 2.6674
2.6481 2.5737
2.7157 2.474
2.7818 2.369
2.8464 2.2596
2.9099 2.1465
2.9725 2.0307
3.0344 1.9128
3.0958 1.7938
3.157 1.6743
3.2181 1.5553
3.2795 1.4376
3.3412 1.3219
3.4036 1.2091
3.4669 1.1
3.5313 0.99539
3.597 0.89608
3.6643 0.80291
3.7333 0.71667
3.8043 0.63804
3.877 0.56713
3.9513 0.50393
4.0269 0.4484
4.1036 0.40052
4.1812 0.36027
4.2595 0.32761
4.3381 0.30253
4.417 0.285
4.4958 0.275
4.5744 0.2725
4.6525 0.27747
4.7299 0.28989
4.8064 0.30973
4.8818 0.33698
4.9557 0.3716
5.0281 0.41357
5.0986 0.46287
5.1671 0.51946
5.2333 0.58333
5.2971 0.65434
5.3587 0.73192
5.4182 0.81536
5.476 0.904
5.5323 0.99714
5.5873 1.0941
5.6414 1.1942
5.6947 1.2967
5.7475 1.4009
5.8 1.5063
5.8525 1.6119
5.9053 1.7173
5.9586 1.8217
6.0127 1.9244
6.0677 2.0247
6.124 2.122
6.1818 2.2155
6.2413 2.3046
6.3029 2.3885
6.3667 2.4667
EOD
unset border
unset tics
unset key
set lmargin at screen 0.04
set rmargin at screen 0.96
set bmargin at screen 0.05
set tmargin at screen 0.95
set xrange [-0.35:8.55]
set yrange [-0.45:3.9]
set label 1 "{/:Italic P}_0" at 0,0.1 center tc rgb INK
set label 2 "{/:Italic P}_1" at 0.6,3.47 center tc rgb INK
set label 3 "{/:Italic P}_2" at 2.6,3.67 center tc rgb INK
set label 4 "{/:Italic P}_3" at 3.6,-0.1 center tc rgb INK
set label 5 "{/:Italic P}_4" at 5.4,-0.2 center tc rgb INK
set label 6 "{/:Italic P}_5" at 6.2,3.17 center tc rgb INK
set label 7 "{/:Italic P}_6" at 8,3.37 center tc rgb INK
set label 11 "Bezier" at 4.62, 1.98 center tc rgb RED
set label 12 "B-spline, clamped" at 1.85, 0.95 center tc rgb BLUE
set label 13 "not clamped:\nmisses its ends" at 6.15, 1.15 left tc rgb GREY
plot $control with lines lc rgb PALE lw 1.4, $loose with lines lc rgb GREY lw 2 dt (6,5), $bezier with lines lc rgb RED lw 2.4, $spline with lines lc rgb BLUE lw 2.4, $control with points pt 7 ps 0.7 lc rgb INK
