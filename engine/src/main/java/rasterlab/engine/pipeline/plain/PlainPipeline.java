package rasterlab.engine.pipeline.plain;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector4d;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.PixelPoint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityWork;

/**
 * Draws a mesh as a graphics card does, one triangle after the other. Read it from top to bottom.
 *
 * <p>Source: J. Pineda, A parallel algorithm for polygon rasterization, SIGGRAPH 1988, pp. 17–20.
 */
public final class PlainPipeline {
    /** Planes (a, b, c, d) with a·x + b·y + c·z + d·w ≥ 0 inside: −w ≤ x, y, z ≤ w. */
    private static final List<Vector4d> CLIP_PLANES =
            List.of(
                    new Vector4d(1, 0, 0, 1), // left
                    new Vector4d(-1, 0, 0, 1), // right
                    new Vector4d(0, 1, 0, 1), // bottom
                    new Vector4d(0, -1, 0, 1), // top
                    new Vector4d(0, 0, 1, 1), // near
                    new Vector4d(0, 0, -1, 1)); // far

    private final FacePaint paint;
    private final Raster out;
    private final double[] nearest;
    private long depthTests;
    private long pixelsWritten;

    private PlainPipeline(FacePaint paint, Raster out) {
        this.paint = paint;
        this.out = out;
        nearest = new double[out.width() * out.height()];
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
    }

    /** Draws the visible parts of a mesh, as every visibility method does. */
    public static VisibilityWork draw(
            ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        var pipeline = new PlainPipeline(paint, out);
        var worldFromModel = new Matrix4d(); // the identity: a scene's faces stand in the world
        Matrix4d eyeFromWorld = PlainMatrices.eyeFromWorld(view.transform());
        Matrix4d clipFromEye = PlainMatrices.clipFromEye(view);
        List<Vector4d> worldPlanes = PlainFaces.worldPlanes(view);
        for (int face : PlainFaces.transparentLast(view, paint)) {
            Cancellation.check(cancelled);
            List<Vector4d> model = PlainFaces.corners(view.mesh(), face);
            List<Vector4d> world = clipped(transformed(worldFromModel, model), worldPlanes);
            List<Vector4d> eye = transformed(eyeFromWorld, world);
            List<Vector4d> clip = clipped(transformed(clipFromEye, eye), CLIP_PLANES);
            List<Vector3d> ndc = clip.stream().map(PlainPipeline::divided).toList();
            List<Vector3d> screen = ndc.stream().map(pipeline::toScreen).toList();
            // What is left of a face is convex, so triangles fill it like a fan.
            for (int k = 2; k < screen.size(); k++)
                pipeline.triangle(face, screen.get(0), screen.get(k - 1), screen.get(k));
        }
        return new VisibilityWork(0, pipeline.depthTests, pipeline.pixelsWritten, 0);
    }

    private static List<Vector4d> transformed(Matrix4d matrix, List<Vector4d> points) {
        return points.stream().map(point -> matrix.transform(point, new Vector4d())).toList();
    }

    /**
     * Cuts off what is beyond a plane, plane after plane. In clip space that is done before the
     * division, which would bring to the front what lies behind the eye.
     */
    private static List<Vector4d> clipped(List<Vector4d> polygon, List<Vector4d> planes) {
        List<Vector4d> rest = polygon;
        for (Vector4d plane : planes) {
            var inside = new ArrayList<Vector4d>();
            for (int k = 0; k < rest.size(); k++) {
                Vector4d from = rest.get(k);
                Vector4d to = rest.get((k + 1) % rest.size());
                double a = plane.dot(from);
                double b = plane.dot(to);
                if (a >= 0) inside.add(from);
                if (a < 0 != b < 0) inside.add(from.lerp(to, a / (a - b), new Vector4d()));
            }
            rest = inside;
        }
        return rest;
    }

    private static Vector3d divided(Vector4d clip) {
        return new Vector3d(clip.x / clip.w, clip.y / clip.w, clip.z / clip.w);
    }

    /** Takes ndc to pixels: whole numbers at their centres, y down; z stays the depth. */
    private Vector3d toScreen(Vector3d ndc) {
        double x = (ndc.x + 1) * out.width() / 2 - 0.5;
        double y = (1 - ndc.y) * out.height() / 2 - 0.5;
        return new Vector3d(x, y, ndc.z);
    }

    /**
     * Asks each pixel of the box, a hair off its centre, whether it lies on the inner side of all
     * three edges. Their shares mix the depths, since z / w is linear on the screen.
     */
    private void triangle(int face, Vector3d a, Vector3d b, Vector3d c) {
        double area = edge(a, b, c.x, c.y);
        if (area == 0) return;
        int left = (int) Math.max(0, Math.floor(Math.min(a.x, Math.min(b.x, c.x))));
        int right = (int) Math.min(out.width() - 1, Math.max(a.x, Math.max(b.x, c.x)));
        int top = (int) Math.max(0, Math.floor(Math.min(a.y, Math.min(b.y, c.y))));
        int bottom = (int) Math.min(out.height() - 1, Math.max(a.y, Math.max(b.y, c.y)));
        for (int row = top; row <= bottom; row++)
            for (int column = left; column <= right; column++) {
                double x = column + PixelPoint.RIGHT_OF_CENTER;
                double y = row + PixelPoint.BELOW_CENTER;
                double weightA = edge(b, c, x, y) / area;
                double weightB = edge(c, a, x, y) / area;
                double weightC = edge(a, b, x, y) / area;
                if (weightA >= 0 && weightB >= 0 && weightC >= 0)
                    pixel(face, column, row, weightA * a.z + weightB * b.z + weightC * c.z);
            }
    }

    /** Twice the area of the triangle p, a, b, exactly the opposite for the edge from b to a. */
    private static double edge(Vector3d a, Vector3d b, double px, double py) {
        return (a.x - px) * (b.y - py) - (a.y - py) * (b.x - px);
    }

    /** Tests the depth: the nearest stays, of equal depths the earlier. */
    private void pixel(int face, int x, int y, double depth) {
        depthTests++;
        int cell = y * out.width() + x;
        if (!(depth < nearest[cell])) return;
        if (paint.opaque(face)) nearest[cell] = depth;
        pixelsWritten++;
        color(face, x, y);
    }

    /**
     * Colours one pixel, the last stage: the paint lights the face there, combines that with its
     * texture, fades it with distance and lays it over what the picture holds.
     */
    private void color(int face, int x, int y) {
        paint.span(face, y, x, x + 1, out); // in row y the pixels from x to before x + 1
    }
}
