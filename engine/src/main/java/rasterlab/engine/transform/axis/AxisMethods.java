package rasterlab.engine.transform.axis;

import java.util.List;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods of the topic, in teaching order. */
final class AxisMethods {
    private AxisMethods() {}

    static List<Method<AxisRotation>> all() {
        return List.of(textbook(), sevenSteps(), rodrigues(), quaternion());
    }

    private static Method<AxisRotation> textbook() {
        return new Method<>(
                "seven-steps-textbook",
                new About(
                        "T · R_z(θ) · R_y(φ) · R_z(α) · R_y(−φ) · R_z(−θ) · T⁻¹, cos φ = d, sin φ"
                                + " = n; the text prints sin θ = l/d, cos θ = m/d beside matrices"
                                + " with cos θ = l/d, sin θ = m/d, which are taken",
                        "none; after step 3 the axis is not on z, about which step 4 turns",
                        "16 additions and 20 multiplications per point",
                        "moves the axis itself; divides 0 by 0 for an axis along z",
                        "Ponomarev, course text on computer graphics, rotation about a line"),
                new SevenStepsTextbook());
    }

    private static Method<AxisRotation> sevenSteps() {
        return new Method<>(
                "seven-steps",
                new About(
                        "T · R_z(−θ) · R_y(−φ) · R_z(α) · R_y(φ) · R_z(θ) · T⁻¹, cos θ = l/d,"
                                + " sin θ = m/d, cos φ = n, sin φ = d; θ = 0 where d = 0",
                        "after step 3 the axis is the z axis",
                        "16 additions and 20 multiplications per point",
                        "none known",
                        "D. F. Rogers, J. A. Adams, Mathematical Elements for Computer Graphics,"
                                + " 1976"),
                new SevenSteps());
    }

    private static Method<AxisRotation> rodrigues() {
        return new Method<>(
                "rodrigues",
                new About(
                        "p' = A + v·cos α + (k × v)·sin α + k·(k·v)·(1 − cos α), v = p − A",
                        "what lies along k stays, what lies across it turns by α",
                        "17 additions and 19 multiplications per point",
                        "none known",
                        "O. Rodrigues, Journal de mathématiques pures et appliquées 5, 1840"),
                new RodriguesRotation());
    }

    private static Method<AxisRotation> quaternion() {
        return new Method<>(
                "quaternion",
                new About(
                        "p' = A + v + w·t + u × t, t = 2·(u × v), (w, u) = (cos α/2, k·sin α/2)",
                        "w² + u·u = 1",
                        "18 additions and 18 multiplications per point",
                        "none known",
                        "K. Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985"),
                new QuaternionRotation());
    }
}
