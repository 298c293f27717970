package rasterlab.exercises.folder;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Hint;
import rasterlab.exercises.Picture;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.formula.FormulaFaults;
import rasterlab.exercises.runner.SourceCheck;
import rasterlab.exercises.runner.TimingCheck;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Phrase;
import rasterlab.exercises.topic.TopicGradings;

/** Finds all that is wrong in one exercise's folder at once. */
public final class FolderCheck {
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
        Catalogue.Reading read = Catalogue.read(folder);
        read.faults().stream().map(CatalogueException::said).forEach(check.faults::add);
        read.exercise().ifPresent(check::checkFormulas);
        read.exercise().ifPresent(check::checkPictures);
        read.exercise()
                .filter(one -> one.form() == Exercise.Form.WRITE)
                .ifPresent(check::checkSources);
        return List.copyOf(check.faults);
    }

    private void checkFormulas(Exercise exercise) {
        new TreeMap<>(exercise.statement())
                .forEach((language, text) -> checkFormulas("statement." + language + ".md", text));
        for (Hint hint : exercise.hints())
            new TreeMap<>(hint.text())
                    .forEach((language, text) -> checkFormulas("hints." + language + ".md", text));
    }

    private void checkFormulas(String file, String text) {
        for (FormulaFaults.Fault one : FormulaFaults.in(text))
            add(file, Phrase.of("folder.formula", one.source(), Phrase.of(one.mistake())));
    }

    /** Draws the pictures that are drawn, for an input may have no right answer. */
    private void checkPictures(Exercise exercise) {
        for (Picture one : exercise.pictures().values())
            try {
                one.content();
            } catch (IllegalArgumentException refused) {
                add(
                        one.file(),
                        Phrase.of(
                                "picture.broken",
                                one.file(),
                                Phrase.ofTheEngine(refused.getMessage())));
            }
    }

    private void checkSources(Exercise exercise) {
        SourceCheck check = new SourceCheck(TopicGradings.of(exercise).contract());
        check.faults(exercise.starter()).forEach(one -> add("Starter.java", one));
        Optional<String> model = exercise.evidence().model();
        model.ifPresent(source -> check.faults(source).forEach(one -> add("Model.java", one)));
        String file = folder.resolve("exercise.json").toString();
        TimingCheck.fault(exercise, file).ifPresent(faults::add);
    }

    private void add(String file, Diagnostic one) {
        String place = one.line() == 0 ? file : file + ":" + one.line();
        add(place, Phrase.of(one.said()));
    }

    private void add(String file, Phrase reason) {
        faults.add(Phrase.of("folder.at", folder.resolve(file).toString(), reason));
    }
}
