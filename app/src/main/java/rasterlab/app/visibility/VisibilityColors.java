package rasterlab.app.visibility;

import static rasterlab.app.canvas.method.MethodColors.BLUE;
import static rasterlab.app.canvas.method.MethodColors.BROWN;
import static rasterlab.app.canvas.method.MethodColors.DARK_GREEN;
import static rasterlab.app.canvas.method.MethodColors.GRAY;
import static rasterlab.app.canvas.method.MethodColors.GREEN;
import static rasterlab.app.canvas.method.MethodColors.INDIGO;
import static rasterlab.app.canvas.method.MethodColors.MAGENTA;
import static rasterlab.app.canvas.method.MethodColors.OLIVE;
import static rasterlab.app.canvas.method.MethodColors.ORANGE;
import static rasterlab.app.canvas.method.MethodColors.PURPLE;
import static rasterlab.app.canvas.method.MethodColors.ROSE;
import static rasterlab.app.canvas.method.MethodColors.SAND;
import static rasterlab.app.canvas.method.MethodColors.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColors.SLATE;
import static rasterlab.app.canvas.method.MethodColors.TEAL;
import static rasterlab.app.canvas.method.MethodColors.VIOLET;
import static rasterlab.app.canvas.method.MethodColors.WINE;
import static rasterlab.app.canvas.method.MethodColors.YELLOW;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColors;
import rasterlab.app.mine.OwnMethods;

/** The colours of the methods for hidden surfaces. */
final class VisibilityColors {
    static final TopicColors OWN =
            new TopicColors(
                    Map.ofEntries(
                            Map.entry("none", GRAY),
                            Map.entry("back-face", INDIGO),
                            Map.entry("convex", YELLOW),
                            Map.entry("painter-textbook", PURPLE),
                            Map.entry("painter", ORANGE),
                            Map.entry("newell", WINE),
                            Map.entry("bsp", OLIVE),
                            Map.entry("scanline", DARK_GREEN),
                            Map.entry("warnock", SKY_BLUE),
                            Map.entry("z16", ROSE),
                            Map.entry("z24", TEAL),
                            Map.entry("z32", BROWN),
                            Map.entry("zfloat", BLUE),
                            Map.entry("reversed-z", MAGENTA),
                            Map.entry("raycast", GREEN),
                            Map.entry("plain", VIOLET),
                            Map.entry("pipeline", SLATE),
                            Map.entry("auto", SAND),
                            // It never appears beside "auto", which no picture of the lab names.
                            Map.entry(OwnMethods.NAME, SAND)));

    private VisibilityColors() {}
}
