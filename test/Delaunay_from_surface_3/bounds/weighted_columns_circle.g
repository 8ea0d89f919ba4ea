#@ -Eprecision=128 -Eno-auto-dichotomy
# The error of a determinant, where the largest in each column (s, t, the sizes of w) is 1, is at most
# 80 u, and so is the bound as it is computed. Any roundings may be left out by fused operations.

@add = add_rel<53>;
@sub = sub_rel<53>;
@mul = mul_rel<53>;

bc_0 = sub(mul(bx, cy), mul(by, cx));
BC_0 = ((BX * CY) - (BY * CX));
ca_0 = sub(mul(cx, ay), mul(cy, ax));
CA_0 = ((CX * AY) - (CY * AX));
ab_0 = sub(mul(ax, by), mul(ay, bx));
AB_0 = ((AX * BY) - (AY * BX));
value_0 = add(add(mul(aw, bc_0), mul(bw, ca_0)), mul(cw, ab_0));
VALUE_0 = (((AW * BC_0) + (BW * CA_0)) + (CW * AB_0));
bound = add(mul(mul(5b-49, mul(1, 1)), 1), 0);

{ |ax| <= 1
  /\ |ax -/ AX| <= 1b-53
  /\ |ay| <= 1
  /\ |ay -/ AY| <= 1b-53
  /\ |aw| <= 1
  /\ |aw - AW| <= 97b-57
  /\ |bx| <= 1
  /\ |bx -/ BX| <= 1b-53
  /\ |by| <= 1
  /\ |by -/ BY| <= 1b-53
  /\ |bw| <= 1
  /\ |bw - BW| <= 97b-57
  /\ |cx| <= 1
  /\ |cx -/ CX| <= 1b-53
  /\ |cy| <= 1
  /\ |cy -/ CY| <= 1b-53
  /\ |cw| <= 1
  /\ |cw - CW| <= 97b-57
->
  |value_0 - VALUE_0| <= 5497558138875b-89
  /\ bound >= 5497558138875b-89 }
