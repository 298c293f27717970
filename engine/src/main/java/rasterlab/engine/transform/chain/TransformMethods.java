package rasterlab.engine.transform.chain;

import java.util.List;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class TransformMethods {
    private static final String COURSE =
            "Ponomarev, course text on computer graphics, homogeneous coordinates";

    private TransformMethods() {}

    static List<Method<PointTransformer>> all() {
        return List.of(
                new Method<>(
                        "divide-first-textbook",
                        new About(
                                "[X Y Z H] = [x y z 1] · M, then [X/H Y/H Z/H 1], matrix by matrix",
                                "none; H is 1 after every division, whatever it was",
                                "16 additions, 12 multiplications and 3 divisions per matrix and"
                                        + " point",
                                "H and its sign are gone, so that a point behind the eye passes for"
                                        + " one before it; divides by 0 at the eye",
                                COURSE),
                        new DivideFirstTransformer()),
                new Method<>(
                        "float",
                        new About(
                                "[X Y Z H] = [x y z 1] · M1·M2·…, x' = X/H, in 24 bits",
                                "proportional [X Y Z H] are one point",
                                "64 additions and 64 multiplications per matrix; 16 additions, 12"
                                        + " multiplications and 3 divisions per point",
                                "loses what cancels in a shift or in H; refuses what a float"
                                        + " cannot hold",
                                COURSE),
                        new FloatTransformer()),
                new Method<>(
                        "double",
                        new About(
                                "[X Y Z H] = [x y z 1] · M1·M2·…, x' = X/H, in 53 bits",
                                "proportional [X Y Z H] are one point",
                                "64 additions and 64 multiplications per matrix; 16 additions, 12"
                                        + " multiplications and 3 divisions per point",
                                "loses what cancels in a shift there and back or in H close to 0",
                                COURSE),
                        new DoubleTransformer()),
                new Method<>(
                        "double-double",
                        new About(
                                "[X Y Z H] = [x y z 1] · M1·M2·…, x' = X/H, in 106 bits",
                                "high is the double nearest to high + low",
                                "64 additions and 64 multiplications per matrix; 16 additions, 12"
                                        + " multiplications and 3 divisions per point; of numbers"
                                        + " that are two doubles, some 20 operations for each",
                                "none known while at most half of the digits cancel",
                                "T. J. Dekker, A floating-point technique for extending the"
                                        + " available precision, Numerische Mathematik 18, 1971"),
                        new DoubleDoubleTransformer()));
    }
}
