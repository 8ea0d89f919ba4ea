# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A script for Gappa for each bound of the filters. README.md beside this file says what each one proves.

    python3 scripts.py    writes those that are committed anew
"""

import re
from fractions import Fraction
from pathlib import Path

import formulas
from formulas import U, Computed, Definitions, Products, Row, Underflowing, Wide, found

ROWS = "abcd"
RELATIVE = "@add = add_rel<53>;\n@sub = sub_rel<53>;\n@mul = mul_rel<53>;\n"
SLACK = 40  # so many bits of a constant pay for the roundings of the bound itself


def written(title, definitions, given, goals, precision=128):
    lines = [f"#@ -Eprecision={precision} -Eno-auto-dichotomy", *(f"# {line}" for line in title), "", *definitions, "",
             "{ " + "\n  /\\ ".join(given), "->", "  " + "\n  /\\ ".join(goals) + " }"]
    return "\n".join(lines) + "\n"


def binary(fraction):
    """A dyadic rational as Gappa writes it."""
    exponent = fraction.denominator.bit_length() - 1
    if fraction.denominator != 1 << exponent:
        raise AssertionError(f"{fraction} is no dyadic rational")
    return f"{fraction.numerator}b-{exponent}"


def limit_of(constant, unit=U):
    return binary(constant * unit * (1 - Fraction(1, 2**SLACK)))


def of_square(weighted=False):
    """The most by which a squared length is wrong, relative to itself: it is a sum of squares, none negative. A size has
    another such term, the absolute value of a difference of weights, and w is wrong by at most that share of the size."""
    numbers = [Products.leaf(k, 1) for k in ["x", "y", "z", "dw"][:3 + weighted]]
    most = max(Row.lifted(*numbers, *[None] * (not weighted)).most(), Wide.w(*numbers).most())
    bound = Fraction(most * 16 + 1, 16) * U
    assert ((1 + U) ** most - 1) * (1 - U) ** -most < bound  # also of the size as computed
    return bound


SIZES = ["w", "the sizes of w"]


# Determinants, of leaves of any kind.

def sphere(r):
    of = formulas.sphere_cofactors(*r)
    return formulas.lifted(of, *r)


def beyond(r):
    return formulas.determinant_of(*r[:3])


def circle(r):
    return formulas.lifted_circle(formulas.circle_cofactors(r[:3])[0], r[:3])


def area(r):
    return formulas.circle_cofactors(r[:3])[1]


def wide_sphere(r):
    return Wide.sphere(r[0], r[1:])


def wide_view(r):
    return Wide.view(r)


def cofactor(r):
    return formulas.sphere_cofactors(*r)[0]


def wide_facet(r):
    x, y, z, _ = Wide.columns(r)
    return Wide.Minors(x, y, "xy_").times(z)


# Bounds by columns.

def by_columns(determinants, constant, bound, columns, weighted=False):
    """The largest of each column is 1: the bound is one of all columns to the power of 1. With weights the largest size is,
    and no w is larger, as rounding is monotonic."""
    definitions, given = Definitions(RELATIVE), []
    for name in ROWS:
        for k in "xyz":
            given += [f"|{name}{k}| <= 1", f"|{name}{k} -/ {name.upper()}{k.upper()}| <= 1b-53"]
        given += [f"|{name}w| <= 1", f"|{name}w {'-' if weighted else '-/'} {name.upper()}W| <= {binary(of_square(weighted))}"]
    rows = [Row(*(Computed(definitions, name + k, name.upper() + k.upper()) for k in "xyzw")) for name in ROWS]
    limit, goals = limit_of(constant), []
    for n, determinant in enumerate(determinants):
        definitions.suffix = f"_{n}"
        determinant(rows).named("value")
        goals.append(f"|value_{n} - VALUE_{n}| <= {limit}")
    definitions.lines.append(f"bound = {bound(binary(constant * U))};")
    used = " ".join(definitions.lines)
    given = [g for g in given if re.search(rf"\b{g[1:3]}\b", used)]
    return written([f"The error of a determinant, where the largest in each column ({columns}) is 1, is at most",
                    f"{constant} u, and so is the bound as it is computed. Any roundings may be left out by fused operations."],
                   definitions.lines, given, goals + [f"bound >= {limit}"])


def columns_four(constant, weighted=False):
    found(r"return factor \* unit_of_double \* (\(\(x \* y\) \* \(z \* w\)\)) \+ tiny;", "Sphere_filter.h")
    found(r"Column_sizes\(a, b, c, d\)\.bound_of_four\(w, (Bound_factors<R>::columns)\)", "Sphere_filter.h")
    found(r"sizes\.bound_of_four\(largest_of\(rows\.size\), (Bound_factors<Row_of<Place>>::columns)\)", "Sphere_filter.h")
    return by_columns([sphere, wide_sphere, wide_view], constant,
                      lambda c: f"add(mul({c}, mul(mul(1, 1), mul(1, 1))), 0)", f"x, y, z, {SIZES[weighted]}", weighted)


def columns_three(constant):
    found(r"return three \* unit_of_double \* (\(x \* y \* z\)) \+ tiny;", "Sphere_filter.h")
    return by_columns([beyond, cofactor, wide_facet], constant,
                      lambda c: f"add(mul({c}, mul(mul(1, 1), 1)), 0)", "x, y, z")


def columns_circle(constant, weighted=False):
    return by_columns([circle], constant, lambda c: f"add(mul(mul({c}, mul(1, 1)), 1), 0)", f"s, t, {SIZES[weighted]}", weighted)


def columns_area(constant):
    found(r"(\d+) \* Filter_bounds::unit \* box \+ Column_sizes::tiny", "Compact_predicates.h")
    return by_columns([area], constant, lambda c: f"add(mul({c}, mul(1, 1)), 0)", "s, t")


# Bounds by lengths: the largest squared length, as computed, is 1.

def rows_of_products(roundings, weighted=False):
    return [Row(*(Products.leaf(name + k, roundings) for k in "xyz"), dw=Products.leaf(name + "dw", roundings) if weighted else None)
            for name in ROWS]


def most_roundings(determinants, roundings=1, weighted=False):
    return max(determinant(rows_of_products(roundings, weighted)).most() for determinant in determinants)


def by_lengths(roundings, products, bound, limit, why, unit=53, of_largest=None):
    """products: what the absolute values of the products of a determinant sum up to, at most."""
    names = [f"d{k}" for k in range(1, roundings + 1)]
    definitions = [RELATIVE, "roundings = " + " * ".join(f"(1 + {name})" for name in names) + " - 1;",
                   "M = 1 / (1 + dm); # exactly, where it is 1 as computed",
                   "root = sqrt(1) * (1 + dr);", f"products = {products};", f"bound = {bound};"]
    given = [f"|{name}| <= 1b-{unit}" for name in names]
    given += [f"|dm| <= {binary(of_largest or of_square())}", "|dr| <= 1b-53"]
    return written([f"No product of the determinant goes through more than {roundings} roundings (counted), and their absolute",
                    f"values sum up to at most `products`: {why}."],
                   definitions, given, [f"|roundings * products| <= {limit}", f"bound >= {limit}"])


HADAMARD = "for each w by an inequality of Hadamard type for permanents (Carlen, Lieb, Loss 2006)"


def lengths_four(constant, weighted=False):
    found(r"Bound_factors<R>::four \* unit \* (\(m \* m \* std::sqrt\(m\)\)) \+ tiny", "Sphere_filter.h")
    found(r"m \* m \* sqrt_of\(m\) \* (\(Factors::four \* Filter_bounds::unit\)) \+ Filter_bounds::tiny", "Sphere_filter.h")
    return by_lengths(most_roundings([sphere, wide_sphere, wide_view], 1, weighted), "4 * (2 / sqrt(3)) * M * M * sqrt(M)",
                      f"add(mul({binary(constant * U)}, mul(mul(1, 1), root)), 0)", limit_of(constant), HADAMARD,
                      of_largest=of_square(weighted))


def lengths_three(constant):
    return by_lengths(most_roundings([beyond, cofactor, wide_facet]), "(2 / sqrt(3)) * M * sqrt(M)",
                      f"add(mul({binary(constant * U)}, mul(1, root)), 0)", limit_of(constant), HADAMARD)


def lengths_circle(constant, weighted=False):
    found(r"(Bound_factors<R>::circle \* Filter_bounds::unit \* m \* m \+ Filter_bounds::tiny)", "Compact_predicates.h")
    return by_lengths(most_roundings([circle], 1, weighted), "3 * M * M", f"add(mul(mul({binary(constant * U)}, 1), 1), 0)",
                      limit_of(constant), "for each w by the inequality of Cauchy and Schwarz", of_largest=of_square(weighted))


def lengths_area(constant):
    return by_lengths(most_roundings([area]), "3 * M", f"add(mul({binary(constant * U)}, 1), 0)",
                      limit_of(constant), "by the inequality of Cauchy and Schwarz, thrice")


def collinear(constant):
    text = found(r"certified_sign\((s\.x \* t\.y - s\.y \* t\.x), bound\)", "exact_signs.h")
    s, t, *_ = rows_of_products(1)
    roundings = formulas.evaluated(text, s=s, t=t).most()
    return by_lengths(roundings, "M", f"add(mul({binary(constant * U)}, 1), 0)", limit_of(constant),
                      "by the inequality of Cauchy and Schwarz")


# Sums of two doubles.

NORMALIZED = ["h = add(p, l);", "t = sub(h, p);", "low = sub(l, t);"]
HINTS = ["h - p -> l + (h - (p + l));", "l - t -> -(h - (p + l)) - (t - (h - p));"]


SIZE = binary(1 + Fraction(1, 2**90))  # of a number of size 1, its own error included


def double_double_product(constant):
    found(r"(double product = opaque\(s\.high \* t\.high\); const double error = Products::error\(s\.high, t\.high, product\); "
          r"return normalized\(product, error \+ \(opaque\(s\.high \* t\.low\) \+ opaque\(s\.low \* t\.high\)\)\);)",
          "Double_double.h")
    text = of_double_doubles(
        ["p = mul(sh, th);", "e = sh * th - p; # exactly: Dekker (1971), or fma",
         "l = add(e, add(mul(sh, tl), mul(sl, th)));", *NORMALIZED, "exact = (sh + sl) * (th + tl);"],
        [f"|sh + sl| <= {SIZE}", "|sl| <= 1b-52", f"|th + tl| <= {SIZE}", "|tl| <= 1b-52"], constant,
        ["A product of two numbers of size 1."])
    return text + "".join(line + "\n" for line in HINTS + [
        "(h + low) - exact -> ((low - (l - t)) - (t - (h - p))) + (l - (e + (sh * tl + sl * th))) - sl * tl;",
        "sh -> (sh + sl) - sl;", "th -> (th + tl) - tl;"])


def double_double_sum(constant):
    found(r"(double sum = s\.high \+ t\.high; const double error = error_of_difference\(s\.high, -t\.high, sum\); "
          r"return normalized\(sum, error \+ \(s\.low \+ t\.low\)\);)", "Double_double.h")
    text = of_double_doubles(
        ["p = add(sh, th);", "e = (sh + th) - p; # exactly: Knuth (1969)", "l = add(e, add(sl, tl));", *NORMALIZED,
         "exact = (sh + th) + (sl + tl);"],
        [f"|(sh + th) + (sl + tl)| <= {SIZE}", "|sl + tl| <= 1b-52"], constant,
        ["A sum of two numbers whose sizes sum up to 1."])
    return text + "".join(line + "\n" for line in HINTS + [
        "(h + low) - exact -> ((low - (l - t)) - (t - (h - p))) + (l - (e + (sl + tl)));",
        "sh + th -> exact - (sl + tl);"])


def of_double_doubles(definitions, given, constant, title):
    found(r"(const double sum = high \+ low; return \{sum, low - \(sum - high\)\};)", "Double_double.h")
    return written([*title, "Size is what the absolute values of the products in a number sum up to. That the sum of `normalized` is exact",
                    "is not needed."],
                   [RELATIVE, *definitions], given,
                   [f"|(h + low) - exact| <= {binary(constant)}", "|low| <= 1b-52"], 256)


OF_PRODUCT = Fraction(1, 2**100)  # of double_double_product and double_double_sum


def double_double_sphere(constant, weighted=False):
    found(r"(r\[k\] = \{x, y, z, dw\}; sizes\[k\] = size_of\(Power_row\(x\.high, y\.high, z\.high, dw\.high\)\);)", "Double_double.h")
    found(r"(r\[k\] = \{x, y, z\}; sizes\[k\] = r\[k\]\.w\.high;)", "Double_double.h")
    of_largest = of_square(True) if weighted else Fraction(1, 2**51)  # as the first filter has it; as it is computed here
    assert of_largest > U * 2 + OF_PRODUCT * 6
    limit = binary(constant * (1 - Fraction(1, 2**SLACK)))
    return by_lengths(most_roundings([sphere], 0, weighted), "4 * (2 / sqrt(3)) * M * M * sqrt(M)",
                      f"add(mul({binary(constant)}, mul(mul(1, 1), root)), 0)", limit, HADAMARD, 100, of_largest)


# Balanced signs.

def balanced_products(roundings, n=4):
    """The products of rows D, w = D · F + a difference of weights; `roundings`: of a difference."""
    rows = []
    for name in ROWS[:n]:
        row = Row(*(Products.leaf(name + k, roundings) for k in "xyz"))
        f = [Products.leaf(f"{name}{k}p", roundings) + Products.leaf(f"{name}{k}q", roundings) for k in "xyz"]
        row.w = formulas.balanced_w(row, f, Products.leaf(f"{name}dw", roundings))
        rows.append(row)
    return (sphere(rows) if n == 4 else beyond(rows)).most()


def balanced(constant, of_value, unit):
    of_size = max(balanced_products(1), balanced_products(1, 3))
    found(r"(Numbers::error \* d\.size \+ 0x1p-880)", "balanced_signs.h")
    values, sizes = [f"d{k}" for k in range(1, of_value + 1)], [f"s{k}" for k in range(1, of_size + 1)]
    limit = binary(constant * (1 - Fraction(1, 2**SLACK)) * (1 - U) ** (of_size + 2))
    return written([f"A product goes through at most {of_value} roundings of 2^-{unit}, its size through at most {of_size} of 2^-53 (counted);",
                    "the absolute values of all products sum up to 1."],
                   [RELATIVE, "error = " + " * ".join(f"(1 + {d})" for d in values) + " - 1;",
                    "size = " + " * ".join(f"(1 + {s})" for s in sizes) + ";", f"bound = add(mul({binary(constant)}, size), 0);"],
                   [f"|{d}| <= 1b-{unit}" for d in values] + [f"|{s}| <= 1b-53" for s in sizes],
                   [f"|error| <= {limit}", f"bound >= {limit}"], 2048)


def balanced_doubles(constant):
    return balanced(constant * U, max(balanced_products(1), balanced_products(1, 3)), 53)


def balanced_double_doubles(constant):
    return balanced(constant, max(balanced_products(0), balanced_products(0, 3)), 100)


# What underflows.

class Underflows:
    def __init__(self):
        self.n, self.lines, self.given, self.hints = 0, [], [], []

    def count(self):
        self.n += 1
        return self.n

    def leaf(self, name, size):
        self.given.append(f"|{name}| <= {size}")
        return Underflowing(self, name, name)

    def rounded_leaf(self, name, size):
        """A difference of weights, each of which two products rounded when it was scaled, by less than 2^-1074."""
        self.given += [f"|{name}| <= {size}", f"|{name}_o| <= {size}", f"|{name} - {name}_o| <= 1b-1073"]
        return Underflowing(self, name, f"{name}_o")


def underflow(determinants, size, tiny, size_of_weights, makes_w=None):
    """The coordinates of rows are at most `size`. Half of `tiny` is left for what underflows in the bound."""
    text, goals = Underflows(), []
    limit = Fraction(1)
    while limit > tiny / 2:
        limit /= 2
    for n, determinant in enumerate(determinants):
        rows = []
        for name in ROWS:
            row = Row(*(text.leaf(f"{name}{k}_{n}", size) for k in "xyz"), w=0)
            dw = text.rounded_leaf(f"{name}dw_{n}", size_of_weights) if makes_w is None else text.leaf(f"{name}dw_{n}", size_of_weights)
            row.w = makes_w(text, f"{name}_{n}", row, dw) if makes_w else Row.lifted(row.x, row.y, row.z, dw)
            rows.append(row)
        result = determinant(rows)
        goals += [f"|{result.text} - {result.other}| <= {binary(limit)}", f"|{result.text}| <= 1b400"]
    return written(["t: as computed; o: with the same relative errors, and none from underflow. No operation overflows, as the result",
                    "is the largest number. Without weights their differences are 0."],
                   text.lines, text.given, goals) + "\n" + "\n".join(text.hints) + "\n"


def underflow_lengths(tiny):
    return underflow([sphere, wide_sphere], "1", tiny, "1")


def underflow_columns(tiny):
    return underflow([sphere], "1b60", tiny, "1b120")


def underflow_balanced(tiny):
    def w(text, name, row, dw):
        f = [text.leaf(f"{name}p{k}", "1b60") + text.leaf(f"{name}q{k}", "1b60") for k in "xyz"]
        return formulas.balanced_w(row, f, dw)
    found(r"(wanted = \(std::min\)\(1022 \+ 121 \+ 1023 - exponent, std::uint64_t\(2023\)\);)", "balanced_signs.h")
    return underflow([sphere], "1b60", tiny, "1b122", w)


def read(pattern, header):
    return lambda: formulas.number(found(pattern, header))


def factor(name, weighted=False):
    """One of Bound_factors."""
    text = r"template <> struct Bound_factors<Power_row>" if weighted else r"template <class R> struct Bound_factors"
    return lambda: formulas.number(found(text + r" \{ static constexpr double [^;]*?" + name + r" = (\d+)[,;]", "Sphere_filter.h"))


def weighted(make):
    return lambda constant: make(constant, True)


DOUBLE_DOUBLES = read(r"bound = 1\. / (\d+)\. \* \(m \* m \* std::sqrt\(m\)\)", "Double_double.h")
BOX = read(r"(\d+) \* Filter_bounds::unit \* box \* m \+ Column_sizes::tiny", "Compact_predicates.h")


# Script: what makes it of a constant; the constant in the header; the least (of integers, or of powers of 2) that is proved.
SCRIPTS = {
    "lengths_four": (lengths_four, factor("four"), 74),
    "lengths_three": (lengths_three, read(r"else return (\d+) \* unit \* \(m \* std::sqrt\(m\)\) \+ tiny",
                                          "Sphere_filter.h"), 10),
    "lengths_circle": (lengths_circle, factor("circle"), 37),
    "lengths_area": (lengths_area, read(r"(\d+) \* Filter_bounds::unit \* m \+ Filter_bounds::tiny",
                                        "Compact_predicates.h"), 19),
    "columns_four": (columns_four, factor("columns"), 378),
    "columns_three": (columns_three, read(r"three = (\d+);", "Sphere_filter.h"), 47),
    "columns_circle": (columns_circle, BOX, 71),
    "columns_area": (columns_area, read(r"(\d+) \* Filter_bounds::unit \* box \+", "Compact_predicates.h"), 35),
    "collinear": (collinear, read(r"bound = (\d+) \* Filter_bounds::unit \* m \+", "exact_signs.h"), 5),
    "double_double_product": (double_double_product, lambda: OF_PRODUCT, Fraction(1, 2**101)),
    "double_double_sum": (double_double_sum, lambda: OF_PRODUCT, Fraction(1, 2**102)),
    "double_double_sphere": (double_double_sphere, lambda: 1 / DOUBLE_DOUBLES(), Fraction(1, 2**94)),
    "weighted_lengths_four": (weighted(lengths_four), factor("four", True), 79),
    "weighted_lengths_circle": (weighted(lengths_circle), factor("circle", True), 40),
    "weighted_columns_four": (weighted(columns_four), factor("columns", True), 402),
    "weighted_columns_circle": (weighted(columns_circle), BOX, 77),
    "weighted_double_double_sphere": (weighted(double_double_sphere), lambda: 1 / DOUBLE_DOUBLES(), Fraction(1, 2**94)),
    "balanced_doubles": (balanced_doubles, read(r"error = (\d+) \* Filter_bounds::unit;", "balanced_signs.h"), 18),
    "balanced_double_doubles": (balanced_double_doubles, read(r"error = (0x1p-\d+);", "balanced_signs.h"), Fraction(1, 2**96)),
    "underflow_lengths": (underflow_lengths, read(r"unit_of_double; static constexpr double tiny = (1e-\d+);", "Sphere_filter.h"), Fraction(1, 2**1064)),
    "underflow_columns": (underflow_columns, read(r"struct Column_sizes \{ static constexpr double tiny = (1e-\d+);", "Sphere_filter.h"), Fraction(1, 2**885)),
    "underflow_balanced": (underflow_balanced, read(r"d\.size \+ (0x1p-\d+)\)", "balanced_signs.h"), Fraction(1, 2**885)),
}


SLOW = {"underflow_lengths", "underflow_columns", "underflow_balanced"}  # minutes; the least was found once


def smaller(constant):
    """One step."""
    return constant - 1 if Fraction(constant).denominator == 1 else Fraction(constant) / 2


def text_of(name):
    make, constant, _ = SCRIPTS[name]
    return make(constant())


if __name__ == "__main__":
    for script in SCRIPTS:
        (Path(__file__).parent / f"{script}.g").write_text(text_of(script), encoding="utf-8")
