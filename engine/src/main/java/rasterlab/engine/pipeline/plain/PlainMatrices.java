package rasterlab.engine.pipeline.plain;

import java.util.stream.IntStream;
import org.joml.Matrix4d;
import org.joml.Vector4d;
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
     * perspective w = z, else w = 1; the zooms take a unit at z = 1, or at any z, to ndc.
     */
    static Matrix4d clipFromEye(ViewedMesh view) {
        var depths = IntStream.range(0, view.mesh().vertexCount()).mapToDouble(view::eyeZ);
        var range = depths.summaryStatistics();
        double room = ROOM * Math.max(Math.abs(range.getMin()), Math.abs(range.getMax()));
        double near = Math.max(view.near(), range.getMin() - room);
        double far = Math.min(view.far(), range.getMax() + room);
        double deep = far - near;
        PictureFit fit = view.fit();
        // The eye's axis in ndc: the centre of its pixel, by the inverse of what makes pixels of
        // ndc.
        double middleX = (2 * fit.toPixelX(0) + 1) / fit.width() - 1;
        double middleY = 1 - (2 * fit.toPixelY(0) + 1) / fit.height();
        double zoom = 2 * fit.pixelsPerUnit();
        if (!view.transform().central())
            return parallel(
                    zoom / fit.width(),
                    zoom / fit.height(),
                    middleX,
                    middleY,
                    2 / deep,
                    -(far + near) / deep);
        double zoomAtOne = zoom * view.transform().distance();
        return central(
                zoomAtOne / fit.width(),
                zoomAtOne / fit.height(),
                middleX,
                middleY,
                (far + near) / deep,
                -2 * far * near / deep);
    }

    private static Matrix4d central(
            double zoomX,
            double zoomY,
            double middleX,
            double middleY,
            double depthScale,
            double depthShift) {
        return rows(
                row(zoomX, 0, middleX, 0),
                row(0, zoomY, middleY, 0),
                row(0, 0, depthScale, depthShift),
                row(0, 0, 1, 0));
    }

    private static Matrix4d parallel(
            double zoomX,
            double zoomY,
            double middleX,
            double middleY,
            double depthScale,
            double depthShift) {
        return rows(
                row(zoomX, 0, 0, middleX),
                row(0, zoomY, 0, middleY),
                row(0, 0, depthScale, depthShift),
                row(0, 0, 0, 1));
    }

    private static Vector4d row(double x, double y, double z, double w) {
        return new Vector4d(x, y, z, w);
    }

    /** JOML's constructors list columns. */
    private static Matrix4d rows(Vector4d x, Vector4d y, Vector4d z, Vector4d w) {
        return new Matrix4d(x, y, z, w).transpose();
    }
}
