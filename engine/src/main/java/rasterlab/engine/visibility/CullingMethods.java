package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** Methods that look at each face by itself. */
final class CullingMethods {
    private static final String SUTHERLAND =
            "I. E. Sutherland, R. F. Sproull, R. A. Schumacker, A characterization of ten"
                    + " hidden-surface algorithms, ACM Computing Surveys, 1974";

    private CullingMethods() {}

    static List<Method<Visibility>> all() {
        return List.of(
                new Method<>(
                        "none",
                        new About(
                                "the last face drawn wins",
                                "none; nothing is hidden but by chance",
                                "every pixel of every face is written",
                                "everything but a scene whose faces happen to be listed back to"
                                        + " front",
                                SUTHERLAND),
                        new MeshOrder()),
                new Method<>(
                        "back-face",
                        new About(
                                "a face is drawn if n·p ≤ 0, p being a point of it seen from the"
                                        + " eye",
                                "no face is drawn that turns its inner side to the eye",
                                "one test per face, about half of all pixels are written",
                                "all but one convex body; open ones, hollows, bodies before bodies",
                                SUTHERLAND),
                        new BackFaceCulling()),
                new Method<>(
                        "convex",
                        new About(
                                "a face is seen if n·p ≤ 0, p being a point of it seen from the"
                                        + " eye",
                                "no two faces drawn so far overlap on the picture",
                                "one test per face, each pixel is written once; N·V tests that the"
                                        + " body is convex",
                                "none known; refuses what is not one convex closed body",
                                SUTHERLAND),
                        new ConvexFaces()));
    }
}
