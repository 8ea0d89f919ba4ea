# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The formulas and constants of the filters, read from the headers, and what is made of them here: counts of
roundings, and scripts for Gappa. The formulas are C++ that is Python as well, but for a few signs."""

import re
from fractions import Fraction
from pathlib import Path

KERNEL = Path(__file__).resolve().parents[3] / "include/CGAL/Delaunay_from_surface_3/core/kernel"
U = Fraction(1, 2**53)


def found(pattern, header):
    """The groups of the one place where a header has this."""
    text = re.sub(r"\s+", " ", (KERNEL / header).read_text(encoding="utf-8"))
    places = re.findall(pattern, text)
    if len(places) != 1:
        raise AssertionError(f"{header} has {len(places)} times: {pattern}")
    return places[0]


def number(text):
    """A constant as C++ has it, exactly."""
    if text.startswith("0x"):
        return Fraction(float.fromhex(text))
    return Fraction(text.rstrip("."))


def evaluated(text, **names):
    text = re.sub(r"\.\*(\w)", r".\1", text)  # r[0].*s
    return eval(text.replace("carried", ""), {"__builtins__": {}}, names)  # pylint: disable=eval-used


class Row:
    """Row<Number> of Sphere_filter.h, with a difference of weights if one is given; its w may be something else
    (balanced_signs.h)."""

    def __init__(self, x, y, z, w=None, dw=None):
        self.x, self.y, self.z = self.s, self.t, _ = x, y, z
        self.w = w if w is not None else self.lifted(x, y, z, dw)

    @staticmethod
    def lifted(x, y, z, dw):
        square = evaluated(found(r"w\(carried\((dx[^()]*)\)\) \{", "Sphere_filter.h"), dx=x, dy=y, dz=z)
        if dw is None:
            return square
        found(r"(w\(carried\(\(dx \* dx \+ dy \* dy \+ dz \* dz\) \+ dw\)\) \{)", "Sphere_filter.h")
        found(r"(Row<double>\(dx, dy, dz\) , square\(w\) , size\(w \+ std::abs\(dw\)\) \{ w \+= dw; \})", "Sphere_filter.h")
        return square + dw  # and the size as well, where dw is not negative


def minor_of(a, b):
    return evaluated(found(r"minor_of\(const Row<Number>& a, const Row<Number>& b\) \{ return (.*?); \}",
                           "Sphere_filter.h"), a=a, b=b)


def determinant_of(a, b, c):
    return evaluated(found(r"determinant_of\([^)]*\) \{ return (.*?); \}", "Sphere_filter.h"),
                     a=a, b=b, c=c, minor_of=minor_of)


def sphere_cofactors(a, b, c, d):
    names = {"a": a, "b": b, "c": c, "d": d}
    minors = found(r"const auto (ab = minor_of.*?);", "Sphere_filter.h")
    for name, first, second in re.findall(r"(\w\w) = minor_of\((\w), (\w)\)", minors):
        names[name] = minor_of(names[first], names[second]).named(name)
    return [evaluated(found(rf"of\[{k}\] = (carried\([abcd]\.z .*?\));", "Sphere_filter.h"), **names).named(f"of{k}")
            for k in range(4)]


def lifted(of, a, b, c, d):
    """The determinant of four rows."""
    return evaluated(found(r"lifted\(const Row<Number>& a.*?return (.*?); \}", "Sphere_filter.h"),
                     a=a, b=b, c=c, d=d, of=of)


def circle_cofactors(r):
    names = {name: evaluated(found(rf"const auto {name} = (r\[.*?);", "Sphere_filter.h"), r=r).named(name)
             for name in ("bc", "ca", "ab")}
    area = evaluated(found(r"area = (carried\(.*?\));", "Sphere_filter.h"), **names)
    return list(names.values()), area


def lifted_circle(of, r):
    return evaluated(found(r"lifted\(const Row<Number>\* r\) const \{ return (.*?); \}", "Sphere_filter.h"), r=r, of=of)


class Wide:
    """Lane 0 of the vectors of Sphere_filter.h: its own row, and the three others."""

    class Column:
        def __init__(self, v, a, b, c):
            self.v, self.a, self.b, self.c = v, a, b, c

    class Minors:
        def __init__(self, r, s, name):
            self.minors = {k: evaluated(found(rf"{k}\((r\.. \* s\.. - s\.. \* r\..)\)", "Sphere_filter.h"),
                                        r=r, s=s).named(name + k) for k in ("bc", "ca", "ab")}

        def times(self, t):
            return evaluated(found(r"times\(const Wide_column& t\) const \{ return (.*?); \}", "Sphere_filter.h"),
                             t=t, **self.minors)

    @staticmethod
    def w(x, y, z, dw=None):
        square = evaluated(found(r" w = square = size = (x \* x .*?);", "Sphere_filter.h"), x=x, y=y, z=z)
        if dw is None:
            return square
        found(r"(w = square \+ dw; size = square \+ max_of\(dw, -dw\);)", "Sphere_filter.h")
        return square + dw

    @classmethod
    def columns(cls, rows):
        return [cls.Column(*(getattr(row, k) for row in rows)) for k in "xyzw"]

    @classmethod
    def sphere(cls, e, rows):
        """The sphere test of the neighbor whose vertex e is, and of three vertices of the cell."""
        x, y, z, w = cls.columns([None_row, *rows])
        return evaluated(found(r"const Four_doubles value = (\(e\.x.*?);", "Sphere_filter.h"),
                         e=e, x=x, y=y, z=z, w=w, xy=cls.Minors(x, y, "xy_"), zw=cls.Minors(z, w, "zw_"))

    @classmethod
    def view(cls, rows):
        """That of the cell itself."""
        value = []
        for i in range(4):
            x, y, z, _ = cls.columns([rows[i], rows[i ^ 1], rows[i ^ 2], rows[i ^ 3]])
            found(r"(const Four_doubles facets = Wide_minors\(x, y\)\.times\(z\);)", "Sphere_filter.h")
            facets = cls.Minors(x, y, f"xy{i}_").times(z).named(f"facet{i}")
            value.append(evaluated(found(r"store_four\(value, (facets \* rows\.w)\);", "Sphere_filter.h"),
                                   facets=facets, rows=rows[i]).named(f"value{i}"))
        text = found(r"const double m = [^;]*; view\.sphere = certified_sign\((.*?), Filter", "Sphere_filter.h")
        return evaluated(text, value=value)


def balanced_w(row, f, dw):
    """That of a balanced row, of the sums f of two differences and a scaled difference of weights."""
    found(r"(return difference\(a, o, scale\) \+ difference\(b, o, scale\);)", "balanced_signs.h")
    found(r"(last = last \+ difference\(b\.weight\(\), a\.weight\(\), scales\.rows\[k\] \* scales\.w\);)", "balanced_signs.h")

    def of_sums(pattern, **names):
        text = re.sub(r"sum\(a\[(\d)\], b\[\1\], o\[\1\], scales\.w\)", r"f[\1]", found(pattern, "balanced_signs.h"))
        return evaluated(text.replace("r[k]", "r"), r=row, f=f, **names)
    last = of_sums(r"Bounded last = (r\[k\]\.z \* sum.*?);") + dw
    return of_sums(r"r\[k\]\.w = (r\[k\]\.x \* sum.*?);", last=last)


class None_row:
    x = y = z = w = None


class Products:
    """A sum of products, and through how many roundings each went. A sum or product of them has one more."""

    def __init__(self, roundings):
        self.roundings = roundings  # by the names of the factors, sorted

    @classmethod
    def leaf(cls, name, roundings):
        return cls({(name,): roundings})

    def __add__(self, other):
        if set(self.roundings) & set(other.roundings):
            raise AssertionError("the same product twice")
        return Products({name: n + 1 for name, n in {**self.roundings, **other.roundings}.items()})

    __sub__ = __add__

    def __mul__(self, other):
        return Products({tuple(sorted(a + b)): m + n + 1 for a, m in self.roundings.items()
                         for b, n in other.roundings.items()})

    def named(self, _):
        return self

    def most(self):
        return max(self.roundings.values())


class Definitions:
    """The lines of a script; what they name gets a suffix."""

    def __init__(self, *lines):
        self.lines, self.suffix = list(lines), ""


class Computed:
    """A number as it is computed, beside what it stands for. Each operation is some number with a relative error of
    at most 2^-53: 0 is allowed, so that a product that is fused into a sum is among them."""

    def __init__(self, script, text, exact):
        self.script, self.text, self.exact = script, text, exact

    def operation(self, name, sign, other):
        return Computed(self.script, f"{name}({self.text}, {other.text})", f"({self.exact} {sign} {other.exact})")

    def __add__(self, other):
        return self.operation("add", "+", other)

    def __sub__(self, other):
        return self.operation("sub", "-", other)

    def __mul__(self, other):
        return self.operation("mul", "*", other)

    def named(self, name):
        name += self.script.suffix
        self.script.lines += [f"{name} = {self.text};", f"{name.upper()} = {self.exact};"]
        return Computed(self.script, name, name.upper())


class Underflowing:
    """A number where products may underflow, `text`, beside the same with no underflow, `other`: each operation has
    the same relative error in both, and a product in the first one an absolute error, too."""

    def __init__(self, script, text, other):
        self.script, self.text, self.other = script, text, other

    def operation(self, sign, other, may_underflow):
        n = self.script.count()
        t, o, d = f"t{n}", f"o{n}", f"d{n}"
        self.script.lines += [f"{o} = ({self.other} {sign} {other.other}) * (1 + {d});"]
        self.script.given += [f"|{d}| <= 1b-53"]
        error = f"e{n}" if may_underflow else "0"
        if may_underflow:
            self.script.given += [f"|{error}| <= 1b-1075"]
        self.script.lines += [f"{t} = ({self.text} {sign} {other.text}) * (1 + {d}) + {error};"]
        x, y = f"({self.text} - {self.other})", f"({other.text} - {other.other})"
        change = f"{x} * {other.text} + {self.other} * {y}" if sign == "*" else f"{x} {sign} {y}"
        self.script.hints += [f"{t} - {o} -> ({change}) * (1 + {d}) + {error};"]
        return Underflowing(self.script, t, o)

    def __add__(self, other):
        return self.operation("+", other, False)

    def __sub__(self, other):
        return self.operation("-", other, False)

    def __mul__(self, other):
        return self.operation("*", other, True)

    def named(self, _):
        return self
