#!/usr/bin/env python3
"""Writes mode_operator.csv: rows of U in 120-digit arithmetic (mpmath), the independent reference of ModeOperatorTest.

Basis u^k e^(+-ru) (monomials at r = 0), the conditions solved by mpmath's LU. Run: python3 mode_operator.py > mode_operator.csv
"""
import mpmath as mp

mp.mp.dps = 120
THIRD = mp.mpf(1.0 / 3.0)       # the doubles that the program uses
TWO_THIRDS = mp.mpf(2.0 * (1.0 / 3.0))
VALUES = [(mp.mpf(0), 0), (THIRD, 0), (TWO_THIRDS, 0), (mp.mpf(1), 0)]
def ends(*orders): return [(mp.mpf(e), d) for e in (0, 1) for d in orders]
LISTS = {
    "four-curve": VALUES,
    "derivative": ends(0, 1),
    "sixth-order": ends(0, 1, 2),
    "tangent": VALUES + ends(1),
    "curvature": VALUES + ends(1, 2),
}
RATES = ["1e-6", "1e-4", "0.01", "0.1", "0.5", "1", "2", "4.9", "5", "5.1", "6", "8", "10", "20", "40", "60"]

def term(k, rate, u, d):
    """d-th derivative of u^k e^(rate u)"""
    total = mp.mpf(0)
    for l in range(min(k, d) + 1):
        total += mp.binomial(d, l) * mp.ff(k, l) * (u ** (k - l) if k > l else 1) * (rate ** (d - l) if d > l else 1)
    return total * mp.exp(rate * u)

def basis(m, rate, u, d):
    return [term(k, s * rate, u, d) for s in (1, -1) for k in range(m)]

print("conditions,rate,u,derivative,coefficients...")
for name, conditions in LISTS.items():
    m = len(conditions) // 2
    for text in RATES:
        rate = mp.mpf(float(text))
        a = mp.matrix([basis(m, rate, u, d) for u, d in conditions])
        inverse = a ** -1
        for u in ("0", "0.0625", "0.3125", "0.5", "0.78125", "1"):
            for d in (0, 1, 2):
                row = mp.matrix([basis(m, rate, mp.mpf(u), d)]) * inverse
                print(name, text, u, d, *[mp.nstr(x, 20) for x in row], sep=",")
