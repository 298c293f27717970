package rasterlab.app.spline;

import static rasterlab.app.canvas.method.MethodColors.BLUE;
import static rasterlab.app.canvas.method.MethodColors.GRAY;
import static rasterlab.app.canvas.method.MethodColors.GREEN;
import static rasterlab.app.canvas.method.MethodColors.OLIVE;
import static rasterlab.app.canvas.method.MethodColors.ORANGE;
import static rasterlab.app.canvas.method.MethodColors.PURPLE;
import static rasterlab.app.canvas.method.MethodColors.ROSE;
import static rasterlab.app.canvas.method.MethodColors.SAND;
import static rasterlab.app.canvas.method.MethodColors.SKY_BLUE;
import static rasterlab.app.canvas.method.MethodColors.WINE;
import static rasterlab.app.canvas.method.MethodColors.YELLOW;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColors;

/** The colours of the methods for curves and functions. */
final class SplineColors {
    static final TopicColors OWN =
            new TopicColors(
                    Map.ofEntries(
                            Map.entry("blending-textbook", SAND),
                            Map.entry("matrix", PURPLE),
                            Map.entry("horner", YELLOW),
                            Map.entry("de-casteljau", GREEN),
                            Map.entry("forward-differences", OLIVE),
                            Map.entry("forward-differences-float", GRAY),
                            Map.entry("uniform", WINE),
                            Map.entry("adaptive-naive", ORANGE),
                            Map.entry("adaptive", BLUE),
                            Map.entry("curvature-unchecked", ROSE),
                            Map.entry("fewest", SKY_BLUE),
                            Map.entry("cubic", BLUE),
                            Map.entry("monotone", ORANGE),
                            Map.entry("cubic-textbook", PURPLE)));

    private SplineColors() {}
}
