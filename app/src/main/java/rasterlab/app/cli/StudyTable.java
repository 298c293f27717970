package rasterlab.app.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.language.Texts;
import rasterlab.app.study.StudyCounts;
import rasterlab.app.study.StudyWords;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;

/** The measurements of a study as lines of text. */
final class StudyTable {
    /** The columns of a terminal or page that the narrow table keeps to. */
    static final int WIDTH = 100;

    /** What a method that did not end or crashed has instead of numbers. */
    private static final String NOT_TIMED = "–";

    private StudyTable() {}

    /** Times and errors, under a line with their units; what it leaves out is named below. */
    static List<String> narrow(Study study, ReportLanguage language) {
        Texts texts = language.texts();
        var words = new StudyWords(language.inWindow());
        var table =
                new TextTable(
                        heads(
                                texts,
                                "method",
                                "workload",
                                "ns",
                                "spread",
                                "error",
                                "wrong",
                                "verdict"));
        for (Measurement each : study.measurements())
            table.add(
                    Stream.of(named(each), times(each, texts), errors(each, words, texts))
                            .flatMap(List::stream)
                            .toList());
        var lines = new ArrayList<String>();
        lines.addAll(wrapped(texts.text("study.units", words.item(study), words.errorUnit(study))));
        lines.addAll(table.lines());
        List<String> counts = StudyCounts.of(study).names();
        if (!counts.isEmpty())
            lines.addAll(wrapped(texts.text("study.wide", String.join(", ", counts))));
        return lines;
    }

    private static List<String> wrapped(String text) {
        return Wrapping.lines(text, WIDTH, String::length);
    }

    /** All columns, the units in their heads. */
    static List<String> wide(Study study, ReportLanguage language) {
        StudyCounts counts = StudyCounts.of(study);
        Texts texts = language.texts();
        var words = new StudyWords(language.inWindow());
        String item = words.item(study);
        var heads = new ArrayList<String>(heads(texts, "method", "workload", "size"));
        heads.add(texts.text("study.ns-per", item));
        heads.addAll(heads(texts, "spread"));
        counts.names().forEach(name -> heads.add(texts.text("study.per", name, item)));
        heads.add(texts.text("study.error-in", words.errorUnit(study)));
        heads.addAll(heads(texts, "wrong", "verdict"));
        var table = new TextTable(heads);
        for (Measurement each : study.measurements()) {
            var row = new ArrayList<String>(named(each));
            row.add(String.valueOf(each.size()));
            row.addAll(times(each, texts));
            counts.cells(each).forEach(cell -> row.add(shortened(cell, texts)));
            row.addAll(errors(each, words, texts));
            table.add(row);
        }
        return table.lines();
    }

    private static List<String> heads(Texts texts, String... keys) {
        return Stream.of(keys).map(key -> texts.text("study." + key)).toList();
    }

    private static List<String> named(Measurement measured) {
        return List.of(measured.method(), measured.workload());
    }

    private static List<String> times(Measurement measured, Texts texts) {
        Cost cost = measured.cost();
        if (!cost.timed()) return List.of(NOT_TIMED, NOT_TIMED);
        return List.of(
                number(cost.medianNanos(), texts),
                number(cost.lowNanos(), texts) + "–" + number(cost.highNanos(), texts));
    }

    private static List<String> errors(Measurement measured, StudyWords words, Texts texts) {
        Deviation error = measured.error();
        String verdict = words.verdict(measured.kind());
        if (!measured.cost().timed()) return List.of(NOT_TIMED, NOT_TIMED, verdict);
        return List.of(
                rounded(error.worst(), texts),
                String.valueOf(error.missing() + error.extra()),
                verdict);
    }

    private static String shortened(String count, Texts texts) {
        return count.contains(".") ? number(Double.parseDouble(count), texts) : count;
    }

    /** Two places, none from 1,000 on, or two digits where two places would be 0. */
    private static String number(double value, Texts texts) {
        String form = value >= 1_000 ? "%.0f" : value == 0 || value >= 0.01 ? "%.2f" : "%.1e";
        return String.format(texts.locale(), form, value);
    }

    /** Three digits; the files have all. */
    private static String rounded(double error, Texts texts) {
        if (error == 0) return "0";
        String form = error >= 0.001 && error < 1000 ? "%.3f" : "%.2e";
        return Double.isFinite(error)
                ? String.format(texts.locale(), form, error)
                : String.valueOf(error);
    }
}
