package rasterlab.exercises.folder;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.StatementPicture;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.catalogue.FolderParts;
import rasterlab.exercises.formula.FormulaFaults;
import rasterlab.exercises.runner.SourceCheck;
import rasterlab.exercises.runner.TimingCheck;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Phrase;

/** Finds all that is wrong in one exercise's folder at once. */
public final class FolderCheck {
    private static final Pattern HINTS = Pattern.compile("(?m)^(?=##[ \\t])");

    /** Words that stand for a title in templates and are none. */
    private static final Set<String> PLACEHOLDERS = Set.of("TITLE", "НАЗВАНИЕ");

    private final Path folder;
    private final List<Phrase> faults = new ArrayList<>();

    private FolderCheck(Path folder) {
        this.folder = folder;
    }

    /**
     * All faults, each with its file, place and reason.
     *
     * @return none where the server takes the folder and its sources compile
     */
    public static List<Phrase> faults(Path folder) {
        FolderCheck check = new FolderCheck(folder);
        Catalogue.FolderReading read = Catalogue.read(folder);
        read.faults().stream().map(CatalogueException::phrase).forEach(check.faults::add);
        FolderParts parts = read.parts();
        check.checkTitles(parts.titles());
        parts.texts().forEach(check::checkHeading);
        parts.texts().forEach(check::checkFormulas);
        check.checkPictures(parts.pictures());
        check.checkSources(parts);
        read.exercise()
                .filter(one -> one.form() == Exercise.TaskKind.WRITE)
                .ifPresent(check::checkTiming);
        return List.copyOf(check.faults);
    }

    private void checkTitles(Map<String, String> titles) {
        titles.forEach(
                (language, title) -> {
                    if (isPlaceholder(title))
                        add("exercise.json", Phrase.of("folder.title", language, title));
                });
    }

    private void checkHeading(String file, String text) {
        text.lines()
                .filter(line -> line.startsWith("# ") && isPlaceholder(line.substring(2)))
                .forEach(line -> add(file, Phrase.of("folder.heading", line.substring(2).trim())));
    }

    /** Whether a title is the word that stands where a title is to be written. */
    private static boolean isPlaceholder(String title) {
        return PLACEHOLDERS.contains(title.trim());
    }

    /** Looks at each hint by itself, as it is shown. */
    private void checkFormulas(String file, String text) {
        Stream<String> shown =
                file.startsWith("hints.") ? HINTS.splitAsStream(text) : Stream.of(text);
        shown.flatMap(one -> FormulaFaults.in(one).stream())
                .map(one -> Phrase.of("folder.formula", one.source(), Phrase.of(one.mistake())))
                .forEach(fault -> add(file, fault));
    }

    /** Draws the pictures that are drawn, for an input may have no right answer. */
    private void checkPictures(List<StatementPicture> pictures) {
        for (StatementPicture one : pictures)
            try {
                one.content("en");
            } catch (IllegalArgumentException refused) {
                add(
                        one.file(),
                        Phrase.of(
                                "picture.broken",
                                one.file(),
                                Phrase.ofTheEngine(refused.getMessage())));
            }
    }

    private void checkSources(FolderParts parts) {
        parts.sources()
                .forEach((file, source) -> faults(parts, source).forEach(one -> add(file, one)));
    }

    /** The faults of a source; where its contract is unknown, only that it is not Java. */
    private static List<Diagnostic> faults(FolderParts parts, String source) {
        return parts.contract()
                .map(one -> new SourceCheck(one).faults(source))
                .orElseGet(() -> SourceCheck.mistakes(source));
    }

    private void checkTiming(Exercise exercise) {
        String file = folder.resolve("exercise.json").toString();
        TimingCheck.fault(exercise, file).ifPresent(faults::add);
    }

    private void add(String file, Diagnostic one) {
        String place = one.line() == 0 ? file : file + ":" + one.line();
        add(place, Phrase.of(one.explanation()));
    }

    private void add(String file, Phrase reason) {
        faults.add(Phrase.of("folder.at", folder.resolve(file).toString(), reason));
    }
}
