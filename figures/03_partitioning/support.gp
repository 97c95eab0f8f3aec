# Draws support.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
  set terminal svg enhanced size 720,448 font font . ",17" fontscale letters rounded background rgb "#ffffff"
} else { if (format eq "png") {
  set terminal pngcairo enhanced size magnify * 1440,magnify * 896 font font . ",17" fontscale 2 * magnify * letters linewidth 2 * magnify pointscale 2 * magnify rounded background rgb PAPER
} else {
  set terminal pdfcairo enhanced size magnify * 7.500000,magnify * 4.666667 font font . ",13" fontscale 0.5 * magnify * letters linewidth magnify rounded background rgb PAPER
} }
set output "support." . format

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
set xrange [-3.5735:4.3235]
set yrange [-2.02482142:2.88908766]
set label "{/:Bold p}" at -2.6,-0.6 center offset character -0.9,-0.6 front tc rgb INK
set label "{/:Bold p} + {/:Italic τ} {/:Bold v}" at 0.9203071,-1.05132142 center offset character 0,-1.1 front tc rgb INK
set label "{/:Bold v}" at -0.13578503,-0.915924996 center offset character 0,-0.9 front tc rgb RED
set label "{/:Bold q}" at -1.15111126,-0.211771432 center offset character 0.4,0.9 front tc rgb GREEN
set label "{/:Italic s} / |{/:Bold q}|" at -1.1048807,1.61234932 center offset character -0.6,1.1 front tc rgb INK
set label "{/:Bold a}" at 1.75,-1.25 center offset character 1.3,-0.6 front tc rgb BLUE
set label "{/:Italic r}" at 1.28252929,-0.954264281 center offset character -0.2,1 front tc rgb INK
$s0 << EOD
1.75 -1.25
4.1 -0.4
2.5 1.7
EOD
$s1 << EOD
1.75 -1.25
4.1 -0.4
2.5 1.7
1.75 -1.25
EOD
$s2 << EOD
-2.6 -0.6
-3.0918 1.2353
EOD
$s3 << EOD
1.8655 -1.6811
0.70082 2.6656
EOD
$s4 << EOD
-1.1049 1.6123 -1.9481 -0.52198

-1.1049 1.6123 1.9481 0.52198
EOD
$s5 << EOD
1.6703 -1.0513
1.6675 -0.98595
1.6589 -0.92109
1.6448 -0.85721
1.6251 -0.79481
1.6 -0.73436
1.5698 -0.67632
1.5347 -0.62114
1.4948 -0.56923
1.4506 -0.52099
1.4024 -0.47679
1.3505 -0.43696
1.2953 -0.4018
1.2373 -0.37159
1.1768 -0.34655
1.1144 -0.32688
1.0505 -0.31272
0.98567 -0.30418
0.92031 -0.30132
0.85494 -0.30418
0.79007 -0.31272
0.72619 -0.32688
0.66379 -0.34655
0.60334 -0.37159
0.54531 -0.4018
0.49012 -0.43696
0.43822 -0.47679
0.38998 -0.52099
0.34577 -0.56923
0.30594 -0.62114
0.27079 -0.67632
0.24058 -0.73436
0.21554 -0.79481
0.19586 -0.85721
0.1817 -0.92109
0.17316 -0.98595
0.17031 -1.0513
0.17316 -1.1167
0.1817 -1.1816
0.19586 -1.2454
0.21554 -1.3078
0.24058 -1.3683
0.27079 -1.4263
0.30594 -1.4815
0.34577 -1.5334
0.38998 -1.5817
0.43822 -1.6259
0.49012 -1.6657
0.54531 -1.7008
0.60334 -1.7311
0.66379 -1.7561
0.72619 -1.7758
0.79007 -1.7899
0.85494 -1.7985
0.92031 -1.8013
0.98567 -1.7985
1.0505 -1.7899
1.1144 -1.7758
1.1768 -1.7561
1.2373 -1.7311
1.2953 -1.7008
1.3505 -1.6657
1.4024 -1.6259
1.4506 -1.5817
1.4948 -1.5334
1.5347 -1.4815
1.5698 -1.4263
1.6 -1.3683
1.6251 -1.3078
1.6448 -1.2454
1.6589 -1.1816
1.6675 -1.1167
1.6703 -1.0513
EOD
$s6 << EOD
1.6703 -1.0513
1.6675 -0.98595
1.6589 -0.92109
1.6448 -0.85721
1.6251 -0.79481
1.6 -0.73436
1.5698 -0.67632
1.5347 -0.62114
1.4948 -0.56923
1.4506 -0.52099
1.4024 -0.47679
1.3505 -0.43696
1.2953 -0.4018
1.2373 -0.37159
1.1768 -0.34655
1.1144 -0.32688
1.0505 -0.31272
0.98567 -0.30418
0.92031 -0.30132
0.85494 -0.30418
0.79007 -0.31272
0.72619 -0.32688
0.66379 -0.34655
0.60334 -0.37159
0.54531 -0.4018
0.49012 -0.43696
0.43822 -0.47679
0.38998 -0.52099
0.34577 -0.56923
0.30594 -0.62114
0.27079 -0.67632
0.24058 -0.73436
0.21554 -0.79481
0.19586 -0.85721
0.1817 -0.92109
0.17316 -0.98595
0.17031 -1.0513
0.17316 -1.1167
0.1817 -1.1816
0.19586 -1.2454
0.21554 -1.3078
0.24058 -1.3683
0.27079 -1.4263
0.30594 -1.4815
0.34577 -1.5334
0.38998 -1.5817
0.43822 -1.6259
0.49012 -1.6657
0.54531 -1.7008
0.60334 -1.7311
0.66379 -1.7561
0.72619 -1.7758
0.79007 -1.7899
0.85494 -1.7985
0.92031 -1.8013
0.98567 -1.7985
1.0505 -1.7899
1.1144 -1.7758
1.1768 -1.7561
1.2373 -1.7311
1.2953 -1.7008
1.3505 -1.6657
1.4024 -1.6259
1.4506 -1.5817
1.4948 -1.5334
1.5347 -1.4815
1.5698 -1.4263
1.6 -1.3683
1.6251 -1.3078
1.6448 -1.2454
1.6589 -1.1816
1.6675 -1.1167
1.6703 -1.0513
1.6703 -1.0513
EOD
$s7 << EOD
-1.85 -0.6
-1.8529 -0.53463
-1.8614 -0.46976
-1.8756 -0.40589
-1.8952 -0.34348
-1.9203 -0.28304
-1.9505 -0.225
-1.9856 -0.16982
-2.0255 -0.11791
-2.0697 -0.06967
-2.1179 -0.025467
-2.1698 0.014364
-2.225 0.049519
-2.283 0.079731
-2.3435 0.10477
-2.4059 0.12444
-2.4698 0.13861
-2.5346 0.14715
-2.6 0.15
-2.6654 0.14715
-2.7302 0.13861
-2.7941 0.12444
-2.8565 0.10477
-2.917 0.079731
-2.975 0.049519
-3.0302 0.014364
-3.0821 -0.025467
-3.1303 -0.06967
-3.1745 -0.11791
-3.2144 -0.16982
-3.2495 -0.225
-3.2797 -0.28304
-3.3048 -0.34348
-3.3244 -0.40589
-3.3386 -0.46976
-3.3471 -0.53463
-3.35 -0.6
-3.3471 -0.66537
-3.3386 -0.73024
-3.3244 -0.79411
-3.3048 -0.85652
-3.2797 -0.91696
-3.2495 -0.975
-3.2144 -1.0302
-3.1745 -1.0821
-3.1303 -1.1303
-3.0821 -1.1745
-3.0302 -1.2144
-2.975 -1.2495
-2.917 -1.2797
-2.8565 -1.3048
-2.7941 -1.3244
-2.7302 -1.3386
-2.6654 -1.3471
-2.6 -1.35
-2.5346 -1.3471
-2.4698 -1.3386
-2.4059 -1.3244
-2.3435 -1.3048
-2.283 -1.2797
-2.225 -1.2495
-2.1698 -1.2144
-2.1179 -1.1745
-2.0697 -1.1303
-2.0255 -1.0821
-1.9856 -1.0302
-1.9505 -0.975
-1.9203 -0.91696
-1.8952 -0.85652
-1.8756 -0.79411
-1.8614 -0.73024
-1.8529 -0.66537
-1.85 -0.6
EOD
$s8 << EOD
-1.85 -0.6
-1.8529 -0.53463
-1.8614 -0.46976
-1.8756 -0.40589
-1.8952 -0.34348
-1.9203 -0.28304
-1.9505 -0.225
-1.9856 -0.16982
-2.0255 -0.11791
-2.0697 -0.06967
-2.1179 -0.025467
-2.1698 0.014364
-2.225 0.049519
-2.283 0.079731
-2.3435 0.10477
-2.4059 0.12444
-2.4698 0.13861
-2.5346 0.14715
-2.6 0.15
-2.6654 0.14715
-2.7302 0.13861
-2.7941 0.12444
-2.8565 0.10477
-2.917 0.079731
-2.975 0.049519
-3.0302 0.014364
-3.0821 -0.025467
-3.1303 -0.06967
-3.1745 -0.11791
-3.2144 -0.16982
-3.2495 -0.225
-3.2797 -0.28304
-3.3048 -0.34348
-3.3244 -0.40589
-3.3386 -0.46976
-3.3471 -0.53463
-3.35 -0.6
-3.3471 -0.66537
-3.3386 -0.73024
-3.3244 -0.79411
-3.3048 -0.85652
-3.2797 -0.91696
-3.2495 -0.975
-3.2144 -1.0302
-3.1745 -1.0821
-3.1303 -1.1303
-3.0821 -1.1745
-3.0302 -1.2144
-2.975 -1.2495
-2.917 -1.2797
-2.8565 -1.3048
-2.7941 -1.3244
-2.7302 -1.3386
-2.6654 -1.3471
-2.6 -1.35
-2.5346 -1.3471
-2.4698 -1.3386
-2.4059 -1.3244
-2.3435 -1.3048
-2.283 -1.2797
-2.225 -1.2495
-2.1698 -1.2144
-2.1179 -1.1745
-2.0697 -1.1303
-2.0255 -1.0821
-1.9856 -1.0302
-1.9505 -0.975
-1.9203 -0.91696
-1.8952 -0.85652
-1.8756 -0.79411
-1.8614 -0.73024
-1.8529 -0.66537
-1.85 -0.6
-1.85 -0.6
EOD
$s9 << EOD
-2.6 -0.6 3.5203 -0.45132
EOD
$s10 << EOD
0.92031 -1.0513 0.72444 0.19411
EOD
$s11 << EOD
-2.6 -0.6 1.4489 0.38823
EOD
$s12 << EOD
1.75 -1.25
EOD
$s13 << EOD
0.92031 -1.0513

-2.6 -0.6
EOD
plot $s0 with filledcurves closed fc rgb FLOOR fs solid noborder notitle, \
 $s1 with lines lc rgb BLUE lw 1.6 dt solid notitle, \
 $s2 with lines lc rgb GREY lw 1 dt (6,5) notitle, \
 $s3 with lines lc rgb GREEN lw 2 dt (6,5) notitle, \
 $s4 with vectors filled head size screen 0.022,18,60 lc rgb INK lw 1.6 dt solid notitle, \
 $s5 with filledcurves closed fc rgb fade(AMBER,0.4) fs solid noborder notitle, \
 $s6 with lines lc rgb ORANGE lw 1.2 dt solid notitle, \
 $s7 with filledcurves closed fc rgb AMBER fs solid noborder notitle, \
 $s8 with lines lc rgb ORANGE lw 1.2 dt solid notitle, \
 $s9 with vectors filled head size screen 0.022,18,60 lc rgb RED lw 2.4 dt solid notitle, \
 $s10 with vectors filled head size screen 0.022,18,60 lc rgb INK lw 1.6 dt solid notitle, \
 $s11 with vectors filled head size screen 0.022,18,60 lc rgb GREEN lw 2.4 dt solid notitle, \
 $s12 with points pt 7 ps 0.5 lc rgb BLUE notitle, \
 $s13 with points pt 7 ps 0.5 lc rgb INK notitle
