# Draws grown-planes.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 540,648 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1080,magnify * 1296 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 5.625000,magnify * 6.750000 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "grown-planes." . format

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
set xrange [-2.5479111:2.19421453]
set yrange [-3.6479111:5.1116144]
set label "{/:Italic r} / sin {/:Italic α}" at -2.2,1.93185165 right offset character -0.6,0 front tc rgb PINK
set label "{/:Italic r}" at 0.310804984,1.39166345 center offset character 0.9,-0.2 front tc rgb GREEN
set label "{/:Italic α}" at 0.24,-1.75 center offset character 0.2,-0.2 front tc rgb INK
$s0 << EOD
0 3.8637
1.9463 -3.4
-1.9463 -3.4
EOD
$s1 << EOD
0 0
-2.3 0

0 3.8637
-2.3 3.8637
EOD
$s2 << EOD
0 0
0.91103 -3.4
-0.91103 -3.4
EOD
$s3 << EOD
0 0
0.91103 -3.4
-0.91103 -3.4
0 0
EOD
$s4 << EOD
-1.9463 -3.4
0 3.8637
1.9463 -3.4
EOD
$s5 << EOD
-2.2 1.9319 0 -1.9319

-2.2 1.9319 0 1.9319
EOD
$s6 << EOD
9.1849e-17 -1.5
0.0081812 -1.5
0.016362 -1.4999
0.024543 -1.4998
0.032722 -1.4996
0.040901 -1.4994
0.049079 -1.4992
0.057255 -1.4989
0.065429 -1.4986
0.073602 -1.4982
0.081772 -1.4978
0.08994 -1.4973
0.098105 -1.4968
0.10627 -1.4962
0.11443 -1.4956
0.12258 -1.495
0.13073 -1.4943
0.13888 -1.4936
0.14703 -1.4928
0.15517 -1.492
0.1633 -1.4911
0.17143 -1.4902
0.17956 -1.4892
0.18768 -1.4882
0.19579 -1.4872
0.2039 -1.4861
0.212 -1.4849
0.2201 -1.4838
0.22819 -1.4825
0.23627 -1.4813
0.24434 -1.48
0.25241 -1.4786
0.26047 -1.4772
0.26853 -1.4758
0.27657 -1.4743
0.28461 -1.4728
0.29264 -1.4712
0.30066 -1.4696
0.30867 -1.4679
0.31667 -1.4662
0.32466 -1.4644
0.33264 -1.4627
0.34061 -1.4608
0.34858 -1.4589
0.35653 -1.457
0.36447 -1.455
0.3724 -1.453
0.38032 -1.451
0.38823 -1.4489
EOD
$s7 << EOD
0 0
0 -1.9
EOD
$s8 << EOD
1 1
0.99144 1.1305
0.96593 1.2588
0.92388 1.3827
0.86603 1.5
0.79335 1.6088
0.70711 1.7071
0.60876 1.7934
0.5 1.866
0.38268 1.9239
0.25882 1.9659
0.13053 1.9914
6.1232e-17 2
-0.13053 1.9914
-0.25882 1.9659
-0.38268 1.9239
-0.5 1.866
-0.60876 1.7934
-0.70711 1.7071
-0.79335 1.6088
-0.86603 1.5
-0.92388 1.3827
-0.96593 1.2588
-0.99144 1.1305
-1 1
-0.99144 0.86947
-0.96593 0.74118
-0.92388 0.61732
-0.86603 0.5
-0.79335 0.39124
-0.70711 0.29289
-0.60876 0.20665
-0.5 0.13397
-0.38268 0.07612
-0.25882 0.034074
-0.13053 0.0085551
-1.837e-16 0
0.13053 0.0085551
0.25882 0.034074
0.38268 0.07612
0.5 0.13397
0.60876 0.20665
0.70711 0.29289
0.79335 0.39124
0.86603 0.5
0.92388 0.61732
0.96593 0.74118
0.99144 0.86947
1 1
EOD
$s9 << EOD
1 1
0.99144 1.1305
0.96593 1.2588
0.92388 1.3827
0.86603 1.5
0.79335 1.6088
0.70711 1.7071
0.60876 1.7934
0.5 1.866
0.38268 1.9239
0.25882 1.9659
0.13053 1.9914
6.1232e-17 2
-0.13053 1.9914
-0.25882 1.9659
-0.38268 1.9239
-0.5 1.866
-0.60876 1.7934
-0.70711 1.7071
-0.79335 1.6088
-0.86603 1.5
-0.92388 1.3827
-0.96593 1.2588
-0.99144 1.1305
-1 1
-0.99144 0.86947
-0.96593 0.74118
-0.92388 0.61732
-0.86603 0.5
-0.79335 0.39124
-0.70711 0.29289
-0.60876 0.20665
-0.5 0.13397
-0.38268 0.07612
-0.25882 0.034074
-0.13053 0.0085551
-1.837e-16 0
0.13053 0.0085551
0.25882 0.034074
0.38268 0.07612
0.5 0.13397
0.60876 0.20665
0.70711 0.29289
0.79335 0.39124
0.86603 0.5
0.92388 0.61732
0.96593 0.74118
0.99144 0.86947
1 1
1 1
EOD
$s10 << EOD
1 3.8637
0.99144 3.9942
0.96593 4.1225
0.92388 4.2464
0.86603 4.3637
0.79335 4.4725
0.70711 4.5708
0.60876 4.6571
0.5 4.7297
0.38268 4.7876
0.25882 4.8296
0.13053 4.8551
6.1232e-17 4.8637
-0.13053 4.8551
-0.25882 4.8296
-0.38268 4.7876
-0.5 4.7297
-0.60876 4.6571
-0.70711 4.5708
-0.79335 4.4725
-0.86603 4.3637
-0.92388 4.2464
-0.96593 4.1225
-0.99144 3.9942
-1 3.8637
-0.99144 3.7332
-0.96593 3.6049
-0.92388 3.481
-0.86603 3.3637
-0.79335 3.2549
-0.70711 3.1566
-0.60876 3.0703
-0.5 2.9977
-0.38268 2.9398
-0.25882 2.8978
-0.13053 2.8723
-1.837e-16 2.8637
0.13053 2.8723
0.25882 2.8978
0.38268 2.9398
0.5 2.9977
0.60876 3.0703
0.70711 3.1566
0.79335 3.2549
0.86603 3.3637
0.92388 3.481
0.96593 3.6049
0.99144 3.7332
1 3.8637
EOD
$s11 << EOD
1 3.8637
0.99144 3.9942
0.96593 4.1225
0.92388 4.2464
0.86603 4.3637
0.79335 4.4725
0.70711 4.5708
0.60876 4.6571
0.5 4.7297
0.38268 4.7876
0.25882 4.8296
0.13053 4.8551
6.1232e-17 4.8637
-0.13053 4.8551
-0.25882 4.8296
-0.38268 4.7876
-0.5 4.7297
-0.60876 4.6571
-0.70711 4.5708
-0.79335 4.4725
-0.86603 4.3637
-0.92388 4.2464
-0.96593 4.1225
-0.99144 3.9942
-1 3.8637
-0.99144 3.7332
-0.96593 3.6049
-0.92388 3.481
-0.86603 3.3637
-0.79335 3.2549
-0.70711 3.1566
-0.60876 3.0703
-0.5 2.9977
-0.38268 2.9398
-0.25882 2.8978
-0.13053 2.8723
-1.837e-16 2.8637
0.13053 2.8723
0.25882 2.8978
0.38268 2.9398
0.5 2.9977
0.60876 3.0703
0.70711 3.1566
0.79335 3.2549
0.86603 3.3637
0.92388 3.481
0.96593 3.6049
0.99144 3.7332
1 3.8637
1 3.8637
EOD
$s12 << EOD
1.9463 -3.4
0.96593 0.25882
0.95038 0.31109
0.93201 0.36244
0.91086 0.41271
0.88701 0.46175
0.86052 0.50942
0.83147 0.55557
0.79995 0.60007
0.76604 0.64279
0.72986 0.68359
0.69151 0.72236
0.65111 0.75899
0.60876 0.79335
0.56461 0.82536
0.51877 0.85491
0.4714 0.88192
0.42262 0.90631
0.37258 0.928
0.32144 0.94693
0.26934 0.96305
0.21644 0.9763
0.1629 0.98664
0.10887 0.99406
0.054515 0.99851
2.8328e-16 1
-0.054515 0.99851
-0.10887 0.99406
-0.1629 0.98664
-0.21644 0.9763
-0.26934 0.96305
-0.32144 0.94693
-0.37258 0.928
-0.42262 0.90631
-0.4714 0.88192
-0.51877 0.85491
-0.56461 0.82536
-0.60876 0.79335
-0.65111 0.75899
-0.69151 0.72236
-0.72986 0.68359
-0.76604 0.64279
-0.79995 0.60007
-0.83147 0.55557
-0.86052 0.50942
-0.88701 0.46175
-0.91086 0.41271
-0.93201 0.36244
-0.95038 0.31109
-0.96593 0.25882
-1.9463 -3.4
EOD
$s13 << EOD
0 1 0.62161 0.78333
EOD
$s14 << EOD
0 0
EOD
$s15 << EOD
0 1
EOD
$s16 << EOD
0 3.8637
EOD
plot $s0 with filledcurves closed fc rgb fade(PINK,0.16) fs solid noborder notitle, \
 $s1 with lines lc rgb GREY lw 1 dt (6,5) notitle, \
 $s2 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s3 with lines lc rgb BLUE lw 1.6 dt solid notitle, \
 $s4 with lines lc rgb PINK lw 2.2 dt (6,5) notitle, \
 $s5 with vectors filled head size screen 0.022,18,60 lc rgb PINK lw 2 dt solid notitle, \
 $s6 with lines lc rgb INK lw 1.2 dt solid notitle, \
 $s7 with lines lc rgb GREY lw 1 dt (6,5) notitle, \
 $s8 with filledcurves closed fc rgb fade(AMBER,0.5) fs solid noborder notitle, \
 $s9 with lines lc rgb ORANGE lw 1.2 dt solid notitle, \
 $s10 with filledcurves closed fc rgb fade(AMBER,0.35) fs solid noborder notitle, \
 $s11 with lines lc rgb ORANGE lw 1.2 dt solid notitle, \
 $s12 with lines lc rgb GREEN lw 2.6 dt solid notitle, \
 $s13 with vectors filled head size screen 0.022,18,60 lc rgb GREEN lw 2 dt solid notitle, \
 $s14 with points pt 7 ps 0.5 lc rgb INK notitle, \
 $s15 with points pt 7 ps 0.5 lc rgb GREEN notitle, \
 $s16 with points pt 7 ps 0.5 lc rgb PINK notitle
