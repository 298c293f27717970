package rasterlab.app.exercise;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.outcome.Complaint;
import rasterlab.exercises.Exercise;

/** The sources of all exercises as the user left them, kept on the disk where there is a folder. */
final class Sources implements AutoCloseable {
    private final Map<String, String> texts = new HashMap<>();
    private final Optional<Drafts> drafts;

    /**
     * @param drafts those on the disk; empty where sources end with the window
     */
    Sources(Optional<Drafts> drafts) {
        this.drafts = drafts;
    }

    /** The source of an exercise: what was typed, else what is on the disk, else its beginning. */
    String of(Exercise exercise) {
        return texts.computeIfAbsent(
                exercise.id(),
                id -> drafts.flatMap(kept -> kept.open(id)).orElse(Beginning.here(exercise)));
    }

    /** Takes a new source, and begins to write it to the disk. */
    void put(String exercise, String source) {
        texts.put(exercise, source);
        drafts.ifPresent(kept -> kept.save(exercise, source));
    }

    /** The drafts of an exercise that other windows wrote and that differ from its source. */
    List<DraftFile.Other> others(Exercise exercise) {
        String own = of(exercise);
        return drafts.map(kept -> kept.others(exercise.id(), own)).orElse(List.of());
    }

    /**
     * Keeps the source as it is among the other drafts, so that another can take its place; where
     * sources end with the window, only the editor's history has it.
     *
     * @throws IOException if it cannot be kept
     * @throws Complaint if it cannot be written
     */
    void keepBeside(Exercise exercise) throws IOException {
        if (drafts.isPresent()) drafts.get().keepBeside(exercise.id(), of(exercise));
    }

    /** Why the source is not on the disk; {@link Notice#NONE} where it is, or need not be. */
    Notice problem(String exercise) {
        String problem = drafts.map(kept -> kept.problem(exercise)).orElse("");
        return problem.isEmpty() ? Notice.NONE : Notice.of("draft.unsaved", problem);
    }

    /** The file of a source. */
    Optional<Path> path(String exercise) {
        return drafts.flatMap(kept -> kept.path(exercise));
    }

    /** The file of what was last said to an exercise's source. */
    Optional<Path> outcomePath(String exercise) {
        return drafts.flatMap(kept -> kept.outcomePath(exercise));
    }

    /** The sources that are not on the disk; tries once more to write them, and waits for that. */
    List<UnsavedDraft> unsaved() throws InterruptedException {
        return drafts.isPresent() ? drafts.get().unsaved() : List.of();
    }

    @Override
    public void close() {
        drafts.ifPresent(Drafts::close);
    }
}
