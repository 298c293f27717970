package rasterlab.exercises.property;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.clip.segment.SegmentsInWindow;
import rasterlab.exercises.property.Relation.AnsweredInput;
import rasterlab.exercises.property.Relation.Broken;
import rasterlab.exercises.property.Relation.Equivalence;

/** Properties of clipping: what is inside is not changed by clipping it again. */
final class ClipProperties {
    /** The tolerance as a share of the window's area. */
    private static final double ROUNDING = 1e-9;

    static final List<Property<?, ?>> ALL =
            List.of(
                    Property.<SegmentsInWindow, ClippedEnds>always(
                            "clip-segment",
                            "idempotence",
                            Relation.followed(ClipProperties::again, ClipProperties::kept)),
                    new Property<PolygonInWindow, List<double[]>>(
                            "clip-polygon",
                            "idempotence",
                            input -> isConvex(input.subject()),
                            new PiecesAgain()));

    private ClipProperties() {}

    private static List<double[]> parts(ClippedEnds clipped) {
        return clipped.parts().stream().flatMap(Optional::stream).toList();
    }

    private static SegmentsInWindow again(SegmentsInWindow input, ClippedEnds clipped) {
        return new SegmentsInWindow(input.window(), parts(clipped));
    }

    private static ClippedEnds kept(SegmentsInWindow input, ClippedEnds clipped) {
        return new ClippedEnds(parts(clipped).stream().map(Optional::of).toList(), 0);
    }

    /** Whether all corners turn to the same side, once round. */
    private static boolean isConvex(double[] corners) {
        int count = corners.length / 2;
        int side = 0;
        int flips = 0;
        for (int i = 0; i < count; i++) {
            double turn = turn(corners, i, (i + 1) % count, (i + 2) % count);
            if (turn == 0 || side * turn < 0) return false;
            side = turn > 0 ? 1 : -1;
            boolean right = corners[2 * ((i + 1) % count)] > corners[2 * i];
            boolean rightNext = corners[2 * ((i + 2) % count)] > corners[2 * ((i + 1) % count)];
            if (right != rightNext) flips++;
        }
        return count > 2 && flips <= 2;
    }

    private static double turn(double[] corners, int a, int b, int c) {
        double x = corners[2 * b] - corners[2 * a];
        double y = corners[2 * b + 1] - corners[2 * a + 1];
        return x * (corners[2 * c + 1] - corners[2 * b + 1])
                - y * (corners[2 * c] - corners[2 * b]);
    }

    /** The signed area, above 0 where the corners go round counter-clockwise. */
    private static double area(double[] corners) {
        double doubled = 0;
        for (int i = 1; 2 * i + 2 < corners.length; i++) doubled += turn(corners, 0, i, i + 1);
        return doubled / 2;
    }

    /**
     * The relation that each piece that is left is left whole. Areas are compared: rounding puts
     * corners next to the window's sides, where a right method may cut them off once more.
     */
    private static final class PiecesAgain implements Relation<PolygonInWindow, List<double[]>> {
        @Override
        public List<PolygonInWindow> furtherInputs(PolygonInWindow input, List<double[]> pieces) {
            List<PolygonInWindow> again = new ArrayList<>();
            for (double[] piece : pieces) again.add(new PolygonInWindow(input.window(), piece));
            return again;
        }

        @Override
        public Optional<Broken<PolygonInWindow, List<double[]>>> broken(
                AnsweredInput<PolygonInWindow, List<double[]>> first,
                List<AnsweredInput<PolygonInWindow, List<double[]>>> again,
                Equivalence<PolygonInWindow, List<double[]>> alike) {
            for (AnsweredInput<PolygonInWindow, List<double[]>> one : again) {
                double[] piece = one.input().subject();
                double left = one.output().stream().mapToDouble(ClipProperties::area).sum();
                double least = ROUNDING * Math.abs(area(one.input().window()));
                if (!(Math.abs(Math.abs(left) - Math.abs(area(piece))) <= least))
                    return Optional.of(new Broken<>(one, List.of(piece)));
            }
            return Optional.empty();
        }
    }
}
