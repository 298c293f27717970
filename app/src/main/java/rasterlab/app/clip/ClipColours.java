package rasterlab.app.clip;

import static rasterlab.app.canvas.method.MethodColours.BLUE;
import static rasterlab.app.canvas.method.MethodColours.DARK_GREEN;
import static rasterlab.app.canvas.method.MethodColours.GREEN;
import static rasterlab.app.canvas.method.MethodColours.OLIVE;
import static rasterlab.app.canvas.method.MethodColours.ORANGE;
import static rasterlab.app.canvas.method.MethodColours.PURPLE;
import static rasterlab.app.canvas.method.MethodColours.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColours.WINE;
import static rasterlab.app.canvas.method.MethodColours.YELLOW;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColours;

/** The colours of the methods for clipping. */
final class ClipColours {
    static final TopicColours OWN =
            new TopicColours(
                    Map.ofEntries(
                            Map.entry("four-lines", GREEN),
                            Map.entry("cohen-sutherland-textbook", PURPLE),
                            Map.entry("cohen-sutherland-nested-textbook", SKY_BLUE),
                            Map.entry("cohen-sutherland-float-textbook", OLIVE),
                            Map.entry("cohen-sutherland", BLUE),
                            Map.entry("liang-barsky", ORANGE),
                            Map.entry("liang-barsky-branchless", WINE),
                            Map.entry("midpoint", YELLOW),
                            Map.entry("cyrus-beck", DARK_GREEN),
                            Map.entry("sutherland-hodgman", ORANGE),
                            Map.entry("weiler-atherton", BLUE),
                            Map.entry("cohen-sutherland-6", BLUE),
                            Map.entry("divide-first-textbook", PURPLE),
                            Map.entry("homogeneous", GREEN)));

    private ClipColours() {}
}
