package rasterlab.engine.visibility.order;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.engine.study.Deviation;

/**
 * Whether a painting is right, proved instead of compared: there are many right orders.
 *
 * <p>For each two pieces, the later one painted over the earlier: of the rays common to both those
 * are wrong on which the earlier is nearer. Both 1/t are linear in the ray, so that is an {@link
 * ExactCone} again, found without rounding; distances are those to the planes of the polygons as
 * given. The error is all that is wrongly covered, in percent of what the polygons cover. Two
 * pieces whose wrong part is below {@link #SLIVER} of the smaller are right: corners of cuts are
 * rounded.
 *
 * <p>Pieces must also cover their polygons, which {@link Coverage} tells; one that they do not
 * counts as missing.
 */
final class PaintingComparison {
    private static final double SLIVER = 1e-9;

    private final Sight sight;
    private final List<Seen> pieces = new ArrayList<>();
    private double wrong;
    private long pairs;
    private String first = "";

    /** A piece with what the proof needs of it. */
    private record Seen(int polygon, ExactCone cone, ExactPolygon plane, Ball ball, double size) {}

    private PaintingComparison(Sight sight) {
        this.sight = sight;
    }

    static Deviation compare(Sight sight, Painting actual) {
        return new PaintingComparison(sight).deviation(actual);
    }

    private Deviation deviation(Painting actual) {
        String unknown = load(actual);
        if (!unknown.isEmpty()) return new Deviation(100, 0, 1, sight.size(), unknown);
        for (int later = 1; later < pieces.size(); later++)
            for (int earlier = 0; earlier < later; earlier++)
                compare(pieces.get(earlier), pieces.get(later));
        var coverage = new Coverage(sight, actual);
        String uncovered = coverage.first();
        double percent = wrong == 0 ? 0 : 100 * wrong / covered();
        if (!uncovered.isEmpty()) percent = Math.max(percent, coverage.percent());
        return new Deviation(
                percent,
                coverage.missing(),
                pairs,
                sight.size(),
                first.isEmpty() ? uncovered : first);
    }

    private String load(Painting actual) {
        int bits = ExactPolygon.bits(sight.eye());
        for (double[] polygon : sight.polygons()) bits = Math.max(bits, ExactPolygon.bits(polygon));
        for (Painting.Piece piece : actual.pieces()) {
            if (piece.polygon() < 0 || piece.polygon() >= sight.size())
                return "there is no polygon " + piece.polygon();
            if (!isPlace(piece.corners()))
                return "%s are no corners of a piece of polygon %d"
                        .formatted(Arrays.toString(piece.corners()), piece.polygon());
            bits = Math.max(bits, ExactPolygon.bits(piece.corners()));
        }
        var planes = new ArrayList<ExactPolygon>();
        for (double[] polygon : sight.polygons())
            planes.add(new ExactPolygon(ExactPolygon.fromEye(polygon, sight.eye(), bits)));
        for (Painting.Piece piece : actual.pieces()) {
            ExactPolygon plane = planes.get(piece.polygon());
            var cone = new ExactCone(ExactPolygon.fromEye(piece.corners(), sight.eye(), bits));
            if (plane.edgeOn() || !cone.open()) continue;
            var ball = Ball.round(piece.corners(), sight.eye());
            pieces.add(new Seen(piece.polygon(), cone, plane, ball, cone.size()));
        }
        return "";
    }

    /** Whether it has x, y and z of each corner, all of them finite. */
    private static boolean isPlace(double[] corners) {
        return corners.length > 0
                && corners.length % 3 == 0
                && Arrays.stream(corners).allMatch(Double::isFinite);
    }

    private double covered() {
        return pieces.stream().mapToDouble(Seen::size).sum();
    }

    private void compare(Seen earlier, Seen later) {
        if (earlier.polygon == later.polygon) return;
        if (earlier.ball.farther(later.ball) || earlier.ball.apartFrom(later.ball)) return;
        ExactCone common = earlier.cone.in(later.cone);
        if (!common.open()) return;
        ExactCone nearer = common.where(earlier.plane.nearerThan(later.plane));
        // Rounded corners of a piece seen edge on may go round no cone: then the common one is not
        // in both, and what is wrong of it is still no more than either covers.
        double smaller = Math.min(earlier.size, later.size);
        double size = nearer.open() ? Math.min(nearer.size(), smaller) : 0;
        if (size <= SLIVER * smaller) return;
        wrong += size;
        pairs++;
        if (first.isEmpty())
            first =
                    "polygon %d is painted over polygon %d, which is nearer"
                            .formatted(later.polygon, earlier.polygon);
    }
}
