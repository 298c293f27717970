package rasterlab.exercises.property;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.AxisRotation;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.EyeView;
import rasterlab.contract.FaceShader;
import rasterlab.contract.PlaneRotation;
import rasterlab.contract.PointShader;
import rasterlab.contract.PolygonClipper;
import rasterlab.contract.SegmentClipper;
import rasterlab.engine.Topics;

/** Mistakes that break a property and that none of the topic's own faulty methods makes. */
final class FaultyMethods {
    private FaultyMethods() {}

    /** Right methods of a topic with one mistake each. */
    static List<Object> of(String topic) {
        return switch (topic) {
            case "ellipse" -> List.of(withoutAQuadrant());
            case "clip-segment" -> List.of(shortened());
            case "clip-polygon" -> List.of(shrunk());
            case "rotate" -> List.of(growing());
            case "rotate-axis" -> List.of(growingAboutAnAxis());
            case "view" -> List.of(stretched());
            case "shade" -> List.of((PointShader) point -> new double[] {1, 1, 1});
            case "shade-face" -> List.of(white());
            default -> List.of();
        };
    }

    private static Object right(String topic) {
        return Topics.named(topic).methods().stream()
                .filter(one -> one.promisesToBeRight())
                .findFirst()
                .orElseThrow()
                .implementation();
    }

    private static EllipseRasterizer withoutAQuadrant() {
        EllipseRasterizer right = (EllipseRasterizer) right("ellipse");
        return (x, y, a, b, out) ->
                right.draw(
                        x,
                        y,
                        a,
                        b,
                        (px, py) -> {
                            if (px <= x || py <= y) out.plot(px, py);
                        });
    }

    private static SegmentClipper shortened() {
        SegmentClipper right = (SegmentClipper) right("clip-segment");
        return (xmin, ymin, xmax, ymax, x0, y0, x1, y1, out) ->
                right.clip(
                        xmin,
                        ymin,
                        xmax,
                        ymax,
                        x0,
                        y0,
                        x1,
                        y1,
                        (fromX, fromY, toX, toY) ->
                                out.segment(fromX, fromY, (fromX + toX) / 2, (fromY + toY) / 2));
    }

    /** Each corner comes half as near to the first one. */
    private static PolygonClipper shrunk() {
        PolygonClipper right =
                (PolygonClipper)
                        Topics.named("clip-polygon").method("sutherland-hodgman").implementation();
        return (window, subject, out) ->
                right.clip(
                        window,
                        subject,
                        corners -> {
                            double[] half = corners.clone();
                            for (int i = 2; i < half.length; i++)
                                half[i] = (corners[i] + corners[i % 2]) / 2;
                            out.polygon(half);
                        });
    }

    private static PlaneRotation growing() {
        PlaneRotation right = (PlaneRotation) right("rotate");
        return (degrees, times, points) -> {
            right.rotate(degrees, times, points);
            for (int i = 0; i < points.length; i++) points[i] *= 1.001;
        };
    }

    private static AxisRotation growingAboutAnAxis() {
        AxisRotation right = (AxisRotation) right("rotate-axis");
        return (through, direction, degrees, points) -> {
            right.rotate(through, direction, degrees, points);
            for (int i = 0; i < points.length; i++) points[i] *= 1.001;
        };
    }

    private static EyeView stretched() {
        EyeView right = (EyeView) right("view");
        return (theta, phi, rho, points) -> {
            right.view(theta, phi, rho, points);
            for (int i = 0; i < points.length; i += 3) points[i] *= 1.5;
        };
    }

    private static FaceShader white() {
        return (face, weights) -> {
            double[] white = new double[weights.length];
            Arrays.fill(white, 1);
            return white;
        };
    }
}
