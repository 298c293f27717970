package rasterlab.app.opengl.software;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.GlShape;
import rasterlab.app.opengl.state.Setting;

/** Vertices of a shape lit and put together to primitives, as OpenGL does it. */
final class ShapeAssembly {
    private final GlFrame frame;
    private final GlChoice choice;
    private final Matrix4d projection;
    private final Optional<VertexLight> light;
    private final boolean flat;

    /** Front and back of each vertex, {@link TriangleCorners#NUMBERS} numbers each. */
    private double[][] fronts;

    private double[][] backs;

    ShapeAssembly(GlFrame frame) {
        this.frame = frame;
        choice = frame.choice();
        projection = frame.projection();
        light = frame.lit() ? Optional.of(new VertexLight(frame)) : Optional.empty();
        flat = choice.is(Setting.SHADE_MODEL, "GL_FLAT");
    }

    /**
     * @param toEye turns and moves
     * @param alpha of the vertices' own colours
     */
    TriangleCorners assemble(GlShape shape, Matrix4d toEye, double alpha) {
        fronts = new double[shape.vertexCount()][];
        backs = new double[shape.vertexCount()][];
        for (int v = 0; v < shape.vertexCount(); v++) {
            double[] eye = eye(shape, v, toEye);
            fronts[v] = corner(shape, v, eye, false, alpha);
            backs[v] = corner(shape, v, eye, true, alpha);
        }
        var corners = new TriangleCorners();
        var strokes = new Strokes(projection, frame.width(), frame.height(), corners);
        int[] at = shape.indices();
        if (shape.lines())
            for (int i = 0; i < at.length; i += 2)
                strokes.line(colored(fronts[at[i]], fronts[at[i + 1]]), fronts[at[i + 1]]);
        else
            for (int i = 0; i < at.length; i += 3)
                triangle(at[i], at[i + 1], at[i + 2], corners, strokes);
        return corners;
    }

    private static double[] eye(GlShape shape, int v, Matrix4d toEye) {
        float[] xyz = shape.xyz();
        float[] n = shape.normals();
        var place =
                toEye.transformPosition(new Vector3d(xyz[3 * v], xyz[3 * v + 1], xyz[3 * v + 2]));
        var normal = toEye.transformDirection(new Vector3d(n[3 * v], n[3 * v + 1], n[3 * v + 2]));
        return new double[] {place.x, place.y, place.z, normal.x, normal.y, normal.z};
    }

    private double[] corner(GlShape shape, int v, double[] eye, boolean behind, double alpha) {
        float[] rgb = shape.rgb();
        float[] rgba = {rgb[3 * v], rgb[3 * v + 1], rgb[3 * v + 2], (float) alpha};
        if (shape.lit() && light.isPresent()) light.get().shade(eye, behind, rgba);
        return new double[] {
            eye[0],
            eye[1],
            eye[2],
            rgba[0],
            rgba[1],
            rgba[2],
            rgba[3],
            shape.st()[2 * v],
            shape.st()[2 * v + 1]
        };
    }

    private void triangle(int a, int b, int c, TriangleCorners corners, Strokes strokes) {
        boolean counterClockwise = area(fronts[a], fronts[b], fronts[c]) > 0;
        boolean front = counterClockwise == choice.is(Setting.FRONT_FACE, "GL_CCW");
        if (culled(front)) return;
        double[][] side = front ? fronts : backs;
        double[] last = side[c];
        double[] first = colored(side[a], last);
        double[] second = colored(side[b], last);
        switch (choice.get(Setting.POLYGON_MODE)) {
            case "GL_LINE" -> {
                strokes.line(first, second);
                strokes.line(second, last);
                strokes.line(last, first);
            }
            case "GL_POINT" -> {
                strokes.point(first);
                strokes.point(second);
                strokes.point(last);
            }
            default -> {
                corners.add(first);
                corners.add(second);
                corners.add(last);
            }
        }
    }

    private boolean culled(boolean front) {
        return switch (choice.get(Setting.CULL_FACE)) {
            case "GL_FRONT" -> front;
            case "GL_BACK" -> !front;
            case "GL_FRONT_AND_BACK" -> true;
            default -> false;
        };
    }

    /** A corner as the shade model has it: flat, it has the colour of the last one. */
    private double[] colored(double[] corner, double[] last) {
        if (!flat) return corner;
        double[] other = corner.clone();
        System.arraycopy(last, 3, other, 3, 4);
        return other;
    }

    /** The signed area, positive where the corners run counter-clockwise on the picture. */
    private double area(double[] a, double[] b, double[] c) {
        double ax = projection.m00() * a[0];
        double ay = projection.m11() * a[1];
        double bx = projection.m00() * b[0];
        double by = projection.m11() * b[1];
        double cx = projection.m00() * c[0];
        double cy = projection.m11() * c[1];
        double aw = w(a);
        double bw = w(b);
        double cw = w(c);
        return ax * (by * cw - cy * bw) - ay * (bx * cw - cx * bw) + aw * (bx * cy - cx * by);
    }

    private double w(double[] corner) {
        return projection.m23() * corner[2] + projection.m33();
    }
}
