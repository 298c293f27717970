package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.engine.spline.exact.Polyline;

@Timeout(300)
class CurvePictureTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final CurveLabModel model = new CurveLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    @Test
    @DisplayName("the name of a control point is written over the curve or the polygon")
    void labelsKeepOffTheCurveAndItsPolygon() throws Exception {
        thread.settle(model::settle);
        CurveLabState state = model.state();
        var view = new Rectangle(0, 0, 700, 400);
        PlaneMap map =
                PlaneMap.fitting(new Rectangle2D.Double(0, -50, 700, 400), view, PlaneAxes.RASTER);
        List<Line2D> lines =
                new CurvePicture(state.drawings(), state.at(), state.step()).lines(map, view);
        Polyline curve = state.drawings().exact().get(0);
        covered(lines, map, curve.x(curve.size() / 2), curve.y(curve.size() / 2));
        List<Place> handles = state.drawings().choice().handles();
        for (int i = 1; i < handles.size(); i++)
            covered(
                    lines,
                    map,
                    (handles.get(i - 1).x() + handles.get(i).x()) / 2,
                    (handles.get(i - 1).y() + handles.get(i).y()) / 2);
    }

    private static void covered(List<Line2D> lines, PlaneMap map, double x, double y) {
        assertTrue(
                lines.stream().anyMatch(line -> line.ptSegDist(map.viewX(x), map.viewY(y)) < 1),
                x + ", " + y);
    }
}
