package rasterlab.engine.visibility.faces;

import java.util.List;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that tell which faces are turned towards the eye, in teaching order. */
final class VisibleFacesMethods {
    private static final String COURSE =
            "the course's text on hidden surfaces, invisible faces of convex bodies";

    private VisibleFacesMethods() {}

    static List<Method<VisibleFaces>> all() {
        return List.of(
                new Method<>(
                        "back-face",
                        new About(
                                "n·(eye − c₀) > 0, n = ½·Σ cᵢ × cᵢ₊₁",
                                "each face is judged by itself",
                                "one side of a plane per face, 12 multiplications for a triangle,"
                                        + " and decimal numbers where rounding could decide",
                                "none known; of a body that is not convex, faces that others hide"
                                        + " are kept",
                                "L. G. Roberts, Machine perception of three-dimensional solids,"
                                        + " 1963"),
                        new BackFace()),
                new Method<>(
                        "convex-segment-textbook",
                        new About(
                                "μ = (c − n·A) / (n·(B − A)), visible where 0 < μ < 1, and not"
                                        + " where n·(B − A) = 0",
                                "the segment from the eye A to the inner point B enters the body"
                                        + " through the planes of all faces seen from A",
                                "12 multiplications and a division per face",
                                "bodies that are not convex; B not inside; an eye in a face's"
                                        + " plane, by rounding; first three corners on one line;"
                                        + " products beyond 10³⁰⁸ or below 10⁻³⁰⁸",
                                COURSE),
                        new ConvexSegmentTextbook()),
                new Method<>(
                        "convex-segment",
                        new About(
                                "the eye A and the inner point B are on two sides of the plane",
                                "B is behind every face judged so far",
                                "two sides of a plane per face, that of B once per body if kept,"
                                        + " and decimal numbers where rounding could decide",
                                "none known; refuses an inner point that is not behind every face",
                                COURSE),
                        new ConvexSegment()));
    }
}
