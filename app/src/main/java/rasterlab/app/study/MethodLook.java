package rasterlab.app.study;

import java.awt.Color;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import rasterlab.app.canvas.MethodColours;

/** How a method looks in a chart; no two methods of one chart have both in common. */
public record MethodLook(Color colour, Marker marker) {
    /** Seven, which has no divisor in common with the palette's eleven colours. */
    private static final List<Marker> MARKERS =
            List.of(
                    SeriesMarkers.CIRCLE,
                    SeriesMarkers.SQUARE,
                    SeriesMarkers.TRIANGLE_UP,
                    SeriesMarkers.DIAMOND,
                    SeriesMarkers.TRIANGLE_DOWN,
                    SeriesMarkers.TRAPEZOID,
                    SeriesMarkers.RECTANGLE);

    /**
     * @param methods all of the topic in teaching order, those without a place on the chart too, so
     *     that a method looks the same whatever the others did
     */
    public static Map<String, MethodLook> of(List<String> methods) {
        Map<String, Color> colours = MethodColours.among(methods);
        var looks = new LinkedHashMap<String, MethodLook>();
        for (String method : methods) {
            int marker = looks.size();
            var look = new MethodLook(colours.get(method), marker(marker));
            while (looks.containsValue(look) && marker < looks.size() + MARKERS.size())
                look = new MethodLook(colours.get(method), marker(++marker));
            looks.put(method, look);
        }
        return looks;
    }

    /** The same in a colour that stands out from the ground. */
    public MethodLook on(ChartLook paper) {
        return new MethodLook(paper.line(colour), marker);
    }

    private static Marker marker(int number) {
        return MARKERS.get(number % MARKERS.size());
    }
}
