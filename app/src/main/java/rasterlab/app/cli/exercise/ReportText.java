package rasterlab.app.cli.exercise;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.app.cli.console.TextTable;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.published.PublishedCase;
import rasterlab.exercises.published.PublishedDiagnostic;
import rasterlab.exercises.published.PublishedPicture;
import rasterlab.exercises.published.PublishedPoints;
import rasterlab.exercises.published.PublishedReport;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.topic.TopicGradings;

/** A grading report as text for a terminal. */
final class ReportText {
    private final PrintStream out;
    private final Texts texts;
    private final String fileName;

    /**
     * @param fileName of the student's source, which starts each diagnostic
     */
    ReportText(PrintStream out, Texts texts, String fileName) {
        this.out = out;
        this.texts = texts;
        this.fileName = fileName;
    }

    /** Prints a report of this machine. */
    void print(Exercise exercise, Report report) {
        print(
                exercise.title(language()),
                exercise.points().total(),
                PublishedReport.of(exercise, report, language(), (judged, picture) -> ""),
                exercise.form() == Exercise.TaskKind.WRITE,
                () -> {
                    if (report.nanosPerItem() > 0)
                        say(cost(exercise), texts.text("cost-nanos", report.nanosPerItem()));
                });
    }

    private static String cost(Exercise exercise) {
        return TopicGradings.named(exercise.topic()).inOwnWords("cost");
    }

    /**
     * Prints a server's report.
     *
     * @param exercise as the server has it
     * @param late whether it was handed in after the deadline
     */
    void print(JsonNode exercise, PublishedReport report, boolean late) {
        print(
                exercise.path("title").asText(),
                exercise.path("points").path("total").asInt(),
                report,
                exercise.path("kind")
                        .asText(Exercise.TaskKind.WRITE.code())
                        .equals(Exercise.TaskKind.WRITE.code()),
                () -> {
                    if (late) out.println(texts.text("late"));
                    say("revision", report.revision());
                });
    }

    /**
     * @param runs whether a program of the student ran
     */
    private void print(String title, int all, PublishedReport report, boolean runs, Runnable more) {
        PublishedPoints points = report.points();
        say("exercise", title);
        say("verdict", GradingVerdict.word(report.verdict(), language()));
        say(
                "points",
                String.format(
                        Locale.ROOT,
                        texts.text("points-line"),
                        points.total(),
                        points.of(),
                        points.accuracy(),
                        points.stability(),
                        points.speed()));
        if (points.hints() > 0) say("hints", "−" + points.hints());
        if (points.late() > 0) say("late-cost", "−" + points.late());
        points.manual().forEach(one -> say("manual", one.signed() + ", " + one.reason()));
        int hidden = all - points.of();
        if (hidden > 0)
            say("hidden", String.format(Locale.ROOT, texts.text("hidden-line"), hidden, all));
        more.run();
        if (runs) say("isolation", Report.isolationIn(language(), report.isolation()));
        report.diagnostics().forEach(this::printDiagnostic);
        printCases(report.cases());
    }

    /** Prints one value with its name in the report's language. */
    void say(String key, String value) {
        out.println(texts.text(key) + ": " + value);
    }

    private void printDiagnostic(PublishedDiagnostic diagnostic) {
        String line = diagnostic.line() == 0 ? "" : ":" + diagnostic.line();
        String column = diagnostic.column() == 0 ? "" : ":" + diagnostic.column();
        // further lines are set in, so that none of them passes for a line of the report
        String message = diagnostic.message().replace("\n", "\n    ");
        out.println(fileName + line + column + ": " + message);
    }

    private String language() {
        return texts.locale().getLanguage();
    }

    private void printCases(List<PublishedCase> cases) {
        if (cases.isEmpty()) return;
        out.println();
        var table =
                new TextTable(
                        texts.text("case"),
                        texts.text("verdict"),
                        texts.text("points"),
                        texts.text("compared"),
                        texts.text("message"));
        for (PublishedCase judged : cases) table.add(row(judged));
        table.lines().forEach(out::println);
        printRules(cases);
        printReasons(cases);
        for (PublishedCase judged : cases) printPicture(judged);
    }

    /**
     * Prints the rules by which answers are right, each once, with its cases where not all have it.
     */
    private void printRules(List<PublishedCase> cases) {
        Map<String, List<String>> titles = new LinkedHashMap<>();
        for (PublishedCase judged : cases)
            judged.rule()
                    .ifPresent(
                            rule ->
                                    titles.computeIfAbsent(rule, none -> new ArrayList<>())
                                            .add(judged.title()));
        if (!titles.isEmpty()) out.println();
        titles.forEach(
                (rule, of) ->
                        say(
                                "rule",
                                titles.size() == 1 ? rule : String.join(", ", of) + " – " + rule));
    }

    /** Prints why hidden cases are there, as far as that may be told. */
    private void printReasons(List<PublishedCase> cases) {
        if (cases.stream().anyMatch(judged -> judged.why().isPresent())) out.println();
        for (PublishedCase judged : cases)
            judged.why().ifPresent(why -> say("why", judged.title() + " – " + why));
    }

    private List<String> row(PublishedCase judged) {
        String verdict = judged.verdict().codeFor(judged.points(), judged.of());
        return List.of(
                judged.title(),
                GradingVerdict.word(verdict, language()),
                CaseReport.pointsOf(judged.points(), judged.of()),
                judged.tolerance().orElse(""),
                judged.message());
    }

    /** Prints the pictures, below the case's name, with which the names of their files begin. */
    private void printPicture(PublishedCase judged) {
        judged.pictures().stream()
                .filter(picture -> picture.kind().equals(CasePicture.DIFFERENCE))
                .findFirst()
                .ifPresent(
                        difference -> {
                            out.println();
                            String name = judged.name();
                            String title = judged.title();
                            out.println(title.equals(name) ? name : title + ", " + name);
                            lines(difference).forEach(out::println);
                        });
    }

    /** A difference of pixels as its rows, another one in words. */
    private Stream<String> lines(PublishedPicture difference) {
        List<String> rows = difference.rows();
        if (rows.isEmpty()) return difference.text().lines().map(line -> "  " + line);
        Stream<String> part =
                difference.part().filter(known -> !known.isWhole()).stream()
                        .map(known -> known.message().in(language()));
        return Stream.concat(
                Stream.of("(" + texts.text("legend") + ")"),
                Stream.concat(part, rows.stream()).map(line -> "  " + line));
    }
}
