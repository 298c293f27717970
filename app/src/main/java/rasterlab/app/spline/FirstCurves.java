package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;

/** The points with which each form of curve opens. */
final class FirstCurves {
    private FirstCurves() {}

    static List<Place> points(CurveForm form) {
        return switch (form) {
            case BEZIER -> of(60, 330, 90, 10, 330, 70, 600, 300);
            case PIECES ->
                    of(
                            40, 260, 80, 90, 200, 60, 260, 180, 320, 300, 400, 340, 460, 220, 520,
                            100, 600, 60, 640, 200);
            case HERMITE -> of(60, 280, 520, 260, 420, -660, 360, 600);
            case CATMULL_ROM, B_SPLINE ->
                    of(20, 300, 90, 110, 230, 60, 330, 250, 460, 300, 560, 90, 640, 220);
        };
    }

    private static List<Place> of(double... coordinates) {
        var points = new ArrayList<Place>();
        for (int i = 0; i < coordinates.length; i += 2)
            points.add(new Place(coordinates[i], coordinates[i + 1]));
        return List.copyOf(points);
    }
}
