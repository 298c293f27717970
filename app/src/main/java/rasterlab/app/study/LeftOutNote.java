package rasterlab.app.study;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

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
    LeftOutNote(Study study, StudyWords words, int x, int bottom) {
        super(true);
        this.x = x;
        this.bottom = bottom;
        var sizes = new LinkedHashMap<String, EnumMap<Verdict.Kind, List<Integer>>>();
        for (Measurement measured : study.measurements())
            if (!measured.cost().timed())
                sizes.computeIfAbsent(
                                measured.method(), method -> new EnumMap<>(Verdict.Kind.class))
                        .computeIfAbsent(measured.kind(), kind -> new ArrayList<>())
                        .add(measured.size());
        if (!sizes.isEmpty()) lines.add(words.notTimed());
        sizes.forEach(
                (method, kinds) -> {
                    lines.add(method);
                    kinds.forEach((kind, at) -> lines.add("   " + words.reason(kind, at)));
                });
    }

    List<String> lines() {
        return List.copyOf(lines);
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
