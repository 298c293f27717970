package rasterlab.app.cli.exercise;

import java.nio.file.Path;
import picocli.CommandLine.Option;
import rasterlab.app.cli.console.Console;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.naming.Named;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** The exercises that a command works on. */
public final class ExercisesOption {
    @Option(
            names = "--exercises",
            paramLabel = "FOLDER",
            description =
                    "folder of your own exercises, each in a sub-folder; one named as a built-in one"
                            + " takes its place")
    private Path folder;

    /** Whether the user named a folder. */
    public boolean isGiven() {
        return folder != null;
    }

    /**
     * The built-in exercises and those of the folder; says which of these take a built-in one's
     * place.
     *
     * @throws Complaint naming the first fault of the folder
     */
    public Catalogue catalogue(Console console) {
        Catalogue builtIn = Catalogue.builtIn();
        if (folder == null) return builtIn;
        try {
            Catalogue all = builtIn.withFolder(folder);
            for (String id : all.replaced()) console.tell("replaced", id, folder);
            return all;
        } catch (CatalogueException e) {
            throw Complaint.badInput(e.in(console.language().code()));
        }
    }

    /** The exercise of that name, built-in or from the folder. */
    Exercise named(String id, Console console) {
        return named(id, catalogue(console));
    }

    /**
     * The exercise of that name.
     *
     * @throws Complaint listing all, if there is none
     */
    static Exercise named(String id, Catalogue catalogue) {
        if (!catalogue.ids().contains(id))
            throw Complaint.badInput(Named.unknown("exercise", id, catalogue.ids()));
        return catalogue.named(id);
    }
}
