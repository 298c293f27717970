package rasterlab.app.light.panel;

import static rasterlab.app.canvas.method.MethodColors.BLUE;
import static rasterlab.app.canvas.method.MethodColors.PURPLE;

import java.util.Map;
import rasterlab.app.canvas.method.TopicColors;

/** The colours of the methods for light and colour. */
final class LightColors {
    static final TopicColors OWN =
            new TopicColors(
                    Map.ofEntries(
                            Map.entry("formula-textbook", PURPLE), Map.entry("formula", BLUE)));

    private LightColors() {}
}
