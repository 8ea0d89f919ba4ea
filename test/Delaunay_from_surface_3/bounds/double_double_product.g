#@ -Eprecision=256 -Eno-auto-dichotomy
# A product of two numbers of size 1.
# Size is what the absolute values of the products in a number sum up to. That the sum of `normalized` is exact
# is not needed.

@add = add_rel<53>;
@sub = sub_rel<53>;
@mul = mul_rel<53>;

p = mul(sh, th);
e = sh * th - p; # exactly: Dekker (1971), or fma
l = add(e, add(mul(sh, tl), mul(sl, th)));
h = add(p, l);
t = sub(h, p);
low = sub(l, t);
exact = (sh + sl) * (th + tl);

{ |sh + sl| <= 1237940039285380274899124225b-90
  /\ |sl| <= 1b-52
  /\ |th + tl| <= 1237940039285380274899124225b-90
  /\ |tl| <= 1b-52
->
  |(h + low) - exact| <= 1b-100
  /\ |low| <= 1b-52 }
h - p -> l + (h - (p + l));
l - t -> -(h - (p + l)) - (t - (h - p));
(h + low) - exact -> ((low - (l - t)) - (t - (h - p))) + (l - (e + (sh * tl + sl * th))) - sl * tl;
sh -> (sh + sl) - sl;
th -> (th + tl) - tl;
