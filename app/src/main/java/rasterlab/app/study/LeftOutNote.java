package rasterlab.app.study;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;

/** Names, in the corner below the legend, the methods that could not be timed, and why. */
final class LeftOutNote extends Annotation {
    private static final int LINE_HEIGHT = 15;

    private final List<String> lines = new ArrayList<>();
    private final int x;
    private final int bottom;

    /**
     * @param x left end of the text, in pixels of the chart
     * @param bottom base line of the last row, in pixels of the chart
     */
    LeftOutNote(Study study, int x, int bottom) {
        super(true);
        this.x = x;
        this.bottom = bottom;
        Map<String, String> reasons = new LinkedHashMap<>();
        for (Measurement measured : study.measurements())
            if (!measured.cost().timed())
                reasons.merge(
                        measured.method(),
                        measured.kind().code() + " at " + measured.size(),
                        (before, more) -> before + ", " + measured.size());
        if (!reasons.isEmpty()) lines.add("Not timed:");
        reasons.forEach(
                (method, reason) -> {
                    lines.add(method);
                    lines.add("   " + reason);
                });
    }

    @Override
    public void paint(Graphics2D graphics) {
        graphics.setColor(Color.DARK_GRAY);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        int y = bottom - (lines.size() - 1) * LINE_HEIGHT;
        for (String line : lines) {
            graphics.drawString(line, x, y);
            y += LINE_HEIGHT;
        }
    }
}
