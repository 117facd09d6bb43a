"""Slow, readable twin of the least-squares step of a quarter car fitted to a stretch: NumPy only, no code of jounce.

In the bins s = 2 pi i f of a stretch, with B = ms s^2 + k + c s, W = mu s^2 + k + c s + kt + ct s, S = k + c s and
T = kt + ct s:

    force = H height + (a0 + a1 s + ... + a4 s^4) / (B W - S^2)      H = T - T^2 B / (B W - S^2)

The transients a0 ... a4, which are real, are projected out by a QR factorisation (variable projection after Golub and
Pereyra, in Kaufman's form with the transient's own slope).
"""

from __future__ import annotations

import numpy as np


def response_and_slopes(parameters, s):
    """H (n,) and its derivatives (n, 6) by mu, k, c, kt, ct, ms."""
    mu, k, c, kt, ct, ms = parameters
    strut, tyre = k + c * s, kt + ct * s
    body = strut / (ms * s * s + strut)
    wheel = 1.0 / (mu * s * s + strut * (1.0 - body) + tyre)
    through = (tyre * wheel) ** 2
    by_strut = through * (1.0 - body) ** 2
    by_tyre = (1.0 - tyre * wheel) ** 2
    by_mass = through * s * s
    slopes = [by_mass, by_strut, by_strut * s, by_tyre, by_tyre * s, by_mass * body * body]
    return tyre - tyre * tyre * wheel, np.stack(slopes, axis=1)


def denominator_and_slopes(parameters, s):
    """B W - S^2 (n,) and its derivatives (n, 6)."""
    mu, k, c, kt, ct, ms = parameters
    strut = k + c * s
    body, wheel = ms * s * s + strut, mu * s * s + strut + kt + ct * s
    both = body + wheel - 2.0 * strut
    slopes = [s * s * body, both, both * s, body, body * s, s * s * wheel]
    return body * wheel - strut * strut, np.stack(slopes, axis=1)


def real(values):
    return np.concatenate([values.real, values.imag])


def normal_equations(parameters, speed, height, force):
    """Sum of squares, J' J, J' r, and what is left of the force."""
    s = 1j * speed
    response, slopes = response_and_slopes(parameters, s)
    value, of_value = denominator_and_slopes(parameters, s)
    columns = (s / abs(s[-1]))[:, None] ** np.arange(5) / value[:, None]
    columns /= np.linalg.norm(columns, axis=0)
    basis, upper = np.linalg.qr(real(columns))
    missed = real(force - response * height)
    share = basis.T @ missed
    transient = columns @ np.linalg.solve(upper, share)
    left = missed - basis @ share
    jacobian = real(slopes * height[:, None] - transient[:, None] * of_value / value[:, None])
    jacobian -= basis @ (basis.T @ jacobian)
    return (
        left @ left,
        jacobian.T @ jacobian,
        jacobian.T @ left,
        left[: speed.size] + 1j * left[speed.size :],
    )
