package rasterlab.app.study;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.measuring.MedianInterval;

/**
 * A study as comma-separated values, what was counted per item behind the times and errors. Source
 * of the quoting: RFC 4180.
 */
final class StudyCsv {
    private static final List<String> HEADS =
            List.of(
                    "topic",
                    "method",
                    "workload",
                    "size",
                    "median_ns",
                    "low_ns",
                    "high_ns",
                    "worst_error",
                    "error_unit",
                    "missing",
                    "extra",
                    "of",
                    "verdict",
                    "detail");

    /** The heads behind what was counted: how far the median can be believed. */
    private static final List<String> INTERVAL =
            List.of("interval_low_ns", "interval_high_ns", "rounds");

    private StudyCsv() {}

    static String of(Study study) {
        StudyCounts counts = StudyCounts.of(study);
        return Stream.concat(
                        Stream.of(heads(counts)),
                        study.measurements().stream().map(measured -> row(study, measured, counts)))
                .map(cells -> cells.stream().map(StudyCsv::cell).collect(Collectors.joining(",")))
                .collect(Collectors.joining("\r\n", "", "\r\n"));
    }

    private static List<String> heads(StudyCounts counts) {
        Stream<String> counted = counts.names().stream().map(name -> name + "_per_item");
        return Stream.of(HEADS.stream(), counted, INTERVAL.stream()).flatMap(one -> one).toList();
    }

    private static List<String> row(Study study, Measurement measured, StudyCounts counts) {
        return Stream.of(
                        measuredCells(study, measured),
                        counts.cells(measured),
                        interval(study, measured))
                .flatMap(List::stream)
                .toList();
    }

    private static List<String> interval(Study study, Measurement measured) {
        if (!measured.cost().timed()) return List.of("", "", "0");
        MedianInterval interval = measured.cost().interval(study.noise(measured.workload()));
        return List.of(
                String.valueOf(interval.low()),
                String.valueOf(interval.high()),
                String.valueOf(measured.cost().rounds().size()));
    }

    private static List<String> measuredCells(Study study, Measurement measured) {
        return List.of(
                study.topic(),
                measured.method(),
                measured.workload(),
                String.valueOf(measured.size()),
                timed(measured, measured.cost().medianNanos()),
                timed(measured, measured.cost().lowNanos()),
                timed(measured, measured.cost().highNanos()),
                measured.isAnswered() ? String.valueOf(measured.error().worst()) : "",
                study.errorUnit(),
                String.valueOf(measured.error().missing()),
                String.valueOf(measured.error().extra()),
                String.valueOf(measured.error().of()),
                measured.kind().code(),
                measured.detail());
    }

    /** Blank for a method that did not end or crashed. */
    private static String timed(Measurement measured, double value) {
        return measured.cost().timed() ? String.valueOf(value) : "";
    }

    private static String cell(String value) {
        if (!value.matches("(?s).*[\",\r\n].*")) return value;
        return '"' + value.replace("\"", "\"\"") + '"';
    }
}
