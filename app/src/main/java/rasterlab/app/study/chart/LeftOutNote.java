package rasterlab.app.study.chart;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import rasterlab.app.canvas.Wrapping;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

/**
 * Sentences below a chart that name the methods that could not be timed, and why, and those that
 * were not measured at all; no lines where there are none.
 */
public record LeftOutNote(List<String> lines) {
    private static final int LINE_HEIGHT = 16;
    private static final int MARGIN = 12;

    /** The longest line, in characters: what about 950 pixels hold. */
    private static final int LONGEST_LINE = 130;

    public LeftOutNote {
        lines = List.copyOf(lines);
    }

    public static LeftOutNote of(Study study, StudyWords words) {
        var points = new LinkedHashMap<String, Map<Verdict.Kind, List<Measurement>>>();
        for (Measurement measured : study.measurements())
            if (!measured.cost().timed() && !measured.isAnswered())
                points.computeIfAbsent(
                                measured.method(), method -> new EnumMap<>(Verdict.Kind.class))
                        .computeIfAbsent(measured.kind(), kind -> new ArrayList<>())
                        .add(measured);
        var lines = new ArrayList<>(wrapped(words.notMeasuredNote(study)));
        lines.addAll(wrapped(words.notRightNote(study)));
        if (points.isEmpty()) return new LeftOutNote(lines);
        String methods =
                points.entrySet().stream()
                        .map(
                                entry ->
                                        entry.getKey()
                                                + " "
                                                + reasons(study, entry.getValue(), words))
                        .collect(Collectors.joining("; "));
        lines.addAll(wrapped(words.notTimed() + " " + methods));
        return new LeftOutNote(lines);
    }

    private static List<String> wrapped(String text) {
        return text.isEmpty() ? List.of() : Wrapping.lines(text, LONGEST_LINE, String::length);
    }

    private static String reasons(
            Study study, Map<Verdict.Kind, List<Measurement>> points, StudyWords words) {
        return points.entrySet().stream()
                .map(entry -> words.reason(study, entry.getKey(), entry.getValue()))
                .collect(Collectors.joining("; ", "(", ")"));
    }

    /** Height of the note in pixels. */
    int height() {
        return lines.isEmpty() ? 0 : lines.size() * LINE_HEIGHT + MARGIN;
    }

    /**
     * @param top upper edge of the note, in pixels of the picture
     */
    void paint(Graphics2D graphics, Color ink, int top) {
        graphics.setColor(ink);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        int y = top;
        for (String line : lines) {
            y += LINE_HEIGHT;
            graphics.drawString(line, MARGIN, y - 4);
        }
    }
}
