package rasterlab.app.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import rasterlab.app.canvas.method.TopicColors;
import rasterlab.app.mine.OwnMethods;

/**
 * How a method looks in a chart; no two of {@value #MOST} methods of one chart have both mark and
 * line in common, so that they are told apart in grey too.
 *
 * @param stroke of its lines
 */
public record MethodLook(Color color, Marker marker, BasicStroke stroke) {
    private static final List<Marker> MARKERS =
            List.of(
                    SeriesMarkers.CIRCLE,
                    SeriesMarkers.SQUARE,
                    SeriesMarkers.TRIANGLE_UP,
                    SeriesMarkers.DIAMOND,
                    SeriesMarkers.TRIANGLE_DOWN,
                    SeriesMarkers.TRAPEZOID,
                    SeriesMarkers.RECTANGLE);

    /** The lengths on, off, on, … of a line in pixels; one that is not broken first. */
    private static final List<float[]> DASHES =
            List.of(new float[0], new float[] {8, 4}, new float[] {2, 3}, new float[] {8, 3, 2, 3});

    /** Dashes of lines with a point every 9 pixels, since they begin anew at each point. */
    private static final List<float[]> SHORT_DASHES =
            List.of(new float[0], new float[] {3, 5}, new float[] {2, 2}, new float[] {1, 7});

    private static final int MOST = 28;
    private static final float WIDTH = 2;

    /**
     * @param methods all of the topic in teaching order, those without a place on the chart too, so
     *     that a method looks the same whatever the others did
     * @param own the methods' colours
     */
    public static Map<String, MethodLook> of(List<String> methods, TopicColors own) {
        Map<String, Color> colors = own.among(methods);
        var looks = new LinkedHashMap<String, MethodLook>();
        for (String method : methods) {
            int number = looks.size();
            Marker marker =
                    method.equals(OwnMethods.NAME)
                            ? new StarMarker()
                            : MARKERS.get(number % MARKERS.size());
            float[] dashes = DASHES.get(number / MARKERS.size() % DASHES.size());
            looks.put(method, new MethodLook(colors.get(method), marker, stroke(dashes)));
        }
        return looks;
    }

    private static BasicStroke stroke(float[] dashes) {
        return dashes.length == 0
                ? new BasicStroke(WIDTH)
                : new BasicStroke(
                        WIDTH, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1, dashes, 0);
    }

    /** This look in a colour that stands out from the ground. */
    public MethodLook on(ChartLook paper) {
        return new MethodLook(paper.line(color), marker, stroke);
    }

    /**
     * This look for a line without marks, told by its dashes alone.
     *
     * @param number of the line on its chart, from 0; every fourth has the same dashes
     */
    public MethodLook unmarked(int number) {
        return new MethodLook(
                color, SeriesMarkers.NONE, stroke(SHORT_DASHES.get(number % SHORT_DASHES.size())));
    }

    /** Gives a series this look. */
    public void style(XYSeries series) {
        series.setMarker(marker);
        series.setMarkerColor(color);
        series.setLineColor(color);
        series.setLineStyle(stroke);
    }
}
