#@ -Eprecision=256 -Eno-auto-dichotomy
# A sum of two numbers whose sizes sum up to 1.
# Size is what the absolute values of the products in a number sum up to. That the sum of `normalized` is exact
# is not needed.

@add = add_rel<53>;
@sub = sub_rel<53>;
@mul = mul_rel<53>;

p = add(sh, th);
e = (sh + th) - p; # exactly: Knuth (1969)
l = add(e, add(sl, tl));
h = add(p, l);
t = sub(h, p);
low = sub(l, t);
exact = (sh + th) + (sl + tl);

{ |(sh + th) + (sl + tl)| <= 1237940039285380274899124225b-90
  /\ |sl + tl| <= 1b-52
->
  |(h + low) - exact| <= 1b-100
  /\ |low| <= 1b-52 }
h - p -> l + (h - (p + l));
l - t -> -(h - (p + l)) - (t - (h - p));
(h + low) - exact -> ((low - (l - t)) - (t - (h - p))) + (l - (e + (sl + tl)));
sh + th -> exact - (sl + tl);
