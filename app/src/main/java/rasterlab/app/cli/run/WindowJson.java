package rasterlab.app.cli.run;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.clip.segment.ClipWindow;

/**
 * A window to clip by as JSON: [xmin,ymin,xmax,ymax], or the corners of a convex polygon.
 *
 * @param rectangle none where corners were given
 * @param corners x and y of each in turn, of the rectangle too; not yet known to be convex
 */
record WindowJson(Optional<ClipWindow> rectangle, double[] corners) {
    private static final int MOST_CORNERS = 1_000;

    /** The field {@code window}. */
    static JsonField<WindowJson> field() {
        return JsonField.required("window", json -> json.checked(WindowJson::read));
    }

    private static WindowJson read(StrictJson json) throws IOException {
        List<double[]> parts =
                json.list(
                        "points of 2 numbers each, or [xmin,ymin,xmax,ymax]",
                        WindowJson::part,
                        3,
                        MOST_CORNERS);
        int width = parts.get(0).length;
        if (parts.stream().anyMatch(part -> part.length != width)
                || width == 1 && parts.size() != 4)
            throw new IllegalArgumentException(
                    "expected [xmin,ymin,xmax,ymax] or an array of points of 2 numbers each");
        double[] numbers = parts.stream().flatMapToDouble(Arrays::stream).toArray();
        return width == 2 ? new WindowJson(Optional.empty(), numbers) : rectangle(numbers);
    }

    private static double[] part(StrictJson json) throws IOException {
        return json.startsArray() ? json.numbers(2, 2) : new double[] {json.number()};
    }

    private static WindowJson rectangle(double[] sides) {
        var window = new ClipWindow(sides[0], sides[1], sides[2], sides[3]);
        return new WindowJson(
                Optional.of(window),
                PolygonInWindow.rectangle(
                        window.xmin(), window.ymin(), window.xmax(), window.ymax()));
    }
}
