# Draws distance.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,400 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 800 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 4.166667 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "distance." . format

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
$distance << EOD
-0.58548 10.05
-0.56359 9.8838
-0.54171 9.718
-0.51982 9.5523
-0.49794 9.3865
-0.47606 9.2208
-0.45417 9.0552
-0.43229 8.8895
-0.4104 8.7239
-0.38852 8.5584
-0.36663 8.3929
-0.34475 8.2274
-0.32287 8.062
-0.30098 7.8966
-0.2791 7.7313
-0.25721 7.5661
-0.23533 7.4009
-0.21344 7.2358
-0.19156 7.0708
-0.16967 6.9058
-0.14779 6.7409
-0.12591 6.5762
-0.10402 6.4115
-0.082137 6.2469
-0.060252 6.0824
-0.038368 5.9181
-0.016484 5.7539
0.0054008 5.5898
0.027285 5.4259
0.04917 5.2622
0.071054 5.0986
0.092938 4.9353
0.11482 4.7722
0.13671 4.6093
0.15859 4.4468
0.18048 4.2845
0.20236 4.1226
0.22424 3.9611
0.24613 3.8
0.26801 3.6395
0.2899 3.4795
0.31178 3.3202
0.33367 3.1616
0.35555 3.0039
0.37744 2.8473
0.39932 2.6918
0.4212 2.5378
0.44309 2.3854
0.46497 2.2351
0.48686 2.0873
0.50874 1.9426
0.53063 1.8016
0.55251 1.6654
0.5744 1.5352
0.59628 1.4127
0.61816 1.3001
0.64005 1.2001
0.66193 1.1162
0.68382 1.0521
0.7057 1.0118
0.72759 0.99793
0.74947 1.0118
0.77136 1.0521
0.79324 1.1162
0.81512 1.2001
0.83701 1.3001
0.85889 1.4127
0.88078 1.5352
0.90266 1.6654
0.92455 1.8016
0.94643 1.9426
0.96831 2.0873
0.9902 2.2351
1.0121 2.3854
1.034 2.5378
1.0559 2.6918
1.0777 2.8473
1.0996 3.0039
1.1215 3.1616
1.1434 3.3202
1.1653 3.4795
1.1872 3.6395
1.209 3.8
1.2309 3.9611
1.2528 4.1226
1.2747 4.2845
1.2966 4.4468
1.3185 4.6093
1.3403 4.7722
1.3622 4.9353
1.3841 5.0986
1.406 5.2622
1.4279 5.4259
1.4498 5.5898
1.4717 5.7539
1.4935 5.9181
1.5154 6.0824
1.5373 6.2469
1.5592 6.4115
1.5811 6.5762
1.603 6.7409
1.6248 6.9058
1.6467 7.0708
1.6686 7.2358
1.6905 7.4009
1.7124 7.5661
1.7343 7.7313
1.7562 7.8966
1.778 8.062
1.7999 8.2274
1.8218 8.3929
1.8437 8.5584
1.8656 8.7239
1.8875 8.8895
1.9093 9.0552
1.9312 9.2208
1.9531 9.3865
1.975 9.5523
1.9969 9.718
2.0188 9.8838
2.0407 10.05
EOD
$beside << EOD
-0.58548 10.44
-0.56359 10.281
-0.54171 10.121
-0.51982 9.9624
-0.49794 9.8036
-0.47606 9.6451
-0.45417 9.4868
-0.43229 9.3289
-0.4104 9.1712
-0.38852 9.0139
-0.36663 8.8569
-0.34475 8.7003
-0.32287 8.544
-0.30098 8.3882
-0.2791 8.2327
-0.25721 8.0777
-0.23533 7.9232
-0.21344 7.7692
-0.19156 7.6158
-0.16967 7.4629
-0.14779 7.3106
-0.12591 7.1589
-0.10402 7.0079
-0.082137 6.8577
-0.060252 6.7082
-0.038368 6.5596
-0.016484 6.4118
0.0054008 6.265
0.027285 6.1192
0.04917 5.9745
0.071054 5.831
0.092938 5.6887
0.11482 5.5478
0.13671 5.4083
0.15859 5.2705
0.18048 5.1343
0.20236 5
0.22424 4.8677
0.24613 4.7376
0.26801 4.6098
0.2899 4.4845
0.31178 4.3621
0.33367 4.2426
0.35555 4.1265
0.37744 4.0139
0.39932 3.9051
0.4212 3.8006
0.44309 3.7006
0.46497 3.6056
0.48686 3.5158
0.50874 3.4319
0.53063 3.3541
0.55251 3.283
0.5744 3.2189
0.59628 3.1623
0.61816 3.1136
0.64005 3.0732
0.66193 3.0414
0.68382 3.0185
0.7057 3.0046
0.72759 3
0.74947 3.0046
0.77136 3.0185
0.79324 3.0414
0.81512 3.0732
0.83701 3.1136
0.85889 3.1623
0.88078 3.2189
0.90266 3.283
0.92455 3.3541
0.94643 3.4319
0.96831 3.5158
0.9902 3.6056
1.0121 3.7006
1.034 3.8006
1.0559 3.9051
1.0777 4.0139
1.0996 4.1265
1.1215 4.2426
1.1434 4.3621
1.1653 4.4845
1.1872 4.6098
1.209 4.7376
1.2309 4.8677
1.2528 5
1.2747 5.1343
1.2966 5.2705
1.3185 5.4083
1.3403 5.5478
1.3622 5.6887
1.3841 5.831
1.406 5.9745
1.4279 6.1192
1.4498 6.265
1.4717 6.4118
1.4935 6.5596
1.5154 6.7082
1.5373 6.8577
1.5592 7.0079
1.5811 7.1589
1.603 7.3106
1.6248 7.4629
1.6467 7.6158
1.6686 7.7692
1.6905 7.9232
1.7124 8.0777
1.7343 8.2327
1.7562 8.3882
1.778 8.544
1.7999 8.7003
1.8218 8.8569
1.8437 9.0139
1.8656 9.1712
1.8875 9.3289
1.9093 9.4868
1.9312 9.6451
1.9531 9.8036
1.975 9.9624
1.9969 10.121
2.0188 10.281
2.0407 10.44
EOD
$inside << EOD
0.5 2
0.50379 1.975
0.50759 1.9501
0.51138 1.9254
0.51517 1.9007
0.51897 1.8762
0.52276 1.8518
0.52655 1.8275
0.53034 1.8034
0.53414 1.7794
0.53793 1.7556
0.54172 1.7319
0.54552 1.7084
0.54931 1.685
0.5531 1.6618
0.5569 1.6388
0.56069 1.616
0.56448 1.5934
0.56828 1.571
0.57207 1.5488
0.57586 1.5268
0.57966 1.505
0.58345 1.4835
0.58724 1.4623
0.59103 1.4413
0.59483 1.4206
0.59862 1.4002
0.60241 1.3801
0.60621 1.3603
0.61 1.3408
0.61379 1.3217
0.61759 1.3029
0.62138 1.2846
0.62517 1.2666
0.62897 1.249
0.63276 1.2318
0.63655 1.2151
0.64034 1.1989
0.64414 1.1831
0.64793 1.1678
0.65172 1.1531
0.65552 1.1389
0.65931 1.1253
0.6631 1.1122
0.6669 1.0998
0.67069 1.0879
0.67448 1.0768
0.67828 1.0663
0.68207 1.0564
0.68586 1.0473
0.68966 1.0389
0.69345 1.0312
0.69724 1.0243
0.70103 1.0182
0.70483 1.0129
0.70862 1.0083
0.71241 1.0046
0.71621 1.0017
0.72 0.9996
0.72379 0.99835
0.72759 0.99793
0.73138 0.99835
0.73517 0.9996
0.73897 1.0017
0.74276 1.0046
0.74655 1.0083
0.75034 1.0129
0.75414 1.0182
0.75793 1.0243
0.76172 1.0312
0.76552 1.0389
0.76931 1.0473
0.7731 1.0564
0.7769 1.0663
0.78069 1.0768
0.78448 1.0879
0.78828 1.0998
0.79207 1.1122
0.79586 1.1253
0.79966 1.1389
0.80345 1.1531
0.80724 1.1678
0.81103 1.1831
0.81483 1.1989
0.81862 1.2151
0.82241 1.2318
0.82621 1.249
0.83 1.2666
0.83379 1.2846
0.83759 1.3029
0.84138 1.3217
0.84517 1.3408
0.84897 1.3603
0.85276 1.3801
0.85655 1.4002
0.86034 1.4206
0.86414 1.4413
0.86793 1.4623
0.87172 1.4835
0.87552 1.505
0.87931 1.5268
0.8831 1.5488
0.8869 1.571
0.89069 1.5934
0.89448 1.616
0.89828 1.6388
0.90207 1.6618
0.90586 1.685
0.90966 1.7084
0.91345 1.7319
0.91724 1.7556
0.92103 1.7794
0.92483 1.8034
0.92862 1.8275
0.93241 1.8518
0.93621 1.8762
0.94 1.9007
0.94379 1.9254
0.94759 1.9501
0.95138 1.975
0.95517 2
EOD
$contacts << EOD
0.5 2
0.955172 2
EOD
reach = 2
t1 = 0.5
t2 = 0.955172414
earliest = -0.585478122
latest = 2.04065054
set xrange [earliest:latest]
set yrange [0:10]
name = "distance of the centres"
miss = "passing by: no root"
approach = "nearer and nearer"
leave = "apart again"
unset key
set border 3
set xtics 0, 1 font ",15"
set ytics 0, 2 font ",15"
set lmargin at screen 0.07
set rmargin at screen 0.965
set tmargin at screen 0.9
set bmargin at screen 0.15
set label 1 name at screen 0.02, 0.955 left tc rgb INK
set label 2 "{/:Italic t}" at screen 0.5175, 0.05 center tc rgb INK
set label 3 "{/:Italic d}" at latest, reach offset 0, 0.7 right tc rgb BLUE
set label 4 "{/:Italic t}_1" at t1, 0 offset 0, 0.8 center tc rgb GREEN front
set label 5 "{/:Italic t}_2" at t2, 0 offset 0, 0.8 center tc rgb GREEN front
set label 6 miss at 0.5 * (t1 + t2), 2.35 * reach center tc rgb GREY
set label 7 approach at graph 0.03, first 1.6 * reach left tc rgb INK
set label 8 leave at graph 0.97, first 1.6 * reach right tc rgb INK
set arrow 1 from t1, reach to t1, 0.42 * reach nohead lc rgb GREEN lw 1.4 dt (5,4)
set arrow 2 from t2, reach to t2, 0.42 * reach nohead lc rgb GREEN lw 1.4 dt (5,4)
set arrow 3 from earliest, reach to latest, reach nohead lc rgb BLUE lw 1.6
plot $inside using 1:2:(reach) with filledcurves fc rgb FLOOR notitle, \
 $beside using 1:2 with lines lc rgb GREY lw 1.6 dt (7,5), \
 $distance using 1:2 with lines lc rgb RED lw 2.4, $contacts using 1:2 with points pt 7 ps 0.9 lc rgb INK
