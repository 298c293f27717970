package rasterlab.engine.light.normals;

import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Surfaces whose normals depend on the method more than on the surface. */
final class NormalsHazards {
    private static final double[] CUBE = {
        0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, //
        0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1
    };

    private NormalsHazards() {}

    static List<Hazard<TriangleSurface>> all() {
        return Stream.of(solids(), degenerate()).flatMap(List::stream).toList();
    }

    private static List<Hazard<TriangleSurface>> solids() {
        return List.of(
                hazard(
                        "flat",
                        new TriangleSurface(
                                new double[] {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0},
                                new int[] {0, 1, 2, 0, 2, 3}),
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "to-the-outside",
                        new TriangleSurface(
                                new double[] {0, 0, 0, 0, 2, 0, 3, 0, 1}, new int[] {0, 1, 2}),
                        EXACT,
                        EXACT,
                        EXACT),
                hazard("cube-cut-one-way", new TriangleSurface(CUBE, cube()), WRONG, WRONG, WRONG),
                hazard(
                        "roof-with-a-long-side",
                        new TriangleSurface(
                                new double[] {
                                    0, 0, 1, 0, 1, 1, 10, 0, -9, 10, 1, -9, -1, 0, 0, -1, 1, 0
                                },
                                new int[] {0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4}),
                        WRONG,
                        EXACT,
                        WRONG));
    }

    private static List<Hazard<TriangleSurface>> degenerate() {
        return List.of(
                hazard(
                        "zero-area-face",
                        new TriangleSurface(
                                new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0},
                                new int[] {0, 1, 2, 0, 1, 3}),
                        WRONG,
                        EXACT,
                        EXACT),
                hazard(
                        "both-sides-of-a-sheet",
                        new TriangleSurface(
                                new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0},
                                new int[] {0, 1, 2, 0, 2, 1}),
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "vertex-without-a-face",
                        new TriangleSurface(
                                new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5},
                                new int[] {0, 1, 2}),
                        WRONG,
                        EXACT,
                        EXACT),
                hazard(
                        "tiny-faces",
                        new TriangleSurface(
                                new double[] {0, 0, 0, 1e-100, 0, 0, 0, 1e-100, 0},
                                new int[] {0, 1, 2}),
                        WRONG,
                        EXACT,
                        EXACT),
                hazard(
                        "smallest-face",
                        new TriangleSurface(
                                new double[] {0, 0, 0, 1e-200, 0, 0, 0, 1e-200, 0},
                                new int[] {0, 1, 2}),
                        WRONG,
                        WRONG,
                        WRONG));
    }

    /** Every face cut from its corner with the lowest number. */
    private static int[] cube() {
        return new int[] {
            0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, //
            2, 3, 7, 2, 7, 6, 0, 4, 7, 0, 7, 3, 1, 2, 6, 1, 6, 5
        };
    }

    private static Hazard<TriangleSurface> hazard(
            String name,
            TriangleSurface surface,
            Verdict.Kind textbook,
            Verdict.Kind plain,
            Verdict.Kind area) {
        return new Hazard<>(
                name,
                surface,
                Map.of("plain-textbook", textbook, "plain", plain, "area", area, "angle", EXACT));
    }
}
