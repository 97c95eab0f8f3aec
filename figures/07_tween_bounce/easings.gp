# Draws easings.svg; with -e "format='png'" (or 'pdf') and -e "theme='dark'" (or 'grey')
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
set output "easings." . format

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
$easing1 << EOD
0 0
0.0625 0.003906
0.125 0.01562
0.1875 0.03516
0.25 0.0625
0.3125 0.09766
0.375 0.1406
0.4375 0.1914
0.5 0.25
0.5625 0.3164
0.625 0.3906
0.6875 0.4727
0.75 0.5625
0.8125 0.6602
0.875 0.7656
0.9375 0.8789
1 1
EOD
$easing2 << EOD
0 0
0.0625 0.1211
0.125 0.2344
0.1875 0.3398
0.25 0.4375
0.3125 0.5273
0.375 0.6094
0.4375 0.6836
0.5 0.75
0.5625 0.8086
0.625 0.8594
0.6875 0.9023
0.75 0.9375
0.8125 0.9648
0.875 0.9844
0.9375 0.9961
1 1
EOD
$easing3 << EOD
0 0
0.0625 0.007812
0.125 0.03125
0.1875 0.07031
0.25 0.125
0.3175 0.2016
0.3845 0.2957
0.4485 0.4023
0.537 0.5713
0.5875 0.6597
0.648 0.7522
0.7085 0.8301
0.7815 0.9045
0.854 0.9574
0.927 0.9893
1 1
EOD
$easing4 << EOD
0 0
0.1925 0.007133
0.266 0.01882
0.3335 0.03709
0.399 0.06352
0.461 0.09797
0.5205 0.141
0.5775 0.1926
0.635 0.256
0.6905 0.3292
0.745 0.4135
0.798 0.5082
0.85 0.6141
0.901 0.7314
0.951 0.8601
1 1
EOD
$easing5 << EOD
0 0
0.049 0.1399
0.099 0.2686
0.15 0.3859
0.202 0.4918
0.255 0.5865
0.3095 0.6708
0.365 0.744
0.4225 0.8074
0.4795 0.859
0.539 0.902
0.601 0.9365
0.6665 0.9629
0.734 0.9812
0.8075 0.9929
1 1
EOD
$easing6 << EOD
0 0
0.096 0.003539
0.1665 0.01846
0.23 0.04867
0.2885 0.09605
0.319 0.1298
0.349 0.17
0.378 0.216
0.4065 0.2687
0.433 0.3247
0.459 0.3868
0.482 0.4479
0.5295 0.5834
0.5705 0.6831
0.5955 0.7353
0.6215 0.7831
0.6745 0.8621
0.7065 0.8989
0.74 0.9297
0.775 0.9544
0.812 0.9734
0.8915 0.9949
1 1
EOD
$easing7 << EOD
0 0
0.25 0.003906
0.329 0.01172
0.397 0.02484
0.4625 0.04576
0.522 0.07425
0.5775 0.1112
0.63 0.1575
0.6835 0.2182
0.734 0.2903
0.7825 0.3749
0.829 0.4723
0.8735 0.5822
0.917 0.7071
0.959 0.8458
1 1
EOD
$easing8 << EOD
0 0
0.041 0.1542
0.083 0.2929
0.1265 0.4178
0.171 0.5277
0.2175 0.6251
0.266 0.7097
0.3165 0.7818
0.37 0.8425
0.4225 0.8888
0.478 0.9258
0.5375 0.9542
0.603 0.9752
0.671 0.9883
0.75 0.9961
1 1
EOD
$easing9 << EOD
0 0
0.125 0.001953
0.1985 0.01242
0.261 0.03712
0.315 0.07876
0.3435 0.1114
0.3705 0.1507
0.3965 0.1977
0.421 0.2513
0.4435 0.3095
0.4655 0.3756
0.485 0.4426
0.525 0.5927
0.5425 0.6495
0.56 0.7002
0.582 0.7558
0.6045 0.8043
0.628 0.8468
0.6525 0.8833
0.6815 0.9177
0.712 0.945
0.745 0.9662
0.781 0.9816
0.862 0.9971
1 1
EOD
$easing10 << EOD
0 0
0.299 0.00239
0.447 0.01785
0.5115 0.03501
0.5685 0.05938
0.6205 0.09198
0.6685 0.1335
0.7185 0.1915
0.765 0.262
0.809 0.3465
0.8505 0.445
0.8905 0.56
0.9285 0.6901
0.965 0.8368
1 1
EOD
$easing11 << EOD
0 0
0.035 0.1632
0.0715 0.3099
0.1095 0.44
0.1495 0.555
0.191 0.6535
0.235 0.738
0.2815 0.8085
0.3315 0.8665
0.3795 0.908
0.4315 0.9406
0.4885 0.965
0.553 0.9822
0.701 0.9976
1 1
EOD
$easing12 << EOD
0 0
0.1495 0.001195
0.2235 0.008923
0.2845 0.02982
0.3345 0.067
0.361 0.0981
0.386 0.1371
0.409 0.1831
0.431 0.238
0.451 0.2985
0.47 0.367
0.487 0.4383
0.5215 0.5986
0.5365 0.6577
0.552 0.7113
0.5715 0.7689
0.592 0.8191
0.6135 0.862
0.636 0.8978
0.662 0.9294
0.6905 0.9546
0.7215 0.9732
0.7565 0.9863
0.837 0.9982
1 1
EOD
$easing13 << EOD
0 0
0.0535 0.003529
0.107 0.01409
0.161 0.03181
0.215 0.05649
0.27 0.0886
0.3255 0.1279
0.382 0.1747
0.4395 0.229
0.5545 0.3559
0.679 0.5169
0.815 0.7135
1 1
EOD
$easing14 << EOD
0 0
0.185 0.2865
0.321 0.4831
0.4455 0.6441
0.5605 0.771
0.618 0.8253
0.6745 0.8721
0.73 0.9114
0.785 0.9435
0.839 0.9682
0.893 0.9859
0.9465 0.9965
1 1
EOD
$easing15 << EOD
0 0
0.0535 0.007046
0.1075 0.02824
0.1625 0.06375
0.2195 0.1142
0.2815 0.1831
0.349 0.2716
0.42 0.3757
0.622 0.687
0.6855 0.7752
0.743 0.8457
0.8105 0.914
0.875 0.9619
0.938 0.9905
1 1
EOD
$easing16 << EOD
0 0
0.307 0.007231
0.4065 0.01538
0.4875 0.02771
0.5585 0.04594
0.6195 0.07064
0.673 0.1028
0.7205 0.1432
0.7665 0.1974
0.8085 0.2645
0.847 0.3456
0.882 0.4408
0.8985 0.4943
0.9145 0.5524
0.93 0.6152
0.945 0.6827
0.9595 0.755
0.9735 0.832
0.987 0.9137
1 1
EOD
$easing17 << EOD
0 0
0.013 0.08625
0.0265 0.168
0.0405 0.245
0.055 0.3173
0.07 0.3848
0.0855 0.4476
0.1015 0.5057
0.118 0.5592
0.153 0.6544
0.1915 0.7355
0.2335 0.8026
0.2795 0.8568
0.327 0.8972
0.3805 0.9294
0.4415 0.9541
0.5125 0.9723
0.5935 0.9846
0.693 0.9928
1 1
EOD
$easing18 << EOD
0 0
0.1535 0.003616
0.244 0.0139
0.31 0.03544
0.3365 0.05139
0.3605 0.07187
0.385 0.1011
0.407 0.1374
0.427 0.1814
0.4455 0.2346
0.462 0.295
0.477 0.3634
0.49 0.4352
0.507 0.5463
0.5165 0.6023
0.528 0.661
0.5405 0.715
0.5565 0.7718
0.5735 0.8198
0.5925 0.8617
0.613 0.896
0.6375 0.9261
0.6655 0.95
0.6975 0.9681
0.7345 0.9811
0.8305 0.9954
1 1
EOD
$easing19 << EOD
0 0
0.098 0.004814
0.195 0.0192
0.29 0.04297
0.3825 0.07604
0.4715 0.1181
0.5555 0.1685
0.6345 0.2271
0.707 0.2928
0.773 0.3656
0.8315 0.4445
0.882 0.5288
0.924 0.6176
0.9415 0.663
0.957 0.7099
0.97 0.7569
0.981 0.806
0.989 0.8521
0.995 0.9001
0.997 0.9226
0.9985 0.9452
0.9995 0.9684
1 1
EOD
$easing20 << EOD
0 0
0.0005 0.03162
0.0015 0.05475
0.003 0.0774
0.005 0.09987
0.011 0.1479
0.019 0.194
0.03 0.2431
0.043 0.2901
0.0585 0.337
0.076 0.3824
0.118 0.4712
0.1685 0.5555
0.227 0.6344
0.293 0.7072
0.3655 0.7729
0.4445 0.8315
0.5285 0.8819
0.6175 0.924
0.71 0.957
0.805 0.9808
0.902 0.9952
1 1
EOD
$easing21 << EOD
0 0
0.0575 0.003317
0.1145 0.01329
0.1695 0.02961
0.2225 0.05223
0.2725 0.08078
0.319 0.115
0.361 0.1541
0.3985 0.198
0.425 0.2366
0.448 0.278
0.467 0.3214
0.4815 0.3652
0.4905 0.403
0.4965 0.4409
0.4985 0.4613
0.4995 0.4776
0.5005 0.5224
0.5015 0.5387
0.5035 0.5591
0.5065 0.5804
0.517 0.6293
0.5325 0.6773
0.554 0.726
0.58 0.7713
0.611 0.8141
0.6465 0.8536
0.6825 0.8863
0.722 0.9156
0.8085 0.9619
0.9025 0.9904
1 1
EOD
$easing22 << EOD
0 0
0.0905 -0.01193
0.3125 -0.08372
0.3665 -0.09556
0.4145 -0.09995
0.4705 -0.0953
0.5225 -0.07917
0.572 -0.05113
0.619 -0.01123
0.6715 0.05074
0.7225 0.1307
0.7715 0.2278
0.8195 0.3441
0.866 0.4785
0.9115 0.6322
0.956 0.8053
0.978 0.8996
1 1
EOD
$easing23 << EOD
0 0
0.022 0.1004
0.044 0.1947
0.0885 0.3678
0.134 0.5215
0.1805 0.6559
0.2285 0.7722
0.2775 0.8693
0.3285 0.9493
0.381 1.011
0.428 1.051
0.4775 1.079
0.5295 1.095
0.5855 1.1
0.6335 1.096
0.6875 1.084
0.9095 1.012
1 1
EOD
$easing24 << EOD
0 0
0.045 -0.005907
0.156 -0.04179
0.207 -0.04997
0.235 -0.0477
0.261 -0.03969
0.286 -0.02557
0.3095 -0.005614
0.338 0.02849
0.365 0.07209
0.391 0.1257
0.4165 0.1904
0.4405 0.2633
0.4635 0.3449
0.484 0.428
0.5265 0.6158
0.545 0.6866
0.5635 0.7497
0.586 0.8165
0.6095 0.8755
0.6335 0.9251
0.6585 0.9665
0.686 1.001
0.7145 1.026
0.7445 1.042
0.7765 1.049
0.83 1.045
0.948 1.008
1 1
EOD
$easing25 << EOD
0 0
0.144 0.001013
0.2805 -0.0047
0.3945 0.01398
0.4255 0.01522
0.4685 0.00328
0.5435 -0.04093
0.573 -0.04511
0.595 -0.03495
0.617 -0.01157
0.6365 0.01899
0.6765 0.09283
0.693 0.117
0.708 0.1294
0.7215 0.1299
0.7315 0.1222
0.741 0.108
0.7505 0.08669
0.76 0.0583
0.7705 0.0191
0.782 -0.03213
0.822 -0.242
0.838 -0.3145
0.847 -0.345
0.855 -0.3634
0.863 -0.3721
0.8705 -0.37
0.8765 -0.3606
0.882 -0.3455
0.8875 -0.3238
0.893 -0.2955
0.8985 -0.2605
0.904 -0.2187
0.9095 -0.1702
0.915 -0.1153
0.925 5.641e-16
0.9355 0.1394
0.9455 0.2852
0.968 0.6276
0.979 0.7821
0.9845 0.8511
0.99 0.9126
0.995 0.9606
1 1
EOD
$easing26 << EOD
0 0
0.005 0.03939
0.01 0.08742
0.0155 0.1489
0.021 0.2179
0.032 0.3724
0.0545 0.7148
0.0645 0.8606
0.075 1
0.085 1.115
0.0905 1.17
0.096 1.219
0.1015 1.26
0.107 1.296
0.1125 1.324
0.118 1.345
0.1235 1.361
0.1295 1.37
0.137 1.372
0.145 1.363
0.153 1.345
0.162 1.314
0.178 1.242
0.218 1.032
0.2295 0.9809
0.24 0.9417
0.2495 0.9133
0.259 0.892
0.2685 0.8778
0.2785 0.8701
0.292 0.8706
0.307 0.883
0.3235 0.9072
0.3635 0.981
0.383 1.012
0.405 1.035
0.427 1.045
0.4565 1.041
0.5315 0.9967
0.5745 0.9848
0.6055 0.986
0.7195 1.005
0.856 0.999
1 1
EOD
$easing27 << EOD
0 0
0.1405 -0.002341
0.213 0.007592
0.2345 0.00152
0.2715 -0.02036
0.2865 -0.02256
0.2975 -0.01747
0.3085 -0.005787
0.3465 0.05848
0.361 0.06483
0.372 0.05102
0.383 0.01843
0.393 -0.02582
0.4135 -0.1333
0.4215 -0.1663
0.429 -0.1839
0.4355 -0.1848
0.4415 -0.171
0.447 -0.1448
0.4525 -0.1052
0.458 -0.0523
0.4625 2.821e-16
0.4675 0.06621
0.4845 0.3212
0.491 0.4103
0.4965 0.4712
0.5045 0.5386
0.5105 0.6089
0.516 0.6862
0.531 0.9126
0.539 1.018
0.545 1.083
0.5505 1.128
0.556 1.161
0.562 1.181
0.5695 1.185
0.578 1.168
0.5865 1.133
0.607 1.026
0.617 0.9816
0.628 0.949
0.639 0.9352
0.6535 0.9415
0.6915 1.006
0.7025 1.017
0.7135 1.023
0.7285 1.02
0.7655 0.9985
0.787 0.9924
0.8595 1.002
1 1
EOD
$easing28 << EOD
0 0
0.023 0.01181
0.0455 0.01562
0.068 0.01178
0.091 0.0001249
0.1135 0.0272
0.1365 0.04697
0.159 0.05856
0.1815 0.0625
0.204 0.05878
0.227 0.04706
0.25 0.02734
0.2725 0.0003121
0.297 0.06229
0.319 0.1111
0.3415 0.1534
0.364 0.188
0.3865 0.215
0.409 0.2343
0.4315 0.246
0.4545 0.25
0.477 0.2462
0.5 0.2344
0.5225 0.2151
0.545 0.1881
0.5675 0.1535
0.59 0.1112
0.6115 0.0637
0.6365 0.0007499
0.659 0.1206
0.6815 0.2328
0.704 0.3374
0.727 0.4364
0.7495 0.5255
0.7725 0.6086
0.795 0.6822
0.818 0.7495
0.8405 0.8076
0.8635 0.8591
0.886 0.9017
0.909 0.9374
0.9315 0.9645
0.9545 0.9843
0.977 0.996
1 1
EOD
$easing29 << EOD
0 0
0.0225 0.003829
0.0455 0.01566
0.068 0.03497
0.091 0.06263
0.114 0.09828
0.1365 0.1409
0.1595 0.1924
0.182 0.2505
0.2045 0.3163
0.227 0.3897
0.25 0.4727
0.2725 0.5616
0.295 0.6581
0.318 0.7648
0.341 0.8794
0.3635 0.9993
0.3885 0.9363
0.41 0.8888
0.4325 0.8465
0.455 0.8119
0.4775 0.7849
0.5 0.7656
0.5225 0.754
0.5455 0.75
0.568 0.7538
0.591 0.7657
0.6135 0.785
0.636 0.812
0.6585 0.8466
0.681 0.8889
0.703 0.9377
0.7275 0.9997
0.75 0.9727
0.773 0.9529
0.7955 0.9414
0.8185 0.9375
0.841 0.9414
0.8635 0.953
0.886 0.9723
0.909 0.9999
0.932 0.9882
0.9545 0.9844
0.977 0.9882
1 1
EOD
$easing30 << EOD
0 0
0.0225 0.007812
0.0455 6.247e-05
0.068 0.02331
0.091 0.03125
0.1135 0.02353
0.1365 0.0003747
0.159 0.0545
0.1815 0.09331
0.2045 0.1172
0.227 0.125
0.25 0.1172
0.2725 0.09406
0.2955 0.05459
0.318 0.0004995
0.3425 0.1248
0.3645 0.2223
0.387 0.3069
0.4095 0.3761
0.4335 0.4331
0.458 0.4733
0.481 0.4945
0.5135 0.5028
0.532 0.5155
0.5535 0.5433
0.5755 0.5862
0.602 0.6574
0.6285 0.7497
0.6545 0.861
0.682 0.9995
0.7045 0.9454
0.7275 0.9059
0.7505 0.8825
0.773 0.875
0.7955 0.8828
0.8185 0.9067
0.841 0.9455
0.8635 0.9996
0.8865 0.9765
0.909 0.9688
0.9315 0.9763
0.9545 0.9999
0.9775 0.9922
1 1
EOD
unset key
unset xlabel
unset tics
set border 3 lc rgb GREY
set xrange [-0.03:1.03]
set yrange [-0.42:1.42]
set multiplot
set label 11 "in" at screen 0.30, 0.035 center tc rgb RED
set label 12 "out" at screen 0.50, 0.035 center tc rgb BLUE
set label 13 "in-out" at screen 0.70, 0.035 center tc rgb GREEN
set lmargin at screen 0.025
set rmargin at screen 0.195
set bmargin at screen 0.56
set tmargin at screen 0.915
set label 1 "quadratic" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing1 with lines lc rgb RED lw 1.8, $easing2 with lines lc rgb BLUE lw 1.8, $easing3 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
set lmargin at screen 0.22
set rmargin at screen 0.39
set bmargin at screen 0.56
set tmargin at screen 0.915
set label 1 "cubic" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing4 with lines lc rgb RED lw 1.8, $easing5 with lines lc rgb BLUE lw 1.8, $easing6 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
set lmargin at screen 0.415
set rmargin at screen 0.585
set bmargin at screen 0.56
set tmargin at screen 0.915
set label 1 "quartic" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing7 with lines lc rgb RED lw 1.8, $easing8 with lines lc rgb BLUE lw 1.8, $easing9 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
set lmargin at screen 0.61
set rmargin at screen 0.78
set bmargin at screen 0.56
set tmargin at screen 0.915
set label 1 "quintic" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing10 with lines lc rgb RED lw 1.8, $easing11 with lines lc rgb BLUE lw 1.8, $easing12 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
set lmargin at screen 0.805
set rmargin at screen 0.975
set bmargin at screen 0.56
set tmargin at screen 0.915
set label 1 "sine" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing13 with lines lc rgb RED lw 1.8, $easing14 with lines lc rgb BLUE lw 1.8, $easing15 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
set lmargin at screen 0.025
set rmargin at screen 0.195
set bmargin at screen 0.105
set tmargin at screen 0.46
set label 1 "exponential" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing16 with lines lc rgb RED lw 1.8, $easing17 with lines lc rgb BLUE lw 1.8, $easing18 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
set lmargin at screen 0.22
set rmargin at screen 0.39
set bmargin at screen 0.105
set tmargin at screen 0.46
set label 1 "circular" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing19 with lines lc rgb RED lw 1.8, $easing20 with lines lc rgb BLUE lw 1.8, $easing21 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
set lmargin at screen 0.415
set rmargin at screen 0.585
set bmargin at screen 0.105
set tmargin at screen 0.46
set label 1 "back" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing22 with lines lc rgb RED lw 1.8, $easing23 with lines lc rgb BLUE lw 1.8, $easing24 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
set lmargin at screen 0.61
set rmargin at screen 0.78
set bmargin at screen 0.105
set tmargin at screen 0.46
set label 1 "elastic" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing25 with lines lc rgb RED lw 1.8, $easing26 with lines lc rgb BLUE lw 1.8, $easing27 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
set lmargin at screen 0.805
set rmargin at screen 0.975
set bmargin at screen 0.105
set tmargin at screen 0.46
set label 1 "bounce" at graph 0.5, 1.06 center font ",14" tc rgb INK
plot 1 with lines lc rgb PALE lw 1, 0 with lines lc rgb PALE lw 1, $easing28 with lines lc rgb RED lw 1.8, $easing29 with lines lc rgb BLUE lw 1.8, $easing30 with lines lc rgb GREEN lw 1.8
unset label 11
unset label 12
unset label 13
unset multiplot
