package rasterlab.app.visibility;

import static rasterlab.app.canvas.method.MethodColours.BLUE;
import static rasterlab.app.canvas.method.MethodColours.BROWN;
import static rasterlab.app.canvas.method.MethodColours.DARK_GREEN;
import static rasterlab.app.canvas.method.MethodColours.GREEN;
import static rasterlab.app.canvas.method.MethodColours.GREY;
import static rasterlab.app.canvas.method.MethodColours.INDIGO;
import static rasterlab.app.canvas.method.MethodColours.MAGENTA;
import static rasterlab.app.canvas.method.MethodColours.OLIVE;
import static rasterlab.app.canvas.method.MethodColours.ORANGE;
import static rasterlab.app.canvas.method.MethodColours.PURPLE;
import static rasterlab.app.canvas.method.MethodColours.ROSE;
import static rasterlab.app.canvas.method.MethodColours.SAND;
import static rasterlab.app.canvas.method.MethodColours.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColours.SLATE;
import static rasterlab.app.canvas.method.MethodColours.TEAL;
import static rasterlab.app.canvas.method.MethodColours.VIOLET;
import static rasterlab.app.canvas.method.MethodColours.WINE;
import static rasterlab.app.canvas.method.MethodColours.YELLOW;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColours;
import rasterlab.app.mine.OwnMethods;

/** The colours of the methods for hidden surfaces. */
final class VisibilityColours {
    static final TopicColours OWN =
            new TopicColours(
                    Map.ofEntries(
                            Map.entry("none", GREY),
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

    private VisibilityColours() {}
}
