package rasterlab.app.cli.exercise;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.PrettyJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.predicting.Sheet;
import rasterlab.exercises.predicting.SheetText;
import rasterlab.exercises.published.PublishedReport;
import rasterlab.exercises.runner.Judge;
import rasterlab.exercises.runner.JudgeSettings;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;

/** Grades a source on the exercise's open cases, as the server would. */
@Command(
        name = "check",
        mixinStandardHelpOptions = true,
        description = {
            "Checks a solution as the grading server would, on the public cases only.",
            "A failed case is drawn as text: # right, + extra, - missing, * repeated pixels.",
            "An exercise of kind break takes JSON inputs, on which it tries the faulty methods.",
            "For an exercise of kind predict it prints a sheet of questions; answered, it is the FILE."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:all public cases pass",
            "1:a case fails, or what was submitted was not accepted",
            "2:no such exercise, or the file cannot be read, or pictures cannot be written",
        },
        footer = {"", "Example: ./lab check line-bresenham Bresenham.java"})
public final class CheckCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(index = "0", paramLabel = "EXERCISE", description = "such as line-bresenham")
    private String exercise;

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "FILE",
            description =
                    "your Java source; your inputs (kind break) or answers (kind predict) as JSON")
    private Path file;

    @Option(
            names = "--seed",
            paramLabel = "NUMBER",
            description = "draws the questions of a sheet; by default every sheet is another one")
    private Long seed;

    @Option(
            names = "--out",
            paramLabel = "FOLDER",
            description = "where pictures of failed cases go; default: check-EXERCISE")
    private Path folder;

    @Option(
            names = "--json",
            description = "prints one JSON object, with the fields that the server's answer has")
    private boolean json;

    @Mixin private ExercisesOption exercises;

    public CheckCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        Exercise chosen = exercises.named(exercise, console);
        if (file == null || seed != null) return printSheet(chosen);
        String source = SourceFile.read(file);
        Path pictures = folder == null ? Path.of("check-" + chosen.id()) : folder;
        WholeFile.requireFolderWritable(pictures);
        Report report = graded(chosen, source);
        if (json) writeJson(chosen, report, pictures);
        else print(chosen, report, pictures);
        return report.verdict() == GradingVerdict.OK ? ExitCode.DONE : ExitCode.FOUND_WRONG;
    }

    private void print(Exercise chosen, Report report, Path pictures) {
        var text =
                new ReportText(
                        console.out(), console.language().texts(), file.getFileName().toString());
        text.print(chosen, report);
        if (CasePictureFiles.write(report, pictures, language()) > 0)
            text.say("pictures", pictures.toAbsolutePath().normalize().toString());
    }

    private void writeJson(Exercise chosen, Report report, Path pictures) throws IOException {
        CasePictureFiles.write(report, pictures, language());
        JsonGenerator out = PrettyJson.to(console.out());
        PublishedReport.of(
                        chosen,
                        report,
                        language(),
                        (judged, picture) ->
                                CasePictureFiles.place(pictures, judged, picture).toUri() + "")
                .write(out);
        out.writeRaw('\n');
        out.close();
    }

    /** Prints questions to be answered. */
    private int printSheet(Exercise chosen) {
        if (chosen.form() != TaskKind.PREDICT)
            throw Complaint.badInput(
                    file == null
                            ? "FILE is missing: a sheet is printed of exercises of kind predict alone"
                            : "--seed goes with exercises of kind predict alone");
        if (file != null)
            throw Complaint.badInput("--seed goes without FILE: an answered sheet has its own");
        if (seed != null && (seed < 0 || seed > Sheet.MOST_SEED))
            throw Complaint.badInput(
                    "--seed must be a whole number from 0 to " + Sheet.MOST_SEED + ", got " + seed);
        console.out()
                .print(
                        SheetText.open(
                                chosen, seed == null ? SheetText.freshSeed() : seed.longValue()));
        return ExitCode.DONE;
    }

    private Report graded(Exercise chosen, String source) {
        try (Judge judge = Judge.start(JudgeSettings.once())) {
            console.err().println(where(chosen, judge.isolation().name()));
            return judge.grade(
                    chosen, source, CaseSelection.open(), done -> showProgress(chosen, done));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw Complaint.gaveUp("interrupted");
        }
    }

    /** Where it is checked; how a program is shut in, where one of the student's runs. */
    private String where(Exercise chosen, String isolation) {
        return chosen.form() == TaskKind.WRITE
                ? console.language().texts().text("here", Report.isolationIn(language(), isolation))
                : console.language().texts().text("here.none");
    }

    /** Tells no verdict: a mistake that all cases share is known, and paid for once, at the end. */
    private void showProgress(Exercise chosen, CaseReport done) {
        String title = chosen.caseTitle(done.name(), language());
        console.err().println(console.language().texts().text("tried", title));
    }

    private String language() {
        return console.language().code();
    }
}
