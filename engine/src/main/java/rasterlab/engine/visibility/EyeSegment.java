package rasterlab.engine.visibility;

/** A piece of a straight line by its ends in eye space (x right, y up, z forward). */
public record EyeSegment(double x0, double y0, double z0, double x1, double y1, double z1) {

    /** The segment between two vertices of the view's mesh. */
    public static EyeSegment between(ViewedMesh view, int from, int to) {
        return new EyeSegment(
                view.eyeX(from),
                view.eyeY(from),
                view.eyeZ(from),
                view.eyeX(to),
                view.eyeY(to),
                view.eyeZ(to));
    }
}
