#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a hilly surface of about so many faces as OFF: write_hills.py FACES FILE.off"""

import math
import sys

side = 1 + math.isqrt(int(sys.argv[1]) // 2)  # vertices
with open(sys.argv[2], "w", encoding="ascii") as file:
    file.write(f"OFF\n{side * side} {2 * (side - 1) ** 2} 0\n")
    for j in range(side):
        for i in range(side):
            x, y = i / (side - 1), j / (side - 1)
            file.write(f"{x:.9g} {y:.9g} {0.15 * math.sin(7 * x) * math.cos(5 * y) + 0.05 * math.sin(23 * x * y):.9g}\n")
    for j in range(side - 1):
        for a in range(j * side, j * side + side - 1):
            file.write(f"3 {a} {a + 1} {a + side + 1}\n3 {a} {a + side + 1} {a + side}\n")
