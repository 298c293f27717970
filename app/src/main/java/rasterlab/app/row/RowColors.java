package rasterlab.app.row;

import static rasterlab.app.canvas.method.MethodColors.BLUE;
import static rasterlab.app.canvas.method.MethodColors.BROWN;
import static rasterlab.app.canvas.method.MethodColors.MAGENTA;
import static rasterlab.app.canvas.method.MethodColors.ROSE;
import static rasterlab.app.canvas.method.MethodColors.TEAL;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColors;

/** The colours of the methods for rows of pixels. */
public final class RowColors {
    public static final TopicColors OWN =
            new TopicColors(
                    Map.ofEntries(
                            Map.entry("z16", ROSE),
                            Map.entry("z24", TEAL),
                            Map.entry("z32", BROWN),
                            Map.entry("zfloat", BLUE),
                            Map.entry("reversed-z", MAGENTA)));

    private RowColors() {}
}
