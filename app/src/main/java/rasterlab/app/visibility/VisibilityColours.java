package rasterlab.app.visibility;

import static rasterlab.app.canvas.MethodColours.BLUE;
import static rasterlab.app.canvas.MethodColours.BROWN;
import static rasterlab.app.canvas.MethodColours.DARK_GREEN;
import static rasterlab.app.canvas.MethodColours.GREEN;
import static rasterlab.app.canvas.MethodColours.GREY;
import static rasterlab.app.canvas.MethodColours.INDIGO;
import static rasterlab.app.canvas.MethodColours.MAGENTA;
import static rasterlab.app.canvas.MethodColours.OLIVE;
import static rasterlab.app.canvas.MethodColours.ORANGE;
import static rasterlab.app.canvas.MethodColours.PURPLE;
import static rasterlab.app.canvas.MethodColours.ROSE;
import static rasterlab.app.canvas.MethodColours.SAND;
import static rasterlab.app.canvas.MethodColours.SKY_BLUE;
import static rasterlab.app.canvas.MethodColours.SLATE;
import static rasterlab.app.canvas.MethodColours.TEAL;
import static rasterlab.app.canvas.MethodColours.VIOLET;
import static rasterlab.app.canvas.MethodColours.WINE;
import static rasterlab.app.canvas.MethodColours.YELLOW;

import java.util.Map;
import rasterlab.app.canvas.TopicColours;
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
                            // Never beside "auto", which no picture of the lab names.
                            Map.entry(OwnMethods.NAME, SAND)));

    private VisibilityColours() {}
}
