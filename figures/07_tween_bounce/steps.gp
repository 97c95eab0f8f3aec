# Draws steps.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
set output "steps." . format

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
set xrange [0:5]
set yrange [0:27]
set ytics 5
$coarse << EOD
0 25
0.2 15.3928
0.4 6.1784
0.6 0
0.8 3.11456
1 5.75776
1.2 7.9296
1.4 9.63008
1.6 10.8592
1.8 11.617
2 11.9034
2.2 11.7184
2.4 11.0621
2.6 9.9344
2.8 8.33536
3 6.26496
3.2 3.7232
3.4 0.71008
3.6 0
3.8 0
4 0
4.2 0
4.4 0
4.6 0
4.8 0
EOD
set label "Δ{/:Italic t} = 0.2" at 4.9, 24.5 right tc rgb BLUE
$middle << EOD
0 25
0.05 22.5246
0.1 20.0737
0.15 17.6473
0.2 15.2455
0.25 12.8683
0.3 10.5156
0.35 8.1874
0.4 5.8838
0.45 3.60475
0.5 1.35025
0.55 0
0.6 0.89648
0.65 1.7635
0.7 2.60106
0.75 3.40916
0.8 4.1878
0.85 4.93698
0.9 5.6567
0.95 6.34696
1 7.00776
1.05 7.6391
1.1 8.24098
1.15 8.8134
1.2 9.35636
1.25 9.86986
1.3 10.3539
1.35 10.8085
1.4 11.2336
1.45 11.6293
1.5 11.9955
1.55 12.3322
1.6 12.6395
1.65 12.9173
1.7 13.1657
1.75 13.3846
1.8 13.574
1.85 13.734
1.9 13.8645
1.95 13.9656
2 14.0372
2.05 14.0793
2.1 14.092
2.15 14.0752
2.2 14.029
2.25 13.9533
2.3 13.8481
2.35 13.7135
2.4 13.5494
2.45 13.3559
2.5 13.1329
2.55 12.8804
2.6 12.5985
2.65 12.2871
2.7 11.9463
2.75 11.576
2.8 11.1762
2.85 10.747
2.9 10.2883
2.95 9.80016
3 9.28256
3.05 8.7355
3.1 8.15898
3.15 7.553
3.2 6.91756
3.25 6.25266
3.3 5.5583
3.35 4.83448
3.4 4.0812
3.45 3.29846
3.5 2.48626
3.55 1.6446
3.6 0.77348
3.65 0
3.7 0
3.75 0
3.8 0
3.85 0
3.9 0
3.95 0
4 0
4.05 0
4.1 0
4.15 0
4.2 0
4.25 0
4.3 0
4.35 0
4.4 0
4.45 0
4.5 0
4.55 0
4.6 0
4.65 0
4.7 0
4.75 0
4.8 0
4.85 0
4.9 0
4.95 0
5 0
EOD
set label "Δ{/:Italic t} = 0.05" at 4.9, 22.3 right tc rgb PINK
$fine << EOD
0 25
0.034 23.3058
0.067 21.6724
0.101 20.0006
0.135 18.3401
0.169 16.6911
0.203 15.0533
0.236 13.4746
0.27 11.8593
0.305 10.2083
0.34 8.56927
0.375 6.94231
0.41 5.32738
0.452 3.40535
0.494 1.50064
0.527 0.016237
0.528 0
0.578 0.923878
0.628 1.8183
0.677 2.66624
0.727 3.50233
0.776 4.29311
0.826 5.07087
0.876 5.81917
0.926 6.538
0.975 7.21388
1.025 7.87438
1.075 8.50543
1.125 9.10702
1.175 9.67914
1.224 10.2112
1.274 10.725
1.324 11.2094
1.373 11.6554
1.423 12.0814
1.473 12.478
1.523 12.8451
1.572 13.1762
1.622 13.485
1.672 13.7643
1.722 14.0141
1.772 14.2345
1.822 14.4254
1.872 14.5868
1.922 14.7188
1.971 14.8196
2.021 14.8933
2.071 14.9375
2.121 14.9522
2.17 14.9381
2.22 14.8945
2.27 14.8214
2.32 14.7189
2.369 14.5899
2.419 14.4291
2.469 14.2388
2.519 14.019
2.568 13.7751
2.618 13.497
2.668 13.1894
2.718 12.8524
2.768 12.4859
2.817 12.0982
2.867 11.6734
2.917 11.2191
2.966 10.7454
3.016 10.2328
3.066 9.69074
3.116 9.11923
3.165 8.53057
3.215 7.90073
3.265 7.24142
3.315 6.55266
3.364 5.84909
3.414 5.102
3.464 4.32544
3.514 3.51943
3.564 2.68396
3.614 1.81902
3.664 0.924631
3.714 0.000777384
4.999 0
EOD
set label "Δ{/:Italic t} = 0.001" at 4.9, 20.1 right tc rgb INK
plot $coarse with linespoints pt 7 ps 0.55 lc rgb BLUE lw 2, $middle with linespoints pt 7 ps 0.55 lc rgb PINK lw 2, $fine with lines lc rgb INK lw 2
