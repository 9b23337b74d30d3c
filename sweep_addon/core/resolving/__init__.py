# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection resolved: of a sweep that meets itself, the boundary of all points visited, as one closed manifold.

The sweep is taken apart into pieces none of which crosses itself, and manifold3d unites them. Where the contours move
forward everywhere, a piece is a tube of them (`pieces`), as long as no part of it comes near another; where they fold,
it is the convex hull of a few neighbouring contours, for each convex part of them (`blocks`). Never is a folded piece
given to a boolean as it is. What comes near nothing is not given to it at all, and joined again corner by corner
(`assembling`); of tubes that run beside each other only the sides that meet are given to it (`sectors`, `wedges`).
"""

OPEN = "A solid needs a closed contour and closed ends, got an open surface"
