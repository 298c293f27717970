package rasterlab.app.cli;

import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Points;
import rasterlab.exercises.score.Report;

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

    void print(Exercise exercise, Report report) {
        Points points = report.points();
        say("exercise", exercise.title(language()));
        say("verdict", report.verdict().word(language()));
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
        int hidden = exercise.points().total() - points.of();
        if (hidden > 0)
            say(
                    "hidden",
                    String.format(
                            Locale.ROOT,
                            texts.text("hidden-line"),
                            hidden,
                            exercise.points().total()));
        if (report.nanosPerItem() > 0)
            say(
                    exercise.topic().equals("line") ? "cost" : "cost-each",
                    texts.text("cost-nanos", report.nanosPerItem()));
        say("isolation", report.isolation(language()));
        report.diagnostics().forEach(this::printDiagnostic);
        printCases(exercise, report.cases());
    }

    /** Prints one value with its name in the report's language. */
    void say(String key, String value) {
        out.println(texts.text(key) + ": " + value);
    }

    private void printDiagnostic(Diagnostic diagnostic) {
        String line = diagnostic.line() == 0 ? "" : ":" + diagnostic.line();
        String column = diagnostic.column() == 0 ? "" : ":" + diagnostic.column();
        // further lines are set in, so that none of them passes for a line of the report
        String message = diagnostic.message(language()).replace("\n", "\n    ");
        out.println(fileName + line + column + ": " + message);
    }

    private String language() {
        return texts.locale().getLanguage();
    }

    private void printCases(Exercise exercise, List<CaseReport> cases) {
        if (cases.isEmpty()) return;
        out.println();
        var table =
                new TextTable(
                        texts.text("case"),
                        texts.text("verdict"),
                        texts.text("points"),
                        texts.text("message"));
        for (CaseReport judged : cases) table.add(row(exercise, judged));
        table.lines().forEach(out::println);
        for (CaseReport judged : cases) printPicture(exercise, judged);
    }

    private List<String> row(Exercise exercise, CaseReport judged) {
        return List.of(
                exercise.caseTitle(judged.name(), language()),
                judged.verdict().word(language()),
                CaseReport.pointsOf(judged.points(), judged.of()),
                judged.message(language()));
    }

    /** Below the case's name too, with which the names of its picture files begin. */
    private void printPicture(Exercise exercise, CaseReport judged) {
        CasePicture.of(judged.pictures(), CasePicture.DIFFERENCE)
                .ifPresent(
                        difference -> {
                            out.println();
                            String name = judged.name();
                            String title = exercise.caseTitle(name, language());
                            out.println(title.equals(name) ? name : title + ", " + name);
                            lines(difference).forEach(out::println);
                        });
    }

    /** A difference of pixels as its rows, another one in words. */
    private Stream<String> lines(CasePicture difference) {
        List<String> rows = difference.rows();
        if (rows.isEmpty())
            return difference.text().in(language()).lines().map(line -> "  " + line);
        Stream<String> part =
                difference.part().filter(known -> !known.isWhole()).stream()
                        .map(known -> known.said().in(language()));
        return Stream.concat(
                Stream.of("(" + texts.text("legend") + ")"),
                Stream.concat(part, rows.stream()).map(line -> "  " + line));
    }
}
