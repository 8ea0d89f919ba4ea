#@ -Eprecision=128 -Eno-auto-dichotomy
# Two squared lengths as computed sum up to 1; exactly they are v / (1 + dv) and w / (1 + dw). The difference has one
# rounding.

@add = add_rel<53>;
@sub = sub_rel<53>;
@mul = mul_rel<53>;

w = 1 - v;
error = v * (1 - 1 / (1 + dv)) - w * (1 - 1 / (1 + dw)) + (v - w) * d;
bound = add(mul(1b-50, add(1, 0)), 0);

{ |dv| <= 81b-57
  /\ |dw| <= 81b-57
  /\ |d| <= 1b-53
  /\ v in [0,1]
->
  |error| <= 1099511627775b-90
  /\ bound >= 1099511627775b-90 }
$ v in 64;
