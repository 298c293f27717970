package rasterlab.app.cli.study;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.language.Texts;
import rasterlab.app.study.StudyCounts;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;

/** The measurements of a study as lines of text. */
final class StudyTable {
    /** The columns of a terminal or page that the narrow table keeps to. */
    static final int WIDTH = 100;

    /** The sign in place of the numbers of a method that did not end or crashed. */
    private static final String NONE = "–";

    private final Study study;
    private final Texts texts;
    private final StudyWords words;

    StudyTable(Study study, ReportLanguage language) {
        this.study = study;
        texts = language.texts();
        words = new StudyWords(language.inWindow());
    }

    /** Times and errors, under a line with their units; what it leaves out is named below. */
    List<String> narrow() {
        var table =
                new TextTable(
                        heads("method", "workload", "ns", "spread", "error", "wrong", "verdict"));
        for (Measurement each : study.measurements())
            table.add(
                    Stream.of(named(each), times(each), errors(each))
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
    List<String> wide() {
        StudyCounts counts = StudyCounts.of(study);
        String item = words.item(study);
        var heads = new ArrayList<String>(heads("method", "workload", "size"));
        heads.add(texts.text("study.ns-per", item));
        heads.addAll(heads("spread"));
        counts.names().forEach(name -> heads.add(texts.text("study.per", name, item)));
        heads.add(texts.text("study.error-in", words.errorUnit(study)));
        heads.addAll(heads("wrong", "verdict"));
        var table = new TextTable(heads);
        for (Measurement each : study.measurements()) {
            var row = new ArrayList<String>(named(each));
            row.add(String.valueOf(each.size()));
            row.addAll(times(each));
            counts.cells(each).forEach(cell -> row.add(shortened(cell)));
            row.addAll(errors(each));
            table.add(row);
        }
        return table.lines();
    }

    private List<String> heads(String... keys) {
        return Stream.of(keys).map(key -> texts.text("study." + key)).toList();
    }

    private static List<String> named(Measurement measured) {
        return List.of(measured.method(), measured.workload());
    }

    private List<String> times(Measurement measured) {
        Cost cost = measured.cost();
        if (!cost.timed()) return List.of(NONE, NONE);
        return List.of(
                number(cost.medianNanos()),
                number(cost.lowNanos()) + "–" + number(cost.highNanos()));
    }

    private List<String> errors(Measurement measured) {
        Deviation error = measured.error();
        String verdict = words.verdict(measured.kind());
        if (!measured.isAnswered()) return List.of(NONE, NONE, verdict);
        return List.of(
                rounded(error.worst()), String.valueOf(error.missing() + error.extra()), verdict);
    }

    private String shortened(String count) {
        return count.contains(".") ? number(Double.parseDouble(count)) : count;
    }

    /** Two places, none from 1,000 on, or two digits where two places would be 0. */
    private String number(double value) {
        String form = value >= 1_000 ? "%.0f" : value == 0 || value >= 0.01 ? "%.2f" : "%.1e";
        return String.format(texts.locale(), form, value);
    }

    /** Three digits; the files have all. */
    private String rounded(double error) {
        if (error == 0) return "0";
        String form = error >= 0.001 && error < 1000 ? "%.3f" : "%.2e";
        return Double.isFinite(error)
                ? String.format(texts.locale(), form, error)
                : String.valueOf(error);
    }
}
