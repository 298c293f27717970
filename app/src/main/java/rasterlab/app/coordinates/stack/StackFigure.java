package rasterlab.app.coordinates.stack;

import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix4d;
import rasterlab.app.coordinates.figure.Chains;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.MarkInk;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.coordinates.figure.Viewpoint;
import rasterlab.app.coordinates.figure.Wireframe;
import rasterlab.engine.transform.MatrixMode;
import rasterlab.engine.transform.matrix.MatrixCall;

/** The cubes that a program drew, and the frame in which the next one would be. */
final class StackFigure {
    private static final Wireframe CUBE = Wireframe.cube();
    private static final String[] AXES = {"x", "y", "z"};
    private static final String[] MOVED = {"x′", "y′", "z′"};
    private static final double FIXED = 3;
    private static final double CURRENT = 1.6;

    private final Viewpoint viewpoint;
    private final List<Mark> marks = new ArrayList<>();

    private StackFigure(Viewpoint viewpoint) {
        this.viewpoint = viewpoint;
    }

    static Figure of(StackScene scene, Viewpoint viewpoint) {
        var figure = new StackFigure(viewpoint);
        figure.axes(new Matrix4d(), FIXED, AXES, true);
        List<Matrix4d> below = scene.stacks().get(MatrixMode.MODELVIEW);
        for (int i = 1; i < below.size(); i++)
            figure.axes(below.get(i), CURRENT, new String[] {"", "", ""}, true);
        int newest = scene.cubes().size() - 1;
        for (int i = 0; i <= newest; i++) figure.cube(scene.cubes().get(i));
        figure.axes(below.get(0), CURRENT, MOVED, false);
        return new Figure(figure.marks, false);
    }

    private List<StagePoint> places(Matrix4d matrix, double[] points) {
        double[] moved =
                Chains.images(3, List.of(Chains.cells(matrix)), points).images().coordinates();
        var spots = new ArrayList<StagePoint>();
        for (int i = 0; i < moved.length; i += 3) {
            double[] one = {moved[i], moved[i + 1], moved[i + 2]};
            boolean image =
                    Double.isFinite(one[0]) && Double.isFinite(one[1]) && Double.isFinite(one[2]);
            spots.add(
                    image
                            ? viewpoint.places(List.of(MatrixCall.of("ROT3DX", -90)), one).get(0)
                            : new StagePoint(Double.NaN, Double.NaN));
        }
        return spots;
    }

    private void axes(Matrix4d frame, double length, String[] names, boolean help) {
        List<StagePoint> ends =
                places(frame, new double[] {0, 0, 0, length, 0, 0, 0, length, 0, 0, 0, length});
        for (int axis = 0; axis < 3; axis++)
            marks.add(
                    new Mark.ArrowMark(
                            ends.get(0),
                            ends.get(axis + 1),
                            help ? MarkInk.HELP : MarkInk.axis(axis),
                            names[axis]));
    }

    private void cube(Matrix4d frame) {
        List<StagePoint> places = places(frame, CUBE.numbers());
        for (Wireframe.Edge edge : CUBE.edges())
            marks.add(
                    new Mark.LineMark(
                            places.get(edge.from()), places.get(edge.to()), MarkInk.OBJECT));
    }
}
