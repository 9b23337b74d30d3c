# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection, the first problem of sweeping: where a sweep meets itself, and up to which size it does not.

Local, where the generator turns faster than it moves; at corners whose legs are shorter than their mitres; and global,
where parts meet that are far from each other along the trajectory, or a face at an end.
"""
