package rasterlab.app.clip;

import static rasterlab.app.canvas.method.MethodColors.BLUE;
import static rasterlab.app.canvas.method.MethodColors.DARK_GREEN;
import static rasterlab.app.canvas.method.MethodColors.GREEN;
import static rasterlab.app.canvas.method.MethodColors.OLIVE;
import static rasterlab.app.canvas.method.MethodColors.ORANGE;
import static rasterlab.app.canvas.method.MethodColors.PURPLE;
import static rasterlab.app.canvas.method.MethodColors.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColors.WINE;
import static rasterlab.app.canvas.method.MethodColors.YELLOW;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColors;

/** The colours of the methods for clipping. */
final class ClipColors {
    static final TopicColors OWN =
            new TopicColors(
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
                            Map.entry("sutherland-hodgman-textbook", PURPLE),
                            Map.entry("cohen-sutherland-6", BLUE),
                            Map.entry("divide-first-textbook", PURPLE),
                            Map.entry("homogeneous", GREEN)));

    private ClipColors() {}
}
