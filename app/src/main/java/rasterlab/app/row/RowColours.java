package rasterlab.app.row;

import static rasterlab.app.canvas.method.MethodColours.BLUE;
import static rasterlab.app.canvas.method.MethodColours.BROWN;
import static rasterlab.app.canvas.method.MethodColours.MAGENTA;
import static rasterlab.app.canvas.method.MethodColours.ROSE;
import static rasterlab.app.canvas.method.MethodColours.TEAL;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColours;

/** The colours of the methods for rows of pixels. */
public final class RowColours {
    public static final TopicColours OWN =
            new TopicColours(
                    Map.ofEntries(
                            Map.entry("z16", ROSE),
                            Map.entry("z24", TEAL),
                            Map.entry("z32", BROWN),
                            Map.entry("zfloat", BLUE),
                            Map.entry("reversed-z", MAGENTA)));

    private RowColours() {}
}
