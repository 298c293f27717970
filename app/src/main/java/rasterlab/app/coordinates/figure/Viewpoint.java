package rasterlab.app.coordinates.figure;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.range.Finite;
import rasterlab.engine.transform.matrix.MatrixCall;

/**
 * The direction from which space is looked at on the stage: a trimetric picture.
 *
 * @param alphaDegrees α about y, any finite angle
 * @param betaDegrees β about x, in [−90, 90]
 */
public record Viewpoint(double alphaDegrees, double betaDegrees) {
    public static final Viewpoint FIRST = new Viewpoint(-32, 20);

    public Viewpoint {
        Finite.require("alphaDegrees", alphaDegrees);
        Bounds.require("betaDegrees", betaDegrees, -90, 90);
    }

    /** The viewpoint turned further; β stops at its ends. */
    public Viewpoint turned(double alpha, double beta) {
        return new Viewpoint(
                Math.IEEEremainder(alphaDegrees + alpha, 360),
                Math.max(-90, Math.min(90, betaDegrees + beta)));
    }

    /**
     * The places of points of space on the stage.
     *
     * @param upright brings the space's frame to x right, y up, z towards the viewer
     * @param points three numbers each
     */
    public List<StagePoint> places(List<MatrixCall> upright, double[] points) {
        var calls = new ArrayList<>(upright);
        calls.add(MatrixCall.of("TRIMETRIC", alphaDegrees, betaDegrees));
        return spots(Chains.images(3, Chains.cells(calls), points).images().coordinates(), 3);
    }

    /** The first two numbers of each point. */
    public static List<StagePoint> spots(double[] coordinates, int dimension) {
        var spots = new ArrayList<StagePoint>();
        for (int i = 0; i < coordinates.length; i += dimension)
            spots.add(new StagePoint(coordinates[i], coordinates[i + 1]));
        return spots;
    }
}
