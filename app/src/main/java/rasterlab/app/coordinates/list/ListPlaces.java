package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.MarkInk;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.coordinates.figure.Viewpoint;
import rasterlab.engine.transform.Coordinates;
import rasterlab.engine.transform.matrix.MatrixCall;

/** Where points of the list's plane or space lie on the stage. */
final class ListPlaces {
    private static final String[] AXES = {"x", "y", "z"};

    /** A viewpoint's turns make a coordinate at most so many times as large. */
    private static final double TURNS = 4;

    private final int dimension;
    private final Viewpoint viewpoint;

    ListPlaces(ListChoice choice) {
        dimension = choice.dimension();
        viewpoint = choice.viewpoint();
    }

    /** One place each; it is not finite where the point has no image, or is too far to be seen. */
    List<StagePoint> of(double[] points) {
        var spots = new ArrayList<StagePoint>();
        for (int at = 0; at < points.length; at += dimension) {
            var one = Arrays.copyOfRange(points, at, at + dimension);
            boolean image =
                    Arrays.stream(one).allMatch(x -> Math.abs(x) <= Coordinates.LARGEST / TURNS);
            spots.add(image ? place(one) : new StagePoint(Double.NaN, Double.NaN));
        }
        return spots;
    }

    private StagePoint place(double[] point) {
        List<StagePoint> spots =
                dimension == 2
                        ? Viewpoint.spots(point, 2)
                        : viewpoint.places(List.of(MatrixCall.of("ROT3DX", -90)), point);
        return spots.get(0);
    }

    /**
     * The axes of space, which stay.
     *
     * @param reach how long they are
     */
    List<Mark> axes(double reach) {
        var marks = new ArrayList<Mark>();
        for (int axis = 0; axis < 3; axis++) {
            var ends = new double[6];
            ends[3 + axis] = reach;
            List<StagePoint> spots = of(ends);
            marks.add(new Mark.ArrowMark(spots.get(0), spots.get(1), MarkInk.HELP, AXES[axis]));
        }
        return marks;
    }
}
