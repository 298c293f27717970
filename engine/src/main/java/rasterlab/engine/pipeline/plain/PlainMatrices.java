package rasterlab.engine.pipeline.plain;

import java.util.stream.IntStream;
import org.joml.Matrix4d;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

/** The matrices between the spaces, written as rows, for points as columns. */
final class PlainMatrices {
    /** Room before the nearest and behind the farthest corner, as a share of their depths. */
    private static final double ROOM = 1e-5;

    private PlainMatrices() {}

    static Matrix4d eyeFromWorld(ViewTransform transform) {
        var matrix = new Matrix4d();
        for (int row = 0; row < 3; row++)
            for (int column = 0; column < 4; column++)
                matrix.setRowColumn(row, column, transform.entry(row, column));
        return matrix;
    }

    /**
     * The depths of the scene, or what the near and the far plane leave of them, become −1 to 1. In
     * perspective w = z, else w = 1.
     */
    static Matrix4d clipFromEye(ViewedMesh view) {
        var depths = IntStream.range(0, view.mesh().vertexCount()).mapToDouble(view::eyeZ);
        var range = depths.summaryStatistics();
        double room = ROOM * Math.max(Math.abs(range.getMin()), Math.abs(range.getMax()));
        double near = Math.max(view.near(), range.getMin() - room);
        double far = Math.min(view.far(), range.getMax() + room);
        double deep = far - near;
        PictureFit fit = view.fit();
        double middleX = (2 * fit.toPixelX(0) + 1) / fit.width() - 1;
        double middleY = 1 - (2 * fit.toPixelY(0) + 1) / fit.height();
        double zoom = 2 * fit.pixelsPerUnit();
        return view.transform().central()
                ? central(
                        zoom * view.transform().distance() / fit.width(),
                        zoom * view.transform().distance() / fit.height(),
                        middleX,
                        middleY,
                        (far + near) / deep,
                        -2 * far * near / deep)
                : parallel(
                        zoom / fit.width(),
                        zoom / fit.height(),
                        middleX,
                        middleY,
                        2 / deep,
                        -(far + near) / deep);
    }

    private static Matrix4d central(double a, double b, double x, double y, double c, double d) {
        return rows(
                a, 0, x, 0, //
                0, b, y, 0, //
                0, 0, c, d, //
                0, 0, 1, 0);
    }

    private static Matrix4d parallel(double a, double b, double x, double y, double c, double d) {
        return rows(
                a, 0, 0, x, //
                0, b, 0, y, //
                0, 0, c, d, //
                0, 0, 0, 1);
    }

    /** JOML's constructors list columns. */
    private static Matrix4d rows(double... sixteen) {
        return new Matrix4d().set(sixteen).transpose();
    }
}
